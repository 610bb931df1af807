#include "algebra/contact/approach.h"

#include <algorithm>
#include <optional>

#include "algebra/cone/complementary_pair.h"
#include "algebra/contact/contact_rows.h"
#include "algebra/contact/polynomial_vector.h"
#include "algebra/error.h"
#include "algebra/exact/linear_algebra.h"

namespace tact::algebra {
namespace {

// A point times its weight.
struct PointLaw {
  PolynomialVector point;
  Polynomial weight;
};

// What the path does to the moving solid's points and directions.
class Carrier {
 public:
  explicit Carrier(const MotionPath& path) : path_(path), turns_(path.kind == MotionPath::Kind::kRotation) {
    weight_ = {1};
    if (turns_) weight_ = {1, 0, Dot(path.vector, path.vector)};
  }

  // The direction, times a positive polynomial.
  PolynomialVector Direction(const Vector3& v) const {
    if (!turns_) return AsConstant(v);
    const Vector3& a = path_.vector;
    return FromCoefficients({v, Rational(2) * Cross(a, v), Rational(2) * Dot(a, v) * a - Dot(a, a) * v});
  }
  PointLaw Point(const Vector3& p) const {
    if (!turns_) return {FromCoefficients({p, path_.vector, {}}), weight_};
    return {weight_ * AsConstant(path_.center) + Direction(p - path_.center), weight_};
  }

 private:
  const MotionPath& path_;
  bool turns_;
  Polynomial weight_;
};

std::vector<size_t> EdgesAt(const Polyhedron& solid, const Element& element) {
  if (element.kind == ElementKind::kVertex) return solid.vertices[element.index].edges;
  if (element.kind == ElementKind::kEdge) return {element.index};
  return {};
}

std::vector<size_t> FacesAt(const Polyhedron& solid, const Element& element) {
  if (element.kind == ElementKind::kVertex) return solid.vertices[element.index].faces;
  if (element.kind == ElementKind::kEdge)
    return {solid.edges[element.index].left, solid.edges[element.index].right};
  return {element.index};
}

Vector3 Along(const Polyhedron& solid, size_t e) {
  return solid.vertices[solid.edges[e].head].point - solid.vertices[solid.edges[e].tail].point;
}

// A plane at a point, along the path.
struct PlaneLaw {
  PointLaw at;
  PolynomialVector normal;  // as the plane's, up to a positive factor

  // [ p x n | n ] up to a positive factor.
  std::array<PolynomialVector, 2> Row() const { return {Cross(at.point, normal), at.weight * normal}; }
};

class PlaneLaws {
 public:
  PlaneLaws(const Polyhedron& moving, const Polyhedron& fixed, const MotionPath& path)
      : moving_(moving), fixed_(fixed), path_(path), carrier_(path) {}

  PlaneLaw Of(const Vector3& normal, const std::pair<Element, Element>& elements) {
    return {Locate(elements), NormalLaw(normal, elements)};
  }

 private:
  PointLaw Locate(const std::pair<Element, Element>& elements) const {
    const auto& [m, f] = elements;
    if (m.kind == ElementKind::kVertex) return carrier_.Point(moving_.vertices[m.index].point);
    if (f.kind == ElementKind::kVertex) return {AsConstant(fixed_.vertices[f.index].point), {1}};
    if (m.kind != ElementKind::kEdge || f.kind != ElementKind::kEdge)
      throw InvariantError("a contact at " + ToString(m) + " and " + ToString(f));
    const PointLaw a = carrier_.Point(moving_.vertices[moving_.edges[m.index].tail].point);
    const PolynomialVector e = carrier_.Direction(Along(moving_, m.index));
    const PolynomialVector c = AsConstant(fixed_.vertices[fixed_.edges[f.index].tail].point),
                           g = AsConstant(Along(fixed_, f.index));
    const PolynomialVector n = Cross(e, g);
    const Polynomial square = Dot(n, n);
    return {square * a.point + Dot(Cross(a.weight * c - a.point, g), n) * e, square * a.weight};
  }

