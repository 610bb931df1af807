#include "algebra/knot/faces.h"

namespace tact::knot {

Faces::Faces(const PData& p) : face_of_(2 * static_cast<size_t>(p.segments()), -1) {
  for (int segment = 1; segment <= p.segments(); ++segment) {
    for (const bool forward : {false, true}) {
      const Dart first{segment, forward};
      if (left_of(first) >= 0) continue;
      std::vector<Dart> walk;
      for (Dart d = first; left_of(d) < 0; d = NextDart(p, d)) {
        face_of_[Index(d)] = count();
        walk.push_back(d);
      }
      faces_.push_back(std::move(walk));
    }
  }
}

int CountFaces(const PData& p) {
  std::vector<bool> seen(2 * static_cast<size_t>(p.segments()));
  const auto index = [](Dart d) { return 2 * static_cast<size_t>(d.segment - 1) + (d.forward ? 1 : 0); };
  int faces = 0;
  for (size_t i = 0; i < seen.size(); ++i) {
    if (seen[i]) continue;
    ++faces;
    for (Dart d{static_cast<int>(i / 2) + 1, i % 2 == 1}; !seen[index(d)]; d = NextDart(p, d))
      seen[index(d)] = true;
  }
  return faces;
}

int Genus(const PData& p) { return (p.crossings() + 1 - CountFaces(p)) / 2; }

}  // namespace tact::knot
