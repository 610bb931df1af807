/// @file
/// Polyhedral convex cones in any dimension: half-space data, generators, faces, projection, membership.
/// Model   A cone is { x | A x >= 0, E x = 0 } and, as well, { L^T s + R^T t | t >= 0 } (Minkowski and Weyl).
///         A's rows are inequalities, E's equalities, L's lines, R's rays. The lineality space is its largest
///         linear subspace.
/// Shapes  every matrix has the ambient dimension as its number of columns; a vector is a row.
/// Exact   64-bit with overflow detection, GMP from the first overflow on; the answers never differ.
/// Errors  PreconditionError: a zero row among inequalities, equalities, lines or rays (the message names
///         it), or matrices of different widths.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "algebra/cone/row_set.h"
#include "algebra/exact/integer_matrix.h"

namespace tact::algebra {

struct HalfspaceCone {
  IntegerMatrix inequalities;
  IntegerMatrix equalities;

  HalfspaceCone() = default;
  /// { x | A x >= 0 }.
  explicit HalfspaceCone(IntegerMatrix a) : inequalities(std::move(a)), equalities(0, inequalities.columns) {}
  HalfspaceCone(IntegerMatrix a, IntegerMatrix e) : inequalities(std::move(a)), equalities(std::move(e)) {}
  size_t ambient_dimension() const { return inequalities.columns; }
  friend bool operator==(const HalfspaceCone& a, const HalfspaceCone& b) = default;
};

struct GeneratorCone {
  IntegerMatrix lines;
  IntegerMatrix rays;

  size_t ambient_dimension() const { return rays.columns; }
  friend bool operator==(const GeneratorCone& a, const GeneratorCone& b) = default;
};

/// What Generators gives: lines are a basis of the lineality space, rays the extreme rays modulo it, tight[k]
/// the inequalities that vanish on ray k (on the lines all of them do). Canonical: equal cones have equal
/// lines (reduced echelon form, primitive) and equal rays (primitive, zero at the lines' pivots, in
/// lexicographic order).
struct ConeGenerators {
  GeneratorCone cone;
  std::vector<RowSet> tight;

  size_t lineality_dimension() const { return cone.lines.rows; }
};

/// Double description [Motzkin et al. 1953] with the combinatorial adjacency test [Fukuda and Prodon 1996];
/// inequalities enter in their order. Cost: up to a cubic number of set comparisons in the rays of each
/// intermediate cone.
ConeGenerators Generators(const HalfspaceCone& cone);

/// The irredundant half-space data: equalities a basis in reduced echelon form, inequalities one a facet,
/// canonical as ConeGenerators is. Lines and rays may be redundant. These are the dual cone's generators.
HalfspaceCone Facets(const GeneratorCone& cone);

/// The same cone, canonical and irredundant.
GeneratorCone Canonical(const GeneratorCone& cone);

/// Of the linear hull.
size_t Dimension(const GeneratorCone& cone);
/// Of the lineality space; generators may be redundant.
size_t LinealityDimension(const GeneratorCone& cone);
/// The inequalities, of `inequalities` in all, that vanish on the whole cone, increasing.
std::vector<size_t> ImplicitEqualities(const ConeGenerators& generators, size_t inequalities);

/// A face: the inequalities that vanish on it, and the rays it has.
struct ConeFace {
  RowSet tight;
  std::vector<size_t> rays;
  size_t dimension = 0;
  friend bool operator==(const ConeFace& a, const ConeFace& b) = default;
};

/// Visits every intersection of some of the `tight` sets (that of none is all of 0 .. bound - 1) once. With
/// `tight` from Generators these are the faces, as a closure system [Kaibel and Pfetsch 2002]. The order is
/// lexicographic in the strings that have c for a row in the set and s for one outside, c before s: the
/// lineality space comes first, the whole cone last. The visitor sees the set and the indices of all members
/// of `tight` that contain it, and returns whether to go on. Returns whether the walk ran to its end. Cost:
/// at most `bound` filters of the list of tight sets a visit; no memory that grows with the number of visits.
using IntersectionVisitor = std::function<bool(const RowSet& set, std::span<const size_t> members)>;
bool VisitIntersections(std::span<const RowSet> tight, size_t bound, const IntersectionVisitor& visitor);

/// Every face once, in the order of VisitIntersections. `dimension` costs a rank a face.
std::vector<ConeFace> Faces(const ConeGenerators& generators, size_t inequalities);

/// { (x_c)_{c in coordinates} | x in cone }, in both forms, canonical.
struct ConeForms {
  GeneratorCone generators;
  HalfspaceCone facets;
};
ConeForms Project(const GeneratorCone& cone, std::span<const size_t> coordinates);
ConeForms Project(const HalfspaceCone& cone, std::span<const size_t> coordinates);

/// Where a vector violates half-space data: the row, and whether it is an equality.
struct ViolatedRow {
  size_t row = 0;
  bool equality = false;
  friend bool operator==(const ViolatedRow& a, const ViolatedRow& b) = default;
};
/// nullopt: x lies in the cone. Otherwise the first violated inequality, or else equality.
std::optional<ViolatedRow> FindViolatedRow(const HalfspaceCone& cone, std::span<const Integer> x);

/// x = sum of line_weights[i] lines[i] + sum of ray_weights[j] rays[j], with ray_weights >= 0.
struct Combination {
  std::vector<Rational> line_weights;
  std::vector<Rational> ray_weights;
};
/// normal . x < 0, normal . line = 0 and normal . ray >= 0 for all lines and rays.
struct SeparatingNormal {
  IntegerVector normal;
};
/// Whether x lies in the cone, with evidence either way. Generators may be redundant. Phase one of the
/// simplex method in integers with Bland's rule [Bland 1977]: it always ends.
std::variant<Combination, SeparatingNormal> FindCombination(const GeneratorCone& cone,
                                                            std::span<const Integer> x);

}  // namespace tact::algebra
