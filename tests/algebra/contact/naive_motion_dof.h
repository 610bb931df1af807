/// @file
/// Motion DOFs straight from the thesis' definitions: slow, short, and nothing in common with the engine.
/// Model   Whether a system of inequalities has a solution, and what its projection to the rotations is, is
///         found by Fourier-Motzkin elimination; the projection is { G w >= 0 } [thesis, eq. (2.6)].
/// Cost    doubly exponential in the number of rows: for a handful of contacts.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "algebra/contact/motion_dof.h"

namespace tact::algebra::naive {

using Row = std::vector<Rational>;
using Matrix = std::vector<Row>;

inline int Rank(Matrix m) {
  const size_t columns = m.empty() ? 0 : m[0].size();
  size_t rank = 0;
  for (size_t c = 0; c < columns && rank < m.size(); ++c) {
    size_t pivot = rank;
    while (pivot < m.size() && m[pivot][c].sign() == 0) ++pivot;
    if (pivot == m.size()) continue;
    std::swap(m[pivot], m[rank]);
    for (size_t i = rank + 1; i < m.size(); ++i) {
      const Rational factor = m[i][c] / m[rank][c];
      if (factor.sign() == 0) continue;
      for (size_t j = c; j < columns; ++j) m[i][j] -= factor * m[rank][j];
    }
    ++rank;
  }
  return static_cast<int>(rank);
}

/// row . x >= 0, or > 0 if strict.
struct Inequality {
  Row row;
  bool strict = false;
  friend bool operator==(const Inequality&, const Inequality&) = default;
  friend auto operator<=>(const Inequality&, const Inequality&) = default;
};

/// The first entry that is not zero becomes 1 or -1; a row of zeros stays.
inline void Normalise(Row& row) {
  const auto first = std::find_if(row.begin(), row.end(), [](const Rational& r) { return r.sign() != 0; });
  if (first == row.end()) return;
  const Rational scale = Abs(*first);
  for (Rational& r : row) r /= scale;
}

/// The projection along the last coordinate.
inline std::vector<Inequality> EliminateLast(const std::vector<Inequality>& system) {
  std::vector<Inequality> result;
  const auto add = [&result](Inequality inequality) {
    inequality.row.pop_back();
    Normalise(inequality.row);
    result.push_back(std::move(inequality));
  };
  for (const Inequality& a : system) {
    if (a.row.back().sign() == 0) add(a);
    if (a.row.back().sign() <= 0) continue;
    for (const Inequality& b : system) {
      if (b.row.back().sign() >= 0) continue;
      Inequality sum{a.row, a.strict || b.strict};
      for (size_t i = 0; i < sum.row.size(); ++i) {
        sum.row[i] = a.row[i] * -b.row.back() + b.row[i] * a.row.back();
      }
      add(std::move(sum));
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

inline std::vector<Inequality> Weak(const Matrix& m) {
  std::vector<Inequality> system;
  for (const Row& row : m) system.push_back({row, false});
  return system;
}

/// Whether some x has m x >= 0 and row i of m x positive.
inline bool CanBePositive(const Matrix& m, size_t i) {
  std::vector<Inequality> system = Weak(m);
  system[i].strict = true;
  for (size_t n = m[i].size(); n > 0; --n) system = EliminateLast(system);
  // What is left reads 0 >= 0 or 0 > 0.
  return std::none_of(system.begin(), system.end(), [](const Inequality& left) { return left.strict; });
}

/// Of { x | m x >= 0 } in n dimensions.
inline int Dimension(const Matrix& m, int n) {
  Matrix equalities;
  for (size_t i = 0; i < m.size(); ++i) {
    if (!CanBePositive(m, i)) equalities.push_back(m[i]);
  }
  return n - Rank(equalities);
}

/// Of the largest linear space in { x | m x >= 0 }.
inline int Lineality(const Matrix& m, int n) { return n - Rank(m); }

/// The G of [thesis, eq. (2.6)]: rows of the projection to the first three coordinates.
inline Matrix ProjectToRotations(const Matrix& m) {
  std::vector<Inequality> system = Weak(m);
  for (int i = 0; i < 3; ++i) system = EliminateLast(system);
  Matrix result;
  for (Inequality& inequality : system) result.push_back(std::move(inequality.row));
  return result;
}

/// Of the projection of { x | m x = 0 } to the first three coordinates: the rank of the angular parts of a
/// basis, found by solving for one pivot a row.
inline int KeptRotations(Matrix m) {
  std::vector<size_t> pivots;
  for (size_t c = 0; c < 6 && pivots.size() < m.size(); ++c) {
    const size_t top = pivots.size();
    size_t pivot = top;
    while (pivot < m.size() && m[pivot][c].sign() == 0) ++pivot;
    if (pivot == m.size()) continue;
    std::swap(m[pivot], m[top]);
    const Rational scale = m[top][c];
    for (Rational& r : m[top]) r /= scale;
    for (size_t i = 0; i < m.size(); ++i) {
      const Rational factor = m[i][c];
      for (size_t j = 0; i != top && j < 6; ++j) m[i][j] -= factor * m[top][j];
    }
    pivots.push_back(c);
  }
  Matrix angular_parts;
  for (size_t free = 0; free < 6; ++free) {
    if (std::find(pivots.begin(), pivots.end(), free) != pivots.end()) continue;
    Row solution(6);
    solution[free] = 1;
    for (size_t i = 0; i < pivots.size(); ++i) solution[pivots[i]] = -m[i][free];
    angular_parts.emplace_back(solution.begin(), solution.begin() + 3);
  }
  return Rank(angular_parts);
}

inline Matrix MotionRows(const ContactRelation& relation) {
  Matrix result;
  for (const Contact& contact : relation.contacts) {
    for (const Vector3& n : contact.planes) {
      const Vector3 moment = Cross(contact.point, n);
      result.push_back({moment.x, moment.y, moment.z, n.x, n.y, n.z});
    }
  }
  return result;
}

inline Matrix TranslationRows(const Matrix& motion_rows) {
  Matrix result;
  for (const Row& row : motion_rows) result.emplace_back(row.begin() + 3, row.end());
  return result;
}

inline MotionDof ComputeMotionDof(const ContactRelation& relation) {
  MotionDof dof;
  dof.singular = relation.singular();
  const Matrix a = MotionRows(relation.WithoutSingular());
  const Matrix n = TranslationRows(a);

  dof.all.maintaining = Lineality(a, 6);
  dof.all.constraining = 6 - Dimension(a, 6);
  dof.all.detaching = 6 - dof.all.maintaining - dof.all.constraining;

  dof.translation.maintaining = Lineality(n, 3);
  dof.translation.constraining = 3 - Dimension(n, 3);
  dof.translation.detaching = 3 - dof.translation.maintaining - dof.translation.constraining;

  const Matrix g = ProjectToRotations(a);
  RotationDof& rotation = dof.rotation;
  rotation.maintaining = KeptRotations(a);
  rotation.constraining = 3 - Dimension(g, 3);
  rotation.detaching = 3 - rotation.maintaining - rotation.constraining;
  rotation.detaching_type1 = Lineality(g, 3) - rotation.maintaining;
  rotation.detaching_type2 = rotation.detaching - rotation.detaching_type1;

  const Matrix every = MotionRows(relation);
  dof.all.restricted = Rank(every);
  dof.translation.restricted = Rank(TranslationRows(every));
  rotation.restricted = 3 - KeptRotations(every);
  return dof;
}

}  // namespace tact::algebra::naive
