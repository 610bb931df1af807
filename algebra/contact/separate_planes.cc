#include "algebra/contact/separate_planes.h"

#include <algorithm>

namespace tact::algebra {
namespace {

class Search {
 public:
  Search(const ConvexPiece& moving, const ConvexPiece& fixed, const Rational& tolerance)
      : moving_(moving), fixed_(fixed), squared_tolerance_(tolerance * tolerance) {
    for (const ConvexPiece* piece : {&moving, &fixed}) {
      Rational longest(0);
      for (const Vector3& d : piece->directions) longest = std::max(longest, Dot(d, d));
      squared_reach_ = squared_reach_.sign() == 0 ? longest : std::min(squared_reach_, longest);
    }
  }

  std::vector<Vector3> Run() {
    // A half-space leaves no choice.
    const bool fixed_is_flat = fixed_.normals.size() == 1, moving_is_flat = moving_.normals.size() == 1;
    if (fixed_is_flat || moving_is_flat) {
      const Vector3 n = fixed_is_flat ? fixed_.normals[0] : -moving_.normals[0];
      if (squared_tolerance_.sign() > 0 || Separates(n)) planes_.push_back(n);
      return planes_;
    }
    for (const Vector3& n : fixed_.normals) Try(n);
    for (const Vector3& n : moving_.normals) Try(-n);
    for (const Vector3& a : fixed_.directions) {
      for (const Vector3& b : moving_.directions) {
        const Vector3 n = Cross(a, b);
        // Directions that are parallel as far as the tolerance can tell span no plane.
        if (Dot(n, n) <= squared_tolerance_ * std::max(Dot(a, a), Dot(b, b))) continue;
        Try(Primitive(n));
        Try(-Primitive(n));
      }
    }
    return planes_;
  }

 private:
  // Whether d reaches no farther than the tolerance to the side that n points to.
  bool Below(const Vector3& n, const Vector3& d) const {
    const Rational height = Dot(n, d);
    return height.sign() <= 0 || height * height <= squared_tolerance_ * Dot(n, n);
  }

  bool Separates(const Vector3& n) const {
    return std::all_of(fixed_.directions.begin(), fixed_.directions.end(),
                       [&](const Vector3& a) { return Below(n, a); }) &&
           std::all_of(moving_.directions.begin(), moving_.directions.end(),
                       [&](const Vector3& b) { return Below(n, -b); });
  }

  // Whether the planes differ by no more than twice the tolerance over the smaller piece.
  bool Same(const Vector3& n, const Vector3& other) const {
    const Vector3 c = Cross(n, other);
    return Dot(n, other).sign() > 0 &&
           Dot(c, c) * squared_reach_ <= Rational(4) * squared_tolerance_ * Dot(n, n) * Dot(other, other);
  }

  void Try(const Vector3& n) {
    if (!Separates(n)) return;
    if (std::none_of(planes_.begin(), planes_.end(), [&](const Vector3& p) { return Same(n, p); })) {
      planes_.push_back(n);
    }
  }

  const ConvexPiece& moving_;
  const ConvexPiece& fixed_;
  Rational squared_tolerance_;
  Rational squared_reach_;
  std::vector<Vector3> planes_;
};

}  // namespace

std::vector<Vector3> SeparatePlanes(const ConvexPiece& moving, const ConvexPiece& fixed,
                                    const Rational& tolerance) {
  return Search(moving, fixed, tolerance).Run();
}

}  // namespace tact::algebra
