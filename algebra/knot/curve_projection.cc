#include "algebra/knot/curve_projection.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "algebra/error.h"
#include "algebra/knot/curve_edges.h"

namespace tact::knot {
namespace {

using algebra::Rational;

// One strand of an intersection.
struct Passage {
  CurvePlace place;
  int other_edge = 0;
  size_t intersection = 0;
  bool over = false;
  int turn = 0;
};

class Finder {
 public:
  Finder(std::vector<SeenEdge> edges, int most_intersections)
      : edges_(std::move(edges)), most_passages_(2 * static_cast<size_t>(most_intersections)) {}

  std::variant<CurveProjection, CurveFault> Run() {
    std::vector<int> order(edges_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int e, int f) { return edge(e).low_right() < edge(f).low_right(); });
    for (size_t i = 0; i < order.size(); ++i) {
      const SeenEdge& e = edge(order[i]);
      for (size_t j = i + 1; j < order.size() && edge(order[j]).low_right() <= e.high_right(); ++j) {
        const SeenEdge& f = edge(order[j]);
        if (f.low_up() > e.high_up() || e.low_up() > f.high_up()) continue;
        Compare(std::min(order[i], order[j]), std::max(order[i], order[j]));
        if (passages_.size() > most_passages_) return CurveFault{CurveFaultKind::kTooManyIntersections, {}};
      }
    }
    SortPassages();
    if (fault_) return *fault_;
    return Projection();
  }

 private:
  const SeenEdge& edge(int e) const { return edges_[static_cast<size_t>(e)]; }

  void Blame(CurveFaultKind kind, std::vector<int> points) {
    CurveFault fault{kind, std::move(points)};
    if (!fault_ || std::tie(fault.kind, fault.points) < std::tie(fault_->kind, fault_->points))
      fault_ = std::move(fault);
  }

  void Compare(int e, int f) {
    const EdgePair pair = f == e + 1 ? CompareNeighbours(edge(e), edge(f)) : CompareEdges(edge(e), edge(f));
    const std::vector<int> four = {e + 1, e + 2, f + 1, f + 2};
    switch (pair.meeting) {
      case EdgeMeeting::kNone:
        return;
      case EdgeMeeting::kInSpace:
        return Blame(CurveFaultKind::kMeetsItself, four);
      case EdgeMeeting::kOverlap:
        return Blame(CurveFaultKind::kOverlap, four);
      case EdgeMeeting::kPointOfFirst:
        return Blame(CurveFaultKind::kPointOnEdge, {e + 1 + pair.point, f + 1, f + 2});
      case EdgeMeeting::kPointOfSecond:
        return Blame(CurveFaultKind::kPointOnEdge, {f + 1 + pair.point, e + 1, e + 2});
      case EdgeMeeting::kCrossing:
        const size_t intersection = passages_.size() / 2;
        passages_.push_back({{e + 1, pair.at_first}, f + 1, intersection, pair.first_over, pair.turn});
        passages_.push_back({{f + 1, pair.at_second}, e + 1, intersection, !pair.first_over, -pair.turn});
    }
  }

  // Along the rope; two at one place make a triple point.
  void SortPassages() {
    std::sort(passages_.begin(), passages_.end(), [](const Passage& a, const Passage& b) {
      return std::tie(a.place.edge, a.place.at, a.other_edge) <
             std::tie(b.place.edge, b.place.at, b.other_edge);
    });
    for (size_t i = 1; i < passages_.size(); ++i) {
      if (passages_[i].place != passages_[i - 1].place) continue;
      std::vector<int> edges = {passages_[i].place.edge, passages_[i - 1].other_edge,
                                passages_[i].other_edge};
      std::sort(edges.begin(), edges.end());
      std::vector<int> points;
      for (const int e : edges) points.insert(points.end(), {e, e + 1});
      Blame(CurveFaultKind::kTriplePoint, std::move(points));
    }
  }

