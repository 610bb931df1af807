#include "enumerators/contact_additions.h"

#include <algorithm>

#include "enumerators/contact_sets.h"

namespace tact::enumerators {
namespace {

using algebra::Vector3;

class Finder {
 public:
  explicit Finder(const ContactWorld& world) : contacts_(world.contacts) {}

  std::vector<Addition> Run() {
    for (size_t i = 0; i < contacts_.size(); ++i) {
      found_.push_back({AdditionKind::kContact, {i}});
      for (size_t j = i + 1; j < contacts_.size(); ++j) {
        if (!SameNormal(i, j)) continue;
        found_.push_back({AdditionKind::kEdge, {i, j}});
        for (size_t k = j + 1; k < contacts_.size(); ++k) {
          if (SameNormal(i, k)) AddFaces(i, j, k);
        }
      }
    }
    std::sort(found_.begin(), found_.end(), [](const Addition& a, const Addition& b) {
      return a.kind != b.kind ? a.kind < b.kind : ComesBefore(a.contacts, b.contacts);
    });
    return std::move(found_);
  }

 private:
  bool SameNormal(size_t i, size_t j) const {
    const Vector3 &a = contacts_[i].planes[0], &b = contacts_[j].planes[0];
    return algebra::Parallel(a, b) && Dot(a, b).sign() > 0;
  }

  void AddFaces(size_t i, size_t j, size_t k) {
    if (Turn(i, j, k) == 0) return;
    found_.push_back({AdditionKind::kFace, {i, j, k}});
    for (size_t l = k + 1; l < contacts_.size(); ++l) {
      if (SameNormal(i, l) && IsConvex(i, j, k, l)) found_.push_back({AdditionKind::kFace, {i, j, k, l}});
    }
  }

  // Which way three lines of action turn, seen along their normal; zero if they lie in a plane.
  int Turn(size_t i, size_t j, size_t k) const {
    const Vector3& p = contacts_[i].point;
    return Dot(Cross(contacts_[j].point - p, contacts_[k].point - p), contacts_[i].planes[0]).sign();
  }

  // The turns of three of the four are, with signs in turn, the coefficients of the points' affine dependency: two of
  // each sign just if the points are in convex position.
  bool IsConvex(size_t i, size_t j, size_t k, size_t l) const {
    return Turn(i, j, k) * Turn(i, j, l) * Turn(i, k, l) * Turn(j, k, l) > 0;
  }

  const std::vector<algebra::Contact>& contacts_;
  std::vector<Addition> found_;
};

}  // namespace

std::string ToString(AdditionKind kind) {
  return kind == AdditionKind::kContact ? "contact" : kind == AdditionKind::kEdge ? "edge" : "face";
}

std::vector<Addition> Additions(const ContactWorld& world) { return Finder(world).Run(); }

}  // namespace tact::enumerators
