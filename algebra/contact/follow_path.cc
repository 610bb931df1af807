#include <algorithm>
#include <set>

#include "algebra/contact/motion_path.h"
#include "algebra/contact/path_polynomial.h"

namespace tact::algebra {
namespace {

using Pair = std::pair<Element, Element>;

std::string Named(const Pair& pair) {
  return "moving " + ToString(pair.first) + " and fixed " + ToString(pair.second);
}

// Signs of one element's vertices on one plane.
struct Spread {
  int least = 1, most = -1;
  void Add(int sign) {
    least = std::min(least, sign);
    most = std::max(most, sign);
  }
  bool Below(const Spread& other) const {
    return most <= 0 && other.least >= 0 && (most < 0 || other.least > 0);
  }
};

// One solid as the other one sees it: its vertices' heights over the other's planes along the path.
struct Traveller {
  const Polyhedron& solid;
  const Polyhedron& other;
  std::vector<std::vector<Quadratic>> heights;  // [vertex][face of the other]
  std::vector<std::vector<int>> own;            // sign of [vertex] on [face] of the solid itself
  std::vector<BoundingBox> vertex_boxes, edge_boxes;

  Traveller(const Polyhedron& moving, const Polyhedron& standing, const MotionPath& path)
      : solid(moving), other(standing) {
    for (const Vertex& v : solid.vertices) {
      auto& over = heights.emplace_back();
      for (const Face& f : other.faces) over.push_back(HeightAlong(path, v.point, f.normal, f.offset));
      auto& signs = own.emplace_back();
      for (const Face& f : solid.faces) signs.push_back((Dot(f.normal, v.point) - f.offset).sign());
      vertex_boxes.push_back(SweptBox(path, v.point));
    }
    for (const Edge& e : solid.edges) {
      edge_boxes.push_back(vertex_boxes[e.tail]);
      edge_boxes.back().Add(vertex_boxes[e.head]);
    }
  }
};

std::vector<size_t> VerticesOf(const Polyhedron& solid, const Element& element) {
  if (element.kind == ElementKind::kVertex) return {element.index};
  if (element.kind == ElementKind::kEdge)
    return {solid.edges[element.index].tail, solid.edges[element.index].head};
  std::vector<size_t> all;
  for (const auto& loop : solid.faces[element.index].loops) all.insert(all.end(), loop.begin(), loop.end());
  return all;
}

// Whether a face's plane of `held`'s own solid keeps the element of the traveller apart from the held one.
bool OwnPlaneSeparates(const Traveller& traveller, const std::vector<size_t>& element, const Traveller& held,
                       const std::vector<size_t>& held_element, const QuadraticRoot& s) {
  for (size_t f = 0; f < traveller.other.faces.size(); ++f) {
    Spread own;
    for (const size_t v : held_element) own.Add(held.own[v][f]);
    if (own.least < 0 && own.most > 0) continue;
    Spread others;
    for (const size_t v : element) others.Add(SignAt(traveller.heights[v][f], s));
    if (own.Below(others) || others.Below(own)) return true;
  }
  return false;
}

class Follower {
 public:
  Follower(const Polyhedron& moving, const Polyhedron& fixed, const MotionPath& path)
      : moving_(moving),
        fixed_(fixed),
        path_(path),
        forth_(moving, fixed, path),
        back_(fixed, moving, Backwards(path)) {}

  PathContacts Run() {
    CollectEvents();
    PathContacts result{{}, Find(0), Find({1, 2}), Find(1)};
    result.event = Decide(result);
    return result;
  }

 private:
  struct Event {
    QuadraticRoot parameter;
    Pair elements;
  };

  FoundContacts Find(const Rational& s) const {
    return FindContacts(Transform(moving_, path_.At(s)), fixed_, Rational(0));
  }

  void CollectEvents() {
    const std::vector<BoundingBox> fixed_boxes = FaceBoxes(fixed_), moving_boxes = FaceBoxes(moving_);
    for (size_t v = 0; v < moving_.vertices.size(); ++v) {
      for (size_t f = 0; f < fixed_.faces.size(); ++f) {
        if (forth_.vertex_boxes[v].Overlaps(fixed_boxes[f]))
          Collect(forth_.heights[v][f], {{ElementKind::kVertex, v}, {ElementKind::kFace, f}});
      }
    }
    for (size_t v = 0; v < fixed_.vertices.size(); ++v) {
      for (size_t f = 0; f < moving_.faces.size(); ++f) {
        if (back_.vertex_boxes[v].Overlaps(moving_boxes[f]))
          Collect(back_.heights[v][f], {{ElementKind::kFace, f}, {ElementKind::kVertex, v}});
      }
    }
    for (size_t e = 0; e < moving_.edges.size(); ++e) {
      const Vector3 &a = moving_.vertices[moving_.edges[e].tail].point,
                    &b = moving_.vertices[moving_.edges[e].head].point;
      for (size_t g = 0; g < fixed_.edges.size(); ++g) {
        BoundingBox edge = BoxOf(fixed_.vertices[fixed_.edges[g].tail].point);
        edge.Add(fixed_.vertices[fixed_.edges[g].head].point);
        if (!forth_.edge_boxes[e].Overlaps(edge)) continue;
        const Vector3 &c = fixed_.vertices[fixed_.edges[g].tail].point,
                      &d = fixed_.vertices[fixed_.edges[g].head].point;
        Collect(MeetingAlong(path_, a, b - a, c, d - c), {{ElementKind::kEdge, e}, {ElementKind::kEdge, g}});
      }
    }
    std::stable_sort(events_.begin(), events_.end(),
                     [](const Event& a, const Event& b) { return Compare(a.parameter, b.parameter) < 0; });
  }

