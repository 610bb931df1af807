/// @file
/// Faces of a rope's diagram, traced by the rotation system that the attributes give.
/// Model   A dart is a segment with a direction along it. The face on a dart's left goes on, at the intersection that the
///         dart ends in, with the dart that leaves to the left; round an end of the rope it comes back along the same
///         segment. With c intersections there are c + 2 vertices (the ends are two) and 2c + 1 segments, so Euler's
///         formula gives c + 1 - 2g faces on the surface of genus g that the tracing builds: a sphere just if c + 1.
///         This departs from the thesis' knot graph (thesis_graphs.h), which leaves the first and last segment out, and needs
///         no search for faces [thesis, 5.1.3].
/// Cost    O(n).
#pragma once

#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::knot {

struct Dart {
  int segment = 1;      // from 1
  bool forward = true;  // away from the selective end

  friend bool operator==(const Dart&, const Dart&) = default;
  friend auto operator<=>(const Dart&, const Dart&) = default;
};

/// The next dart of the face on the left.
inline Dart NextDart(const PData& p, Dart d) {
  const int met = d.forward ? d.segment : d.segment - 1;  // the column at the dart's end
  if (met == 0 || met > p.columns()) return {d.segment, !d.forward};
  const int mate = p.sigma(met);
  const bool out_forward = (p.turn(met) > 0) == d.forward;  // the other strand's direction to the left
  return {out_forward ? mate + 1 : mate, out_forward};
}

/// The other side of the same segment.
inline Dart Opposite(Dart d) { return {d.segment, !d.forward}; }

class Faces {
 public:
  explicit Faces(const PData& p);

  int count() const { return static_cast<int>(faces_.size()); }
  /// The walk round a face with the face on its left, from its least dart: segments ascending, backward first.
  const std::vector<Dart>& walk(int face) const { return faces_[static_cast<size_t>(face)]; }
  /// The face on the dart's left, from 0; faces are numbered by their least darts.
  int left_of(Dart d) const { return face_of_[Index(d)]; }

 private:
  static size_t Index(Dart d) { return 2 * static_cast<size_t>(d.segment - 1) + (d.forward ? 1 : 0); }

  std::vector<std::vector<Dart>> faces_;
  std::vector<int> face_of_;
};

/// How many faces there are; allocates once.
int CountFaces(const PData& p);
/// Of the surface that the diagram fills: 0 for a diagram on a sphere.
int Genus(const PData& p);
inline bool IsPlanar(const PData& p) { return Genus(p) == 0; }

}  // namespace tact::knot
