#include "enumerators/translation_steps.h"

#include "algebra/contact/motion_dof.h"

namespace tact::enumerators {
namespace {

using Normal = std::array<int64_t, 3>;

std::vector<Normal> Normals() {
  std::vector<Normal> normals;
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 1}) {
      for (const int z : {-1, 0, 1}) {
        if (x != 0 || y != 0 || z != 0) normals.push_back({x, y, z});
      }
    }
  }
  return normals;
}

// Kinds of sets of normals; all contacts are at one point, which changes no translation.
class Kinds {
 public:
  TranslationKind Of(const std::vector<Normal>& normals) {
    rows_.clear();
    for (const Normal& n : normals) rows_.insert(rows_.end(), {0, 0, 0, n[0], n[1], n[2]});
    const auto dof = engine_.Compute(rows_).translation;
    return {dof.maintaining, dof.detaching, dof.constraining};
  }

 private:
  algebra::MotionDofEngine engine_;
  std::vector<int64_t> rows_;
};

class Walk {
 public:
  explicit Walk(size_t largest) : largest_(largest), normals_(Normals()) {}

  void Run() { Visit(0); }

  KindSteps one_contact, one_contact_moving, slot_moving;

 private:
  void Visit(size_t first) {
    Step();
    if (set_.size() == largest_) return;
    for (size_t i = first; i < normals_.size(); ++i) {
      set_.push_back(normals_[i]);
      Visit(i + 1);
      set_.pop_back();
    }
  }

  void Step() {
    const TranslationKind before = kinds_.Of(set_);
    const auto add = [&](const Normal& n) {
      set_.push_back(n);
      return kinds_.Of(set_);
    };
    for (const Normal& n : normals_) {
      const TranslationKind with_one = add(n);
      if (with_one != before) {
        one_contact.insert({before, with_one});
        // Some translation that keeps the contacts does not open the new one, unless none keeps them.
        if (before[0] > 0) one_contact_moving.insert({before, with_one});
      }
      const TranslationKind with_two = add({-n[0], -n[1], -n[2]});
      // A translation into the slot keeps both walls.
      if (with_two != before && with_two[0] > 0) slot_moving.insert({before, with_two});
      set_.resize(set_.size() - 2);
    }
  }

  size_t largest_;
  std::vector<Normal> normals_;
  std::vector<Normal> set_;
  Kinds kinds_;
};

// Every pair with fewer maintaining, more constraining DOFs: what any number of contacts can do.
KindSteps AnyContacts(const KindSteps& single, const KindSteps& slots) {
  KindSteps closed = single;
  closed.insert(slots.begin(), slots.end());
  for (bool grows = true; grows;) {
    grows = false;
    const KindSteps now = closed;
    for (const auto& [a, b] : now) {
      for (const auto& [c, d] : now) {
        if (b == c && closed.insert({a, d}).second) grows = true;
      }
    }
  }
  return closed;
}

KindSteps Filter(const KindSteps& steps, bool (*keep)(const TranslationKind&, const TranslationKind&)) {
  KindSteps kept;
  for (const auto& [a, b] : steps) {
    if (keep(a, b)) kept.insert({a, b});
  }
  return kept;
}

}  // namespace

std::vector<TranslationKind> TranslationKinds() {
  std::vector<TranslationKind> kinds;
  for (int m = 3; m >= 0; --m) {
    for (int d = 3 - m; d >= 0; --d) kinds.push_back({m, d, 3 - m - d});
  }
  return kinds;
}

std::vector<StepDefinition> TranslationSteps(size_t largest) {
  Walk walk(largest);
  walk.Run();
  KindSteps moving = walk.one_contact_moving;
  moving.insert(walk.slot_moving.begin(), walk.slot_moving.end());
  const KindSteps any = AnyContacts(walk.one_contact, walk.slot_moving);
  return {
      {"one contact is added", walk.one_contact},
      {"one contact is added, met head on",
       Filter(walk.one_contact, [](const auto& a, const auto& b) { return a[0] > b[0]; })},
      {"several contacts are added, met head on",
       Filter(any, [](const auto& a, const auto& b) { return a[0] > b[0] && a[2] == b[2]; })},
      {"one contact is added by a translation that keeps the others", walk.one_contact_moving},
      {"the two walls of a slot are added by a translation that keeps the others", walk.slot_moving},
      {"one contact, or the two walls of a slot, are added by a translation that keeps the others", moving},
      {"one DOF goes from maintaining to detaching or from detaching to constraining",
       Filter(any,
              [](const auto& a, const auto& b) {
                return (a[0] - b[0] == 1 && a[2] == b[2]) || (a[0] == b[0] && b[2] - a[2] == 1);
              })},
      {"any contacts are added", any},
  };
}

}  // namespace tact::enumerators
