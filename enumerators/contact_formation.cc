#include "enumerators/contact_formation.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "algebra/error.h"
#include "enumerators/pose_cells.h"

namespace tact::enumerators {
namespace {

using algebra::Polyhedron;
using algebra::Rational;
using algebra::Vector3;

constexpr int kOverlap = -1;

int Floor(const Rational& value) {
  if (!value.is_integer() || !value.numerator().is_small())
    throw PreconditionError("formations of solids with small integer corners, got " + value.ToString());
  return static_cast<int>(value.numerator().small());
}

struct Bounds {
  Lattice3 least, most;
};

Bounds BoundsOf(const Polyhedron& solid) {
  Bounds bounds{};
  for (size_t i = 0; i < 3; ++i) {
    const int axis = static_cast<int>(i);
    const auto [least, most] =
        std::minmax_element(solid.vertices.begin(), solid.vertices.end(),
                            [&](const auto& a, const auto& b) { return a.point[axis] < b.point[axis]; });
    bounds.least[i] = Floor(least->point[axis]);
    bounds.most[i] = Floor(most->point[axis]);
  }
  return bounds;
}

class Search {
 public:
  Search(const Polyhedron& moving, const Polyhedron& fixed)
      : moving_(moving), fixed_(fixed), cells_(EventNormals(moving, fixed)) {
    const Bounds of_moving = BoundsOf(moving), of_fixed = BoundsOf(fixed);
    for (size_t i = 0; i < 3; ++i) {
      reach_.least[i] = of_fixed.least[i] - of_moving.most[i];
      reach_.most[i] = of_fixed.most[i] - of_moving.least[i];
      // One free layer all around, so that what is outside is connected.
      first_[i] = reach_.least[i] - 1;
      count_[i] = reach_.most[i] + 1 - first_[i];
    }
  }

  FormationComplex Run() {
    LookAtCells();
    JoinCells();
    NumberFormations();
    FindBorders();
    return std::move(result_);
  }

 private:
  struct Place {
    int pairs = kOverlap;  // index of the touching pairs
    algebra::ContactRelation relation;
    algebra::MotionDof dof;
  };

  size_t Blocks() const { return static_cast<size_t>(count_[0]) * count_[1] * count_[2]; }
  Lattice3 Offset(size_t index) const {
    const size_t block = index / cells_.cells().size();
    return {first_[0] + static_cast<int>(block / (static_cast<size_t>(count_[1]) * count_[2])),
            first_[1] + static_cast<int>(block / count_[2] % count_[1]),
            first_[2] + static_cast<int>(block % count_[2])};
  }
  // The index of a cell, or nothing if it is out of reach.
  std::optional<size_t> IndexOf(size_t cell, const Lattice3& offset) const {
    size_t block = 0;
    for (size_t i = 0; i < 3; ++i) {
      const int step = offset[i] - first_[i];
      if (step < 0 || step >= count_[i]) return std::nullopt;
      block = block * count_[i] + step;
    }
    return block * cells_.cells().size() + cell;
  }
  Vector3 PoseOf(size_t index) const { return cells_.Point(index % cells_.cells().size(), Offset(index)); }
  bool InReach(const Vector3& pose) const {
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<size_t>(i);
      if (pose[i] < Rational(reach_.least[axis]) || Rational(reach_.most[axis]) < pose[i]) return false;
    }
    return true;
  }
  int DimensionOf(size_t index) const { return cells_.cells()[index % cells_.cells().size()].dimension; }

  // Calls visit(g, f) for every cell f in the closure of a cell g, both without overlap.
  template <typename Visit>
  void ForEachSide(const Visit& visit) const {
    for (size_t g = 0; g < places_.size(); ++g) {
      if (places_[g].pairs == kOverlap) continue;
      const Lattice3 at = Offset(g);
      for (const PoseCells::Side& side : cells_.Closure(g % cells_.cells().size())) {
        const auto f =
            IndexOf(side.cell, {at[0] + side.offset[0], at[1] + side.offset[1], at[2] + side.offset[2]});
        if (f && places_[*f].pairs != kOverlap) visit(g, *f);
      }
    }
  }

