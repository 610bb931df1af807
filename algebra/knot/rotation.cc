#include "algebra/knot/rotation.h"

#include <algorithm>
#include <map>

#include "algebra/knot/thesis_graphs.h"

namespace tact::knot {
namespace {

// What comes after and before each dart round the vertex that it leaves; dart +k at [2k - 2], -k at [2k - 1].
class Darts {
 public:
  explicit Darts(const Rotation& rotation) {
    size_t count = 0;
    for (const auto& order : rotation) count += order.size();
    after_.resize(count);
    before_.resize(count);
    for (const auto& order : rotation) {
      for (size_t i = 0; i < order.size(); ++i) {
        const int dart = order[i], next = order[i + 1 < order.size() ? i + 1 : 0];
        after_[Index(dart)] = next;
        before_[Index(next)] = dart;
      }
    }
  }
  static size_t Index(int dart) { return 2 * static_cast<size_t>(std::abs(dart)) - (dart > 0 ? 2 : 1); }
  static int At(size_t index) { return (index % 2 == 0 ? 1 : -1) * (static_cast<int>(index / 2) + 1); }
  size_t size() const { return after_.size(); }
  int after(int dart) const { return after_[Index(dart)]; }
  int before(int dart) const { return before_[Index(dart)]; }
  // The next dart of the face on the left.
  int next(int dart) const { return before(-dart); }

 private:
  std::vector<int> after_, before_;
};

std::vector<int> FromLeast(std::vector<int> order) {
  std::rotate(order.begin(), std::min_element(order.begin(), order.end()), order.end());
  return order;
}

// Darts numbered as they are met from `first`, breadth first; what follows each dart by its number.
std::vector<int> CodeFrom(const Darts& darts, int first, bool reversed) {
  std::map<int, int> number;
  std::vector<int> met, code;
  const auto name = [&](int dart) {
    const auto [it, is_new] = number.emplace(dart, static_cast<int>(met.size()));
    if (is_new) met.push_back(dart);
    return it->second;
  };
  name(first);
  for (size_t i = 0; i < met.size(); ++i) {
    const int dart = met[i];
    code.push_back(name(reversed ? darts.before(dart) : darts.after(dart)));
    code.push_back(name(-dart));
  }
  return code;
}

}  // namespace

Rotation RotationOf(const PData& p) {
  Rotation rotation;
  for (int i = 1; i <= p.columns(); ++i) {
    const int j = p.sigma(i);
    if (j < i) continue;
    // Ahead, left, behind, right, as seen along the strand of column i.
    const bool left = p.turn(i) > 0;
    std::vector<int> order;
    for (const int dart : {i, left ? j : 1 - j, 1 - i, left ? 1 - j : j}) {
      if (dart != 0 && dart != p.columns()) order.push_back(dart);
    }
    rotation.push_back(order.empty() ? order : FromLeast(std::move(order)));
  }
  return rotation;
}

Rotation MirrorRotation(const Rotation& rotation) {
  Rotation mirrored;
  for (std::vector<int> order : rotation) {
    std::reverse(order.begin(), order.end());
    mirrored.push_back(order.empty() ? order : FromLeast(std::move(order)));
  }
  return mirrored;
}

std::vector<std::vector<int>> TraceFaces(const Rotation& rotation) {
  const Darts darts(rotation);
  std::vector<bool> seen(darts.size());
  std::vector<std::vector<int>> faces;
  for (size_t i = 0; i < darts.size(); ++i) {
    if (seen[i]) continue;
    std::vector<int> face;
    for (int dart = Darts::At(i); !seen[Darts::Index(dart)]; dart = darts.next(dart)) {
      seen[Darts::Index(dart)] = true;
      face.push_back(dart);
    }
    faces.push_back(FromLeast(std::move(face)));
  }
  return faces;
}

int Genus(const Rotation& rotation) {
  const Darts darts(rotation);
  if (darts.size() == 0) return 0;
  std::vector<bool> seen(darts.size());
  int faces = 0;
  for (size_t i = 0; i < darts.size(); ++i) {
    if (seen[i]) continue;
    ++faces;
    for (int dart = Darts::At(i); !seen[Darts::Index(dart)]; dart = darts.next(dart))
      seen[Darts::Index(dart)] = true;
  }
  return (2 - static_cast<int>(rotation.size()) + static_cast<int>(darts.size() / 2) - faces) / 2;
}

bool IsStraight(const Rotation& rotation) {
  // On column i's strand +i goes on and -(i - 1) goes back.
  return std::all_of(rotation.begin(), rotation.end(), [](const std::vector<int>& order) {
    return order.size() != 4 || (order[0] + order[2] == 1 && order[1] + order[3] == 1);
  });
}

void ForEachPlanarRotation(const PData& p, const std::function<void(const Rotation&)>& visit) {
  Rotation rotation = RotationOf(p);
  for (auto& order : rotation) std::sort(order.begin(), order.end());
  // All orders that begin with the least: each cyclic order once.
  const std::function<void(size_t)> choose = [&](size_t v) {
    if (v == rotation.size()) {
      if (Genus(rotation) == 0) visit(rotation);
      return;
    }
    auto& order = rotation[v];
    if (order.size() < 3) return choose(v + 1);
    do choose(v + 1);
    while (std::next_permutation(order.begin() + 1, order.end()));
  };
  choose(0);
}

std::vector<int> NamelessCode(const Rotation& rotation) {
  const Darts darts(rotation);
  std::vector<int> least;
  for (size_t i = 0; i < darts.size(); ++i) {
    for (const bool reversed : {false, true}) {
      std::vector<int> code = CodeFrom(darts, Darts::At(i), reversed);
      if (least.empty() || code < least) least = std::move(code);
    }
  }
  return least;
}

}  // namespace tact::knot