  PolynomialVector NormalLaw(const Vector3& normal, const std::pair<Element, Element>& elements) {
    std::vector<PolynomialVector> laws;
    const auto consider = [&](const PolynomialVector& law) {
      if (IsZero(law) || !Parallel(ValueAt(law, 1), normal)) return;
      const bool known = std::any_of(
          laws.begin(), laws.end(), [&](const PolynomialVector& other) { return IsZero(Cross(law, other)); });
      if (!known) laws.push_back(law);
    };
    for (const size_t f : FacesAt(fixed_, elements.second)) consider(AsConstant(fixed_.faces[f].normal));
    for (const size_t f : FacesAt(moving_, elements.first))
      consider(carrier_.Direction(moving_.faces[f].normal));
    for (const size_t e : EdgesAt(moving_, elements.first)) {
      for (const size_t g : EdgesAt(fixed_, elements.second))
        consider(Cross(carrier_.Direction(Along(moving_, e)), AsConstant(Along(fixed_, g))));
    }
    if (laws.size() > 1) KeepThoseAtHalf(elements, &laws);
    if (laws.size() != 1)
      throw InvariantError("the normal of " + ToString(elements.first) + " on " + ToString(elements.second));
    if (Dot(ValueAt(laws[0], 1), normal).sign() < 0) return Polynomial{-1} * laws[0];
    return laws[0];
  }

  // Several laws have one value at s = 1 by chance: look at s = 1/2 too.
  void KeepThoseAtHalf(const std::pair<Element, Element>& elements, std::vector<PolynomialVector>* laws) {
    const Rational half(1, 2);
    if (!at_half_) at_half_ = FindContacts(Transform(moving_, path_.At(half)), fixed_, 0);
    std::erase_if(*laws, [&](const PolynomialVector& law) {
      for (size_t i = 0; i < at_half_->elements.size(); ++i) {
        if (at_half_->elements[i] != elements) continue;
        for (const Vector3& plane : at_half_->relation.contacts[i].planes) {
          if (Parallel(ValueAt(law, half), plane)) return false;
        }
      }
      return true;
    });
  }

  const Polyhedron& moving_;
  const Polyhedron& fixed_;
  const MotionPath& path_;
  Carrier carrier_;
  std::optional<FoundContacts> at_half_;
};

// Combinations of the rows whose linear parts vanish span what constrains the axis directions.
std::vector<PolynomialVector> EliminateLinear(std::vector<std::array<PolynomialVector, 2>> rows) {
  for (size_t column = 0; column < 3; ++column) {
    auto pivot = rows.end();
    for (auto row = rows.begin(); row != rows.end(); ++row) {
      if ((*row)[1][column].empty()) continue;
      if (pivot == rows.end() || (*row)[1][column].size() < (*pivot)[1][column].size()) pivot = row;
    }
    if (pivot == rows.end()) continue;
    const auto chosen = *pivot;
    rows.erase(pivot);
    for (auto& row : rows) {
      if (row[1][column].empty()) continue;
      const Polynomial factor = row[1][column];
      for (size_t part = 0; part < 2; ++part)
        row[part] = chosen[1][column] * row[part] - factor * chosen[part];
    }
  }
  std::vector<PolynomialVector> angular;
  for (const auto& row : rows) angular.push_back(row[0]);
  return angular;
}

// The limit at s = 0 of the space that the rows span.
class LimitSpace {
 public:
  void Add(PolynomialVector row) {
    if (Depends(row)) return;
    while (true) {
      const auto combination = Combination(ValueAt(row, 0));
      if (!combination) break;
      for (size_t i = 0; i < rows_.size(); ++i) {
        for (size_t k = 0; k < 3; ++k) row[k] = AddTimes(row[k], -(*combination)[i], rows_[i][k]);
      }
      for (Polynomial& p : row) {
        if (!p.empty()) p.erase(p.begin());  // zero at s = 0: divided by s
      }
    }
    rows_.push_back(std::move(row));
  }

  IntegerMatrix Solutions() const { return NullSpace(Values()); }

 private:
  bool Depends(const PolynomialVector& row) const {
    if (rows_.empty()) return IsZero(row);
    if (rows_.size() == 1) return IsZero(Cross(rows_[0], row));
    return rows_.size() == 3 || Dot(Cross(rows_[0], rows_[1]), row).empty();
  }
  IntegerMatrix Values() const {
    std::vector<std::vector<Rational>> values;
    for (const PolynomialVector& row : rows_) {
      const Vector3 v = ValueAt(row, 0);
      values.push_back({v.x, v.y, v.z});
    }
    return IntegerMatrix::FromRationalRows(values, 3);
  }
  // How the value is made of the rows' values, if it is.
  std::optional<std::vector<Rational>> Combination(const Vector3& value) const {
    // Solve takes integers: unknowns belong to primitive rows, scaled back afterwards.
    const IntegerMatrix values = Values();
    const std::vector<Rational> target = {value.x, value.y, value.z};
    auto x = Solve(Transpose(values), target).x;
    if (!x) return std::nullopt;
    for (size_t i = 0; i < rows_.size(); ++i) {
      for (size_t k = 0; k < 3; ++k) {
        const Rational own = ValueAt(rows_[i][k], 0);
        if (own.sign() == 0) continue;
        (*x)[i] = (*x)[i] * Rational(values(i, k)) / own;
        break;
      }
    }
    return x;
  }