  CurveProjection Projection() const {
    std::vector<int> sum(passages_.size() / 2, 0);  // of an intersection's two columns
    for (size_t i = 0; i < passages_.size(); ++i) sum[passages_[i].intersection] += static_cast<int>(i) + 1;
    PDataBuilder builder(static_cast<int>(passages_.size()));
    CurveProjection projection;
    projection.places.reserve(passages_.size());
    for (size_t i = 0; i < passages_.size(); ++i) {
      const Passage& passage = passages_[i];
      builder.Add(sum[passage.intersection] - static_cast<int>(i) - 1,
                  AttributeOf(passage.over, passage.turn));
      projection.places.push_back(passage.place);
    }
    projection.p = builder.Take();
    return projection;
  }

  std::vector<SeenEdge> edges_;
  size_t most_passages_;
  std::vector<Passage> passages_;
  std::optional<CurveFault> fault_;
};

std::optional<CurveFault> FindFaultOfCurve(const Curve& curve) {
  const int n = static_cast<int>(curve.size());
  if (n < 2) return CurveFault{CurveFaultKind::kTooFewPoints, {}};
  const auto same = std::adjacent_find(curve.begin(), curve.end());
  if (same != curve.end()) {
    const int i = static_cast<int>(same - curve.begin()) + 1;
    return CurveFault{CurveFaultKind::kRepeatedPoint, {i, i + 1}};
  }
  if (curve.front() == curve.back()) return CurveFault{CurveFaultKind::kClosed, {1, n}};
  return std::nullopt;
}

// "point 3", "points 3 and 4", of an edge "the edge of points 3 and 4"
std::string Edge(const std::vector<int>& points, size_t at) {
  return "that of points " + std::to_string(points[at]) + " and " + std::to_string(points[at + 1]);
}

}  // namespace

std::string CurveFault::what() const {
  const auto point = [&](size_t at) { return std::to_string(points[at]); };
  switch (kind) {
    case CurveFaultKind::kTooFewPoints:
      return "expected two points or more, got fewer";
    case CurveFaultKind::kRepeatedPoint:
      return "expected points that differ from those before them, got point " + point(1) + " where point " +
             point(0) + " is";
    case CurveFaultKind::kClosed:
      return "expected a rope with two ends, got a closed curve: point " + point(1) + " is where point " +
             point(0) + " is; without one of them it is cut open there";
    case CurveFaultKind::kMeetsItself:
      return "expected a rope that does not meet itself, got two edges with a point in common: " +
             Edge(points, 0) + ", " + Edge(points, 2);
    case CurveFaultKind::kVerticalEdge:
      return "expected edges that are seen as lines, got one along the view: " + Edge(points, 0);
    case CurveFaultKind::kOverlap:
      return "expected edges that are seen to cross, got two that cover each other: " + Edge(points, 0) +
             ", " + Edge(points, 2);
    case CurveFaultKind::kPointOnEdge:
      return "expected points that are seen beside the rope's other edges, got point " + point(0) +
             " on an edge: " + Edge(points, 1);
    case CurveFaultKind::kTriplePoint:
      return "expected two edges to be seen at an intersection, got three: " + Edge(points, 0) + ", " +
             Edge(points, 2) + ", " + Edge(points, 4);
    case CurveFaultKind::kTooManyIntersections:
      break;
  }
  return "expected at most " + std::to_string(kMostCurveIntersections) + " intersections, got more";
}

std::variant<CurveProjection, CurveFault> ProjectCurve(const Curve& curve, const algebra::Vector3& view,
                                                       int most_intersections) {
  if (view.IsZero()) throw PreconditionError("ProjectCurve: expected a view of some length, got zero");
  if (auto fault = FindFaultOfCurve(curve)) return *fault;
  std::vector<SeenEdge> edges = SeenEdges(curve, view);
  const auto vertical = std::find_if(edges.begin(), edges.end(), IsSeenAsPoint);
  if (vertical != edges.end()) {
    const int i = static_cast<int>(vertical - edges.begin()) + 1;
    return CurveFault{CurveFaultKind::kVerticalEdge, {i, i + 1}};
  }
  return Finder(std::move(edges), most_intersections).Run();
}

}  // namespace tact::knot
