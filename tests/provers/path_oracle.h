/// @file
/// Whether a `motion-path` certificate is right, by the engines: each pair of pieces followed along the path, its
/// planes' heights as exact quadratics, the contacts found in place. Part of certificate_oracle.h.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "algebra/contact/path_polynomial.h"
#include "algebra/contact/scene.h"
#include "algebra/error.h"
#include "algebra/solid/convex_hull.h"
#include "tests/provers/certificate_oracle.h"

namespace tact::provers::oracle {

using algebra::MotionPath;
using algebra::Quadratic;
using Points = std::vector<Vector3>;

inline std::optional<Rational> Fraction(const json& written) {
  const IntegerVector v = Integers(written);
  if (v[1].sign() <= 0) return std::nullopt;
  return Rational(v[0], v[1]);
}

/// The convex pieces, if each listed point is a corner of its hull.
inline std::optional<std::vector<Points>> Pieces(const json& written) {
  std::vector<Points> pieces;
  for (const json& list : written) {
    Points& piece = pieces.emplace_back();
    for (const json& corner : list) {
      const auto point = Point(corner);
      if (!point) return std::nullopt;
      piece.push_back(*point);
    }
    static std::map<Points, bool> known;
    const auto [corners, is_new] = known.try_emplace(piece);
    if (is_new) corners->second = algebra::ConvexHull(piece).points == piece;
    if (!corners->second) return std::nullopt;
  }
  return pieces;
}

inline std::optional<MotionPath> PathOf(const json& written) {
  const bool turns = written.contains("rotation");
  const auto vector = Point(turns ? written["rotation"]["axis"] : written["line"]);
  const auto center = turns ? Point(written["rotation"]["point"]) : Vector3{};
  if (!vector || !center) return std::nullopt;
  return turns ? MotionPath::Rotation(*center, *vector) : MotionPath::Line(*vector);
}

/// w(s) n . (X m - X b), of the moving corners, and n . (X b - f), of the fixed ones, or the same for a fixed b.
inline std::optional<std::vector<Quadratic>> Heights(const json& plane, const Points& moving,
                                                     const Points& fixed, const MotionPath& path) {
  const bool at_moving = plane["through"].contains("moving");
  const long long index = plane["through"][at_moving ? "moving" : "fixed"];
  const Points& bases = at_moving ? moving : fixed;
  if (index < 0 || index >= static_cast<long long>(bases.size())) return std::nullopt;
  const Vector3 base = bases[static_cast<size_t>(index)];
  const MotionPath back = Backwards(path);
  std::function<Quadratic(const Vector3&)> of_moving, of_fixed;  // up to a constant that is the same for all
  if (plane.contains("normal")) {
    const Vector3 n = Normal(plane["normal"]);
    of_moving = [=](const Vector3& m) { return HeightAlong(path, m, n, 0); };
    of_fixed = [=](const Vector3& f) { return Dot(n, f) * Weight(path); };
  } else if (plane.contains("carried")) {
    const Vector3 n = Normal(plane["carried"]);
    of_moving = [=](const Vector3& m) { return Dot(n, m) * Weight(path); };
    of_fixed = [=](const Vector3& f) { return HeightAlong(back, f, n, 0); };
  } else {
    std::vector<Vector3> ends;
    for (int which = 0; which < 2; ++which) {
      for (const long long i : plane["edges"][which].get<std::vector<long long>>()) {
        const Points& corners = which == 0 ? moving : fixed;
        if (i < 0 || i >= static_cast<long long>(corners.size())) return std::nullopt;
        ends.push_back(corners[static_cast<size_t>(i)]);
      }
    }
    const Vector3 d = ends[1] - ends[0], e = ends[3] - ends[2], zero{};
    of_moving = [=](const Vector3& m) { return MeetingAlong(path, m, d, zero, e); };
    of_fixed = [=](const Vector3& f) {
      return MeetingAlong(path, zero, d, zero, e) - MeetingAlong(path, zero, d, f, e);
    };
  }
  const Quadratic zero_height = at_moving ? of_moving(base) : of_fixed(base);
  std::vector<Quadratic> heights;
  for (const Vector3& m : moving) heights.push_back(of_moving(m) - zero_height);
  for (const Vector3& f : fixed) heights.push_back(zero_height - of_fixed(f));
  return heights;
}

/// From one s to the other each height is zero, or positive with the end left out; not all are zero, at the
/// path's end neither.
inline bool Separates(const std::vector<Quadratic>& heights, const Rational& from, const Rational& to) {
  bool strict = false, strict_at_end = to != Rational(1);
  for (const Quadratic& h : heights) {
    const Rational step = to - from;
    const Quadratic here{h.At(from), step * (h.c1 + Rational(2) * h.c2 * from), step * step * h.c2};
    if (h.IsZero()) continue;
    if (here.c0.sign() <= 0 || !RootsInside(here).empty()) return false;
    strict = true;
    strict_at_end = strict_at_end || h.At(1).sign() > 0;
  }
  return strict && strict_at_end;
}

inline bool PlanesAreRight(const json& planes, const Points& moving, const Points& fixed,
                           const MotionPath& path) {
  Rational from(0);
  for (const json& plane : planes) {
    const auto until = Fraction(plane["until"]);
    if (!until || *until <= from || *until > Rational(1)) return false;
    const auto heights = Heights(plane, moving, fixed, path);
    if (!heights || !Separates(*heights, from, *until)) return false;
    from = *until;
  }
  return from == Rational(1);
}

using PlaneSet = std::set<Vector3>;

/// As the certificate's contacts should be: point by point the sets of planes that include no other.
inline std::set<std::pair<Vector3, PlaneSet>> Minimal(const std::vector<algebra::Contact>& contacts) {
  std::set<std::pair<Vector3, PlaneSet>> all, kept;
  for (const auto& contact : contacts) {
    PlaneSet planes;
    for (const Vector3& n : contact.planes) planes.insert(Primitive(n));
    all.emplace(contact.point, planes);
  }
  for (const auto& [point, planes] : all) {
    bool least = true;
    for (const auto& [place, others] : all) {
      least = least && !(place == point && others.size() < planes.size() &&
                         std::includes(planes.begin(), planes.end(), others.begin(), others.end()));
    }
    if (least) kept.emplace(point, planes);
  }
  return kept;
}

/// The contacts of two pieces at a place of a path without events, else nothing; kept for the next call.
inline const std::optional<std::vector<algebra::Contact>>& Followed(const std::string& what,
                                                                    const Points& moving, const Points& fixed,
                                                                    const MotionPath& path,
                                                                    const Rational& place) {
  static std::map<std::string, bool> events;
  static std::map<std::string, std::optional<std::vector<algebra::Contact>>> known;
  const auto [contacts, is_new] = known.try_emplace(what + place.ToString());
  if (is_new) {
    const auto one = algebra::UnionOfHulls({moving}), other = algebra::UnionOfHulls({fixed});
    const auto [event, first] = events.try_emplace(what);
    if (first) event->second = FollowPath(one, other, path).event.has_value();
    if (!event->second)
      contacts->second = FindContacts(Transform(one, path.At(place)), other, 0).relation.contacts;
  }
  return contacts->second;
}

inline bool GeometryIsRight(const json& c) {
  const auto moving = Pieces(c["moving"]), fixed = Pieces(c["fixed"]);
  const auto path = PathOf(c["path"]);
  if (!moving || !fixed || !path) return false;
  std::vector<Rational> places;
  for (const json& s : c["at"]) {
    const auto place = Fraction(s);
    if (!place) return false;
    places.push_back(*place);
  }
  std::vector<Rational> ascending = places;
  if (places.back() < places.front()) std::reverse(ascending.begin(), ascending.end());
  if (!std::is_sorted(ascending.begin(), ascending.end(), std::less_equal<>()) ||
      ascending.front() != Rational(0) || ascending.back() != Rational(1)) {
    return false;
  }
  std::vector<std::vector<algebra::Contact>> found(places.size());
  for (size_t i = 0; i < moving->size(); ++i) {
    for (size_t j = 0; j < fixed->size(); ++j) {
      if (!PlanesAreRight(c["planes"][i][j], (*moving)[i], (*fixed)[j], *path)) return false;
      const std::string what = c["moving"][i].dump() + c["fixed"][j].dump() + c["path"].dump();
      for (size_t k = 0; k < places.size(); ++k) {
        const auto& here = Followed(what, (*moving)[i], (*fixed)[j], *path, places[k]);
        if (!here) return false;
        found[k].insert(found[k].end(), here->begin(), here->end());
      }
    }
  }
  for (size_t k = 0; k < places.size(); ++k) {
    const auto claimed = Contacts(c["relations"][k]["contacts"]);
    if (!claimed) return false;
    std::set<std::pair<Vector3, PlaneSet>> bare;
    for (const auto& contact : *claimed) {
      PlaneSet planes;
      for (const Vector3& n : contact.planes) planes.insert(Primitive(n));
      if (planes.size() != contact.planes.size() || !bare.emplace(contact.point, planes).second) return false;
    }
    if (bare != Minimal(found[k])) return false;
  }
  return true;
}

inline bool PathIsRight(const json& c) {
  if (!TransitionsAreRight(c)) return false;
  const size_t last = c["at"].size() - 1;
  const auto at_end = Fraction(c["at"][last]);
  const size_t end = at_end && *at_end == Rational(1) ? last : 0;
  for (size_t i = 0; i <= last; ++i) {
    if (i != end && c["relations"][i]["dof"] != c["relations"][end == 0 ? 1 : 0]["dof"]) return false;
  }
  try {
    return GeometryIsRight(c);
  } catch (const PreconditionError&) {
    return false;  // a flat piece, a zero axis
  }
}

}  // namespace tact::provers::oracle