  std::vector<PolynomialVector> rows_;  // independent at s = 0
};

// The sum of a row's coefficients, made integers without a common factor, in absolute value.
Integer SizeOf(const std::array<PolynomialVector, 2>& row) {
  std::vector<Rational> coefficients;
  for (const PolynomialVector& part : row) {
    for (const Polynomial& p : part) coefficients.insert(coefficients.end(), p.begin(), p.end());
  }
  Integer sum = 0;
  for (const Integer& c : Primitive(coefficients)) sum += Abs(c);
  return sum;
}

// Below every positive root of every minor of the rows.
Rational NearTheEnd(const std::vector<std::array<PolynomialVector, 2>>& rows) {
  std::vector<Integer> sizes;
  for (const auto& row : rows) sizes.push_back(SizeOf(row));
  std::sort(sizes.rbegin(), sizes.rend());
  Integer bound = 2;
  for (size_t i = 0; i < std::min<size_t>(6, sizes.size()); ++i) bound *= sizes[i];
  return {1, bound};
}

std::vector<char> Vanishing(const std::vector<std::vector<Integer>>& rows, size_t columns) {
  IntegerMatrix matrix(0, columns);
  for (const auto& row : rows) matrix.AppendRow(std::span(row).last(columns));
  const ComplementaryPair pair = FindComplementaryPair(matrix.entries, static_cast<int>(columns));
  std::vector<char> vanishing;
  for (size_t i = 0; i < rows.size(); ++i) vanishing.push_back(pair.y[i].sign() > 0);
  return vanishing;
}

}  // namespace

Approach ApproachEnd(const Polyhedron& moving, const Polyhedron& fixed, const MotionPath& path,
                     const FoundContacts& contacts) {
  PlaneLaws laws(moving, fixed, path);
  std::vector<std::array<PolynomialVector, 2>> rows;  // of all planes, in their order
  std::vector<PlaneLaw> planes;
  for (size_t i = 0; i < contacts.elements.size(); ++i) {
    for (const Vector3& plane : contacts.relation.contacts[i].planes) {
      planes.push_back(laws.Of(plane, contacts.elements[i]));
      rows.push_back(planes.back().Row());
    }
  }
  const Rational s = NearTheEnd(rows);
  Approach result;
  std::vector<std::array<PolynomialVector, 2>> single;  // of non-singular contacts
  std::vector<std::vector<Integer>> values;             // likewise
  size_t next = 0;
  for (const Contact& contact : contacts.relation.contacts) {
    Contact& near = result.relation.contacts.emplace_back();
    near.name = contact.name;
    const PointLaw& at = planes[next].at;
    near.point = Rational(1) / ValueAt(at.weight, s) * ValueAt(at.point, s);
    for (size_t k = 0; k < contact.planes.size(); ++k)
      near.planes.push_back(algebra::Primitive(ValueAt(planes[next + k].normal, s)));
    if (!contact.singular()) {
      single.push_back(rows[next]);
      values.push_back(ContactRow(near.point, near.planes[0]));
    }
    next += contact.planes.size();
  }
  for (const size_t columns : {size_t{3}, size_t{6}}) {
    DirectionFiltration& filtration = result.directions[columns == 3 ? 0 : 1];
    filtration.singular = contacts.relation.singular();
    const std::vector<char> vanishing = Vanishing(values, columns);
    for (size_t step = 0; step < 2; ++step) {
      std::vector<std::array<PolynomialVector, 2>> chosen;
      for (size_t i = 0; i < single.size(); ++i) {
        if (step == 0 || vanishing[i] != 0) chosen.push_back(single[i]);
      }
      LimitSpace limit;
      if (columns == 3) {
        for (const auto& row : chosen) limit.Add(row[1]);
      } else {
        for (const auto& row : EliminateLinear(chosen)) limit.Add(row);
      }
      filtration.spaces[step] = limit.Solutions();
    }
  }
  return result;
}

}  // namespace tact::algebra