  void LookAtCells() {
    places_.resize(Blocks() * cells_.cells().size());
    std::map<ElementPairs, int> known;
    for (size_t i = 0; i < places_.size(); ++i) {
      const Vector3 pose = PoseOf(i);
      algebra::FoundContacts found;
      if (InReach(pose)) found = FindContacts(Transform(moving_, {{}, pose}), fixed_, 0);
      if (found.penetration) continue;
      ++result_.cells;
      const auto [at, is_new] = known.emplace(PairsOf(found), static_cast<int>(known.size()));
      if (is_new) pairs_.push_back(at->first);
      places_[i] = {at->second, std::move(found.relation), {}};
      places_[i].dof = engine_.Compute(places_[i].relation);
    }
  }

  size_t Root(size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void JoinCells() {
    parent_.resize(places_.size());
    std::iota(parent_.begin(), parent_.end(), size_t{0});
    ForEachSide([&](size_t g, size_t f) {
      if (places_[g].pairs != places_[f].pairs) return;
      const size_t a = Root(g), b = Root(f);
      parent_[std::max(a, b)] = std::min(a, b);
    });
  }

  void NumberFormations() {
    formation_.assign(places_.size(), 0);
    for (size_t i = 0; i < places_.size(); ++i) {
      if (places_[i].pairs == kOverlap) continue;
      const size_t root = Root(i);
      if (root == i) {
        formation_[i] = result_.formations.size();
        result_.formations.push_back({pairs_[places_[i].pairs], -1, {}, {}, {}, 0, false});
      }
      formation_[i] = formation_[root];
      Formation& formation = result_.formations[formation_[i]];
      ++formation.cells;
      if (DimensionOf(i) <= formation.dimension) continue;
      formation.dimension = DimensionOf(i);
      formation.pose = PoseOf(i);
      formation.relation = places_[i].relation;
      formation.dof = places_[i].dof;
    }
    for (size_t i = 0; i < places_.size(); ++i) {
      if (places_[i].pairs == kOverlap) continue;
      Formation& formation = result_.formations[formation_[i]];
      formation.uneven = formation.uneven || places_[i].dof != formation.dof;
      if (formation.pose == PoseOf(i)) LookAround(i, &formation);
    }
  }

  void LookAround(size_t i, Formation* formation) {
    for (const Vector3& pose : cells_.OtherPoints(i % cells_.cells().size(), Offset(i))) {
      const auto found = FindContacts(Transform(moving_, {{}, pose}), fixed_, 0);
      if (found.penetration || PairsOf(found) != formation->pairs)
        throw InvariantError("other elements touch at another point of a cell: " + ToString(pose));
      formation->uneven = formation->uneven || engine_.Compute(found.relation) != formation->dof;
    }
  }

  void FindBorders() {
    // Of several places where two formations meet, one where both are as large as they get.
    std::map<std::pair<size_t, size_t>, std::pair<size_t, size_t>> borders;
    const auto size = [&](const std::pair<size_t, size_t>& at) {
      return DimensionOf(at.first) + DimensionOf(at.second);
    };
    ForEachSide([&](size_t g, size_t f) {
      if (formation_[g] == formation_[f]) return;
      const auto [at, is_new] = borders.emplace(std::pair(formation_[g], formation_[f]), std::pair(g, f));
      if (!is_new && size(at->second) < size({g, f})) at->second = {g, f};
    });
    for (const auto& [pair, at] : borders)
      result_.borders.push_back({pair.first, pair.second, PoseOf(at.first), PoseOf(at.second)});
  }

  const Polyhedron& moving_;
  const Polyhedron& fixed_;
  PoseCells cells_;
  Bounds reach_{};  // translations at which the solids' boxes meet
  Lattice3 first_{}, count_{};
  std::vector<Place> places_;
  std::vector<ElementPairs> pairs_;
  std::vector<size_t> parent_, formation_;
  algebra::MotionDofEngine engine_;
  FormationComplex result_;
};

}  // namespace

ElementPairs PairsOf(const algebra::FoundContacts& found) {
  ElementPairs pairs = found.elements;
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

FormationComplex FindFormations(const Polyhedron& moving, const Polyhedron& fixed) {
  return Search(moving, fixed).Run();
}

}  // namespace tact::enumerators
