#include "enumerators/solid_family.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "algebra/solid/convex_hull.h"
#include "enumerators/lattice_solid.h"

namespace tact::enumerators {
namespace {

using algebra::Polyhedron;
using algebra::Vector3;

Polyhedron Box(int x, int y, int z) { return LatticeSolid({{{0, 0, 0}, {x, y, z}}}); }

// Walls and floor one thick, one long.
Polyhedron Slot(int width, int depth) {
  return LatticeSolid({{{0, 0, 0}, {width + 2, 1, depth + 1}}}, {{{1, 0, 1}, {width + 1, 1, depth + 1}}});
}

// A square hole through a plate one thick; or a blind one, with a floor.
Polyhedron Hole(int width, int floor) {
  return LatticeSolid({{{0, 0, 0}, {width + 2, width + 2, floor + 1}}},
                      {{{1, 1, floor}, {width + 1, width + 1, floor + 1}}});
}

Polyhedron Corner() { return LatticeSolid({{{0, 0, 0}, {2, 2, 2}}}, {{{1, 1, 1}, {2, 2, 2}}}); }
Polyhedron Step() { return LatticeSolid({{{0, 0, 0}, {2, 1, 2}}}, {{{1, 0, 1}, {2, 1, 2}}}); }
Polyhedron Ell() { return LatticeSolid({{{0, 0, 0}, {1, 1, 2}}, {{0, 0, 0}, {2, 1, 1}}}); }
// Hanging head, stem of the width down.
Polyhedron Tee(int width) {
  return LatticeSolid({{{0, 0, 1}, {width + 2, 1, 2}}, {{1, 0, 0}, {width + 1, 1, 1}}});
}
Polyhedron Mushroom() { return LatticeSolid({{{0, 0, 1}, {3, 3, 2}}, {{1, 1, 0}, {2, 2, 1}}}); }
Polyhedron TwoPosts() {
  return LatticeSolid({{{0, 0, 0}, {5, 3, 1}}, {{1, 1, 1}, {2, 2, 2}}, {{3, 1, 1}, {4, 2, 2}}});
}
Polyhedron TwoHoles() {
  return LatticeSolid({{{0, 0, 0}, {5, 3, 1}}}, {{{1, 1, 0}, {2, 2, 1}}, {{3, 1, 0}, {4, 2, 1}}});
}
Polyhedron Post() { return LatticeSolid({{{0, 0, 0}, {3, 3, 1}}, {{1, 1, 1}, {2, 2, 2}}}); }
// A slot with a wider room below its neck, and the key that fits it.
Polyhedron TeeSlot() {
  return LatticeSolid({{{0, 0, 0}, {5, 1, 3}}}, {{{1, 0, 1}, {4, 1, 2}}, {{2, 0, 2}, {3, 1, 3}}});
}
Polyhedron TeeKey() { return LatticeSolid({{{0, 0, 0}, {3, 1, 1}}, {{1, 0, 1}, {2, 1, 2}}}); }
// A wall with a lip over the floor.
Polyhedron Lip() {
  return LatticeSolid({{{0, 0, 0}, {4, 1, 1}}, {{0, 0, 1}, {1, 1, 3}}, {{1, 0, 2}, {2, 1, 3}}});
}
Polyhedron Comb(int teeth) {
  std::vector<LatticeBox> boxes = {{{0, 0, 0}, {2 * teeth - 1, 1, 1}}};
  for (int i = 0; i < teeth; ++i) boxes.push_back({{2 * i, 0, 1}, {2 * i + 1, 1, 2}});
  return LatticeSolid(boxes);
}
Polyhedron HangingComb(int teeth) {
  std::vector<LatticeBox> boxes = {{{0, 0, 1}, {2 * teeth - 1, 1, 2}}};
  for (int i = 0; i < teeth; ++i) boxes.push_back({{2 * i, 0, 0}, {2 * i + 1, 1, 1}});
  return LatticeSolid(boxes);
}

class List {
 public:
  explicit List(FamilySize size) : size_(size) {}

  void Family(const std::string& name) { family_ = name; }
  // turns_from: from which size on tilts are tried; without it, never.
  template <typename Moving, typename Fixed>
  void Add(FamilySize from, std::optional<FamilySize> turns_from, const std::string& name,
           const Moving& moving, const Fixed& fixed) {
    if (size_ < from) return;
    pairs_.push_back({family_, name, moving(), fixed(), turns_from && size_ >= *turns_from});
  }
  std::vector<SolidPair> Take() { return std::move(pairs_); }

