#include "algebra/contact/contact_rows.h"

#include <array>
#include <numeric>
#include <string>

#include "algebra/cone/dual_simplex.h"
#include "algebra/error.h"

namespace tact::algebra {
namespace {

using Number = SimplexNumber<int64_t>;

// Points and normals beyond this go the long way.
constexpr int64_t kSmallEntry = int64_t{1} << 40;

// v * scale as integers, scale the positive least common denominator; false if anything is large.
bool SmallHomogeneous(const Vector3& v, std::array<int64_t, 3>& out, int64_t& scale) {
  scale = 1;
  for (int i = 0; i < 3; ++i) {
    if (!v[i].numerator().is_small() || !v[i].denominator().is_small()) return false;
    const int64_t d = v[i].denominator().small();
    if (d == 1) continue;
    const Int128 next = static_cast<Int128>(scale / std::gcd(scale, d)) * d;
    if (next > kSmallEntry) return false;
    scale = static_cast<int64_t>(next);
  }
  for (int i = 0; i < 3; ++i) {
    const Int128 entry = static_cast<Int128>(v[i].numerator().small()) * (scale / v[i].denominator().small());
    if (entry > kSmallEntry || entry < -kSmallEntry) return false;
    out[i] = static_cast<int64_t>(entry);
  }
  return true;
}

bool SmallRow(const std::array<int64_t, 3>& p, int64_t w, const std::array<int64_t, 3>& n, int64_t* row) {
  const std::array<Int128, 6> wide = {Number::Multiply(p[1], n[2]) - Number::Multiply(p[2], n[1]),
                                      Number::Multiply(p[2], n[0]) - Number::Multiply(p[0], n[2]),
                                      Number::Multiply(p[0], n[1]) - Number::Multiply(p[1], n[0]),
                                      Number::Multiply(w, n[0]),
                                      Number::Multiply(w, n[1]),
                                      Number::Multiply(w, n[2])};
  int64_t common = 0;
  for (int i = 0; i < 6; ++i) {
    if (!Number::Narrow(wide[i], row[i])) return false;
    if (common != 1 && row[i] != 0) common = std::gcd(common, row[i]);
  }
  if (common > 1) {
    for (int i = 0; i < 6; ++i) row[i] /= common;
  }
  return true;
}

void RequirePlanes(const Contact& contact, size_t index) {
  if (contact.planes.empty()) {
    throw PreconditionError("contact " + std::to_string(index + 1) + " has no separate plane");
  }
  for (const Vector3& normal : contact.planes) {
    if (normal.IsZero())
      throw PreconditionError("contact " + std::to_string(index + 1) + " has a zero normal");
  }
}

}  // namespace

std::vector<Integer> ContactRow(const Vector3& point, const Vector3& normal) {
  const Vector3 torque = Cross(point, normal);
  Integer scale(1);
  for (const Rational* q : {&torque.x, &torque.y, &torque.z, &normal.x, &normal.y, &normal.z}) {
    scale *= DivideExactly(q->denominator(), Gcd(scale, q->denominator()));
  }
  std::vector<Integer> row;
  Integer common(0);
  for (const Rational* q : {&torque.x, &torque.y, &torque.z, &normal.x, &normal.y, &normal.z}) {
    row.push_back(q->numerator() * DivideExactly(scale, q->denominator()));
    common = Gcd(common, row.back());
  }
  for (Integer& entry : row) entry = DivideExactly(entry, common);
  return row;
}

void ContactRows::Assign(const ContactRelation& relation) {
  is_small_ = true;
  singular_ = false;
  small_.clear();
  contact_of_row_.clear();
  single_.clear();
  for (size_t i = 0; i < relation.contacts.size(); ++i) {
    const Contact& contact = relation.contacts[i];
    RequirePlanes(contact, i);
    singular_ = singular_ || contact.singular();
    std::array<int64_t, 3> p{}, n{};
    int64_t w = 1, unused = 1;
    if (is_small_) is_small_ = SmallHomogeneous(contact.point, p, w);
    for (const Vector3& normal : contact.planes) {
      contact_of_row_.push_back(i);
      single_.push_back(contact.singular() ? 0 : 1);
      if (!is_small_) continue;
      small_.resize(small_.size() + 6);
      is_small_ = SmallHomogeneous(normal, n, unused) && SmallRow(p, w, n, small_.data() + small_.size() - 6);
    }
  }
  if (!is_small_) AssignLarge(relation);
}

void ContactRows::AssignLarge(const ContactRelation& relation) {
  large_.clear();
  bool fits = true;
  for (const Contact& contact : relation.contacts) {
    for (const Vector3& normal : contact.planes) {
      for (const Integer& entry : ContactRow(contact.point, normal)) {
        fits = fits && entry.bits() < 60;
        large_.push_back(entry);
      }
    }
  }
  if (!fits) return;
  is_small_ = true;
  small_.clear();
  for (const Integer& entry : large_) small_.push_back(entry.small());
}

std::vector<Integer> ContactRows::ToIntegers() const {
  if (!is_small_) return large_;
  std::vector<Integer> result;
  result.reserve(small_.size());
  for (const int64_t entry : small_) result.emplace_back(static_cast<long>(entry));
  return result;
}

}  // namespace tact::algebra
