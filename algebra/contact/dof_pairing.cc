#include "algebra/contact/dof_pairing.h"

#include "algebra/cone/complementary_pair.h"
#include "algebra/contact/contact_rows.h"
#include "algebra/exact/linear_algebra.h"

namespace tact::algebra {
namespace {

constexpr size_t kSteps = 3;  // maintaining, legal, all

size_t Dimension(const DirectionFiltration& filtration, size_t step) {
  return step == 0 ? 0 : (step < kSteps ? filtration.spaces[step - 1].rows : 3);
}

IntegerMatrix VanishingRows(const IntegerMatrix& rows) {
  const ComplementaryPair pair = FindComplementaryPair(rows.entries, static_cast<int>(rows.columns));
  std::vector<size_t> vanishing;
  for (size_t i = 0; i < rows.rows; ++i) {
    if (pair.y[i].sign() > 0) vanishing.push_back(i);
  }
  return SelectRows(rows, vanishing);
}

// The space of motions on which the rows vanish, as directions of translation, or of axes.
IntegerMatrix Directions(const IntegerMatrix& rows) {
  const IntegerMatrix space = NullSpace(rows);
  if (rows.columns == 3) return space;
  const std::vector<size_t> angular = {0, 1, 2};
  return RowSpace(SelectColumns(space, angular)).vectors;
}

size_t CommonDimension(const DirectionFiltration& a, size_t i, const DirectionFiltration& b, size_t j) {
  if (i == 0 || j == 0) return 0;
  if (i == kSteps) return Dimension(b, j);
  if (j == kSteps) return Dimension(a, i);
  IntegerMatrix both = a.spaces[i - 1];
  both.AppendRows(b.spaces[j - 1]);
  return Dimension(a, i) + Dimension(b, j) - Rank(both);
}

}  // namespace

DirectionFiltration FilterDirections(const ContactRelation& relation, Motion motion) {
  const size_t columns = motion == Motion::kTranslation ? 3 : 6;
  IntegerMatrix rows(0, columns);
  for (const Contact& contact : relation.WithoutSingular().contacts) {
    const std::vector<Integer> row = ContactRow(contact.point, contact.planes[0]);
    rows.AppendRow(std::span(row).last(columns));
  }
  return {{Directions(rows), Directions(VanishingRows(rows))}, relation.singular()};
}

DofPairing PairByDirection(const ContactRelation& before, const ContactRelation& after, Motion motion) {
  return PairByDirection(FilterDirections(before, motion), FilterDirections(after, motion));
}

DofPairing PairByDirection(const DirectionFiltration& a, const DirectionFiltration& b) {
  DofPairing pairing{};
  for (size_t i = 1; i <= kSteps; ++i) {
    for (size_t j = 1; j <= kSteps; ++j) {
      const size_t count = CommonDimension(a, i, b, j) + CommonDimension(a, i - 1, b, j - 1) -
                           CommonDimension(a, i - 1, b, j) - CommonDimension(a, i, b, j - 1);
      pairing[i - 1 + (a.singular ? kSteps : 0)][j - 1 + (b.singular ? kSteps : 0)] = static_cast<int>(count);
    }
  }
  return pairing;
}

std::vector<DofTransition> DofTransitionsByDirection(const ContactRelation& before,
                                                     const ContactRelation& after) {
  std::vector<DofTransition> transitions;
  for (const Motion motion : {Motion::kTranslation, Motion::kRotation}) {
    const DofPairing pairing = PairByDirection(before, after, motion);
    for (int from = 0; from < kDofIndices; ++from) {
      for (int to = 0; to < kDofIndices; ++to) {
        if (from == to || pairing[from][to] == 0) continue;
        transitions.push_back({motion, static_cast<DofIndex>(from), static_cast<DofIndex>(to)});
      }
    }
  }
  return transitions;
}

std::vector<DofTransition> ForcedDofTransitions(const MotionDof& before, const MotionDof& after) {
  std::vector<DofTransition> transitions;
  for (const Motion motion : {Motion::kTranslation, Motion::kRotation}) {
    const auto a = Indices(before, motion), b = Indices(after, motion);
    int total = 0;
    for (int i = 0; i < kDofIndices; ++i) total += a[i] > b[i] ? a[i] - b[i] : 0;
    for (int from = 0; from < kDofIndices; ++from) {
      for (int to = 0; to < kDofIndices; ++to) {
        // What falls at `from` can go elsewhere only into what rises elsewhere.
        const int fall = a[from] - b[from], rise = b[to] - a[to];
        if (fall > 0 && rise > 0 && fall + rise > total)
          transitions.push_back({motion, static_cast<DofIndex>(from), static_cast<DofIndex>(to)});
      }
    }
  }
  return transitions;
}

Transition AnalyzeTransition(const ContactRelation& before, const ContactRelation& after) {
  const MotionDof a = ComputeMotionDof(before), b = ComputeMotionDof(after);
  if (!IsAmbiguous(a, b)) return AnalyzeTransition(a, b);
  Transition result = ApplyRules(a, b, DofTransitionsByDirection(before, after));
  result.ambiguous = true;
  result.why +=
      " Several indices decrease and several increase: they are paired by the directions of motion.";
  return result;
}

}  // namespace tact::algebra