 private:
  FamilySize size_;
  std::string family_;
  std::vector<SolidPair> pairs_;
};

constexpr FamilySize kSmall = FamilySize::kSmall, kMedium = FamilySize::kMedium, kLarge = FamilySize::kLarge;
constexpr std::nullopt_t kNever = std::nullopt;

void AddBlocks(List* list) {
  const auto cube = [] { return Box(1, 1, 1); };
  const auto block = [] { return Box(2, 2, 1); };
  list->Family("blocks");
  list->Add(kSmall, kSmall, "cube on an equal cube", cube, cube);
  list->Add(kSmall, kLarge, "cube on a block", cube, block);
  list->Add(
      kMedium, kNever, "bar across a block", [] { return Box(3, 1, 1); }, block);
  list->Add(kMedium, kNever, "block on an equal block", block, block);
  list->Add(kMedium, kLarge, "cube on a step", cube, Step);
  list->Add(
      kMedium, kNever, "bar on a step", [] { return Box(3, 1, 1); }, Step);
  list->Add(kMedium, kNever, "L on a step", Ell, Step);
  list->Add(kMedium, kLarge, "cube in a corner", cube, Corner);
  list->Add(kLarge, kNever, "L in a corner", Ell, Corner);
  list->Add(kLarge, kNever, "block in a corner", block, Corner);
}

void AddSlots(List* list) {
  const auto box = [](int x, int y, int z) { return [=] { return Box(x, y, z); }; };
  const auto slot = [](int width, int depth) { return [=] { return Slot(width, depth); }; };
  list->Family("prisms in slots");
  list->Add(kSmall, kMedium, "cube in a slot of its width", box(1, 1, 1), slot(1, 1));
  list->Add(kMedium, kLarge, "peg in a slot of its width", box(1, 1, 2), slot(1, 1));
  list->Add(kSmall, kLarge, "cube in a slot twice as wide", box(1, 1, 1), slot(2, 1));
  list->Add(kMedium, kNever, "bar over a slot half as wide", box(2, 1, 1), slot(1, 1));
  list->Add(kMedium, kNever, "bar in a slot of its width", box(2, 1, 1), slot(2, 1));
  list->Add(kMedium, kNever, "long peg in a slot of its width", box(1, 3, 1), slot(1, 1));
  list->Add(
      kSmall, kNever, "T in a slot of its stem's width", [] { return Tee(1); }, slot(1, 1));
  list->Add(
      kMedium, kNever, "T in a slot wider than its stem", [] { return Tee(1); }, slot(2, 1));
  list->Add(kMedium, kNever, "L in a slot of its leg's width", Ell, slot(1, 1));
  list->Add(kLarge, kNever, "L in a slot of its width", Ell, slot(2, 1));
  list->Add(kLarge, kNever, "cube in a deep slot of its width", box(1, 1, 1), slot(1, 2));
  list->Add(
      kLarge, kNever, "T in a deep slot of its stem's width", [] { return Tee(1); }, slot(1, 2));
}

void AddPegs(List* list) {
  const auto box = [](int x, int y, int z) { return [=] { return Box(x, y, z); }; };
  const auto hole = [](int width, int floor) { return [=] { return Hole(width, floor); }; };
  list->Family("pegs and holes");
  list->Add(kSmall, kLarge, "peg in a through hole of its width", box(1, 1, 2), hole(1, 0));
  list->Add(kMedium, kLarge, "peg in a blind hole of its width", box(1, 1, 2), hole(1, 1));
  list->Add(kMedium, kNever, "peg in a hole twice as wide", box(1, 1, 2), hole(2, 0));
  list->Add(kMedium, kNever, "bar in a hole of its length", box(2, 1, 1), hole(2, 0));
  list->Add(kLarge, kNever, "block over a hole half as wide", box(2, 2, 1), hole(1, 0));
  list->Add(kMedium, kNever, "mushroom in a through hole", Mushroom, hole(1, 0));
  list->Add(kLarge, kNever, "mushroom in a blind hole", Mushroom, hole(1, 1));
  list->Add(
      kMedium, kNever, "ring over a post", [] { return Hole(1, 0); }, Post);
  list->Add(kMedium, kNever, "cube between two posts", box(1, 1, 1), TwoPosts);
  list->Add(kLarge, kNever, "plate with two holes over two posts", TwoHoles, TwoPosts);
}

void AddUndercuts(List* list) {
  list->Family("undercuts");
  list->Add(
      kMedium, kLarge, "cube under a lip", [] { return Box(1, 1, 1); }, Lip);
  list->Add(kMedium, kNever, "L under a lip", Ell, Lip);
  list->Add(kMedium, kNever, "T key in a T slot", TeeKey, TeeSlot);
  list->Add(
      kLarge, kNever, "key in a T slot", [] { return Box(1, 1, 1); }, TeeSlot);
  list->Add(
      kMedium, kNever, "comb in a comb", [] { return HangingComb(2); }, [] { return Comb(2); });
  list->Add(
      kLarge, kNever, "comb of three in a comb", [] { return HangingComb(3); }, [] { return Comb(3); });
}

void AddHulls(List* list) {
  list->Family("convex solids");
  const std::vector<Polyhedron> hulls = CornerHulls();
  for (size_t i = 0; i < hulls.size(); ++i) {
    const auto hull = [&] { return hulls[i]; };
    const std::string name = "convex solid " + std::to_string(i + 1) + " with " +
                             std::to_string(hulls[i].vertices.size()) + " vertices";
    list->Add(i == 1 ? kSmall : kMedium, i == 1 ? kLarge : std::optional<FamilySize>(), name + " on a block",
              hull, [] { return Box(2, 2, 1); });
    list->Add(i < 4 ? kMedium : kLarge, kNever, name + " in a slot", hull, [] { return Slot(1, 1); });
    list->Add(kLarge, kNever, name + " in a corner", hull, Corner);
  }
}

// The corner 0..7 under the cube's symmetries: axes permuted, then flipped.
std::vector<std::array<size_t, 8>> CubeSymmetries() {
  std::vector<std::array<size_t, 8>> symmetries;
  std::array<size_t, 3> axes = {0, 1, 2};
  do {
    for (size_t flips = 0; flips < 8; ++flips) {
      auto& symmetry = symmetries.emplace_back();
      for (size_t corner = 0; corner < 8; ++corner) {
        size_t image = 0;
        for (size_t i = 0; i < 3; ++i) image |= (corner >> axes[i] & 1) << i;
        symmetry[corner] = image ^ flips;
      }
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return symmetries;
}

bool Coplanar(const std::vector<Vector3>& points) {
  for (size_t i = 2; i < points.size(); ++i) {
    const Vector3 normal = Cross(points[1] - points[0], points[i] - points[0]);
    for (const Vector3& p : points) {
      if (Dot(normal, p - points[0]).sign() != 0) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Polyhedron> CornerHulls() {
  const auto symmetries = CubeSymmetries();
  std::map<size_t, std::vector<Polyhedron>> by_corners;
  for (size_t set = 0; set < 256; ++set) {
    const bool least = std::all_of(symmetries.begin(), symmetries.end(), [&](const auto& symmetry) {
      size_t image = 0;
      for (size_t corner = 0; corner < 8; ++corner) image |= (set >> corner & 1) << symmetry[corner];
      return set <= image;
    });
    std::vector<Vector3> points;
    for (size_t corner = 0; corner < 8; ++corner) {
      if ((set >> corner & 1) != 0)
        points.push_back(
            {static_cast<int>(corner & 1), static_cast<int>(corner >> 1 & 1), static_cast<int>(corner >> 2)});
    }
    if (least && !Coplanar(points))
      by_corners[points.size()].push_back(BuildPolyhedron(algebra::ConvexHull(points)));
  }
  std::vector<Polyhedron> hulls;
  for (auto& [corners, some] : by_corners) hulls.insert(hulls.end(), some.begin(), some.end());
  return hulls;
}

std::vector<SolidPair> SolidPairs(FamilySize size) {
  List list(size);
  AddBlocks(&list);
  AddSlots(&list);
  AddPegs(&list);
  AddUndercuts(&list);
  AddHulls(&list);
  return list.Take();
}

}  // namespace tact::enumerators