  void Collect(const Quadratic& polynomial, const Pair& pair) {
    if (polynomial.IsZero()) return;
    for (const QuadraticRoot& root : RootsInside(polynomial)) {
      if (!Apart(pair, root)) events_.push_back({root, pair});
    }
  }

  bool Apart(const Pair& pair, const QuadraticRoot& s) const {
    const auto moving = VerticesOf(moving_, pair.first), fixed = VerticesOf(fixed_, pair.second);
    return OwnPlaneSeparates(forth_, moving, back_, fixed, s) ||
           OwnPlaneSeparates(back_, fixed, forth_, moving, s);
  }

  std::optional<PathEvent> Decide(const PathContacts& found) const {
    if (found.start.penetration) return Penetrates(0, *found.start.penetration);
    for (const Event& event : events_) {
      if (event.parameter.is_rational()) continue;
      return PathEvent{event.parameter, event.elements,
                       Named(event.elements) + " may touch at s = " + ToString(event.parameter) + ", about " +
                           std::to_string(ToDouble(event.parameter)) +
                           ", which is irrational: choose another motion"};
    }
    // Samples at 0, between the events, at each event, in ascending order; all are to agree.
    std::vector<Rational> events = {0};
    for (const Event& event : events_) {
      if (event.parameter.center != events.back()) events.push_back(event.parameter.center);
    }
    for (size_t i = 0; i < events.size(); ++i) {
      const Rational next = i + 1 < events.size() ? events[i + 1] : Rational(1);
      const Rational between = Rational(1, 2) * (events[i] + next);
      if (i > 0) {
        if (auto event = Differs(found, events[i], events[i])) return event;
      }
      if (auto event = Differs(found, between, events[i])) return event;
    }
    if (found.end.penetration) return Penetrates(1, *found.end.penetration);
    return std::nullopt;
  }

  static PathEvent Penetrates(const Rational& s, const Penetration& penetration) {
    return {
        {s, 0, 0},
        std::nullopt,
        "the solids penetrate one another at s = " + s.ToString() + ", at " + ToString(penetration.where)};
  }

  // What is wrong with the sample at s, if something is, is due to the event at `due`.
  std::optional<PathEvent> Differs(const PathContacts& found, const Rational& s, const Rational& due) const {
    const FoundContacts here = s == Rational(1, 2) ? found.middle : Find(s);
    const auto blame = [&](PathEvent wrong) {
      for (const Event& event : events_) {
        if (event.parameter.center != due || wrong.elements) continue;
        wrong.elements = event.elements;
        wrong.what += "; " + Named(event.elements) + " touch at s = " + due.ToString();
      }
      wrong.parameter = {due, 0, 0};
      return wrong;
    };
    if (here.penetration) return blame(Penetrates(s, *here.penetration));
    const FoundContacts& start = found.start;
    const std::set<Pair> before(start.elements.begin(), start.elements.end());
    const std::set<Pair> now(here.elements.begin(), here.elements.end());
    if (before == now && start.elements.size() == here.elements.size()) return std::nullopt;
    PathEvent wrong{{s, 0, 0}, std::nullopt, ""};
    for (const auto* one : {&before, &now}) {
      for (const Pair& pair : *one) {
        if ((one == &before ? now : before).count(pair) != 0 || wrong.elements) continue;
        wrong.elements = pair;
        wrong.what =
            Named(pair) +
            (one == &before ? " touch at s = 0, but not at s = " : " do not touch at s = 0, but do at s = ") +
            s.ToString();
      }
    }
    if (!wrong.elements) wrong.what = "fewer or more contacts at s = " + s.ToString() + " than at s = 0";
    return blame(wrong);
  }

  const Polyhedron& moving_;
  const Polyhedron& fixed_;
  MotionPath path_;
  Traveller forth_, back_;
  std::vector<Event> events_;
};

}  // namespace

PathContacts FollowPath(const Polyhedron& moving, const Polyhedron& fixed, const MotionPath& path) {
  return Follower(moving, fixed, path).Run();
}

}  // namespace tact::algebra
