// Transitions between relations: DOF-transitions, sub-skills, critical transitions from the motion DOFs of
// both sides.
#include <array>
#include <string>

#include "provers/check/kinds.h"

namespace tact::check {
namespace {

// The six indices of a motion that a DOF-transition is about; the first three are zero in a singular
// relation, the last three in a non-singular one.
enum Six {
  kMaintaining,
  kDetaching,
  kConstraining,
  kSingularMaintaining,
  kSingularDetaching,
  kSingularConstraining
};
constexpr std::array<std::string_view, 6> kSixNames = {"maintaining",        "detaching",
                                                       "constraining",       "singular_maintaining",
                                                       "singular_detaching", "singular_constraining"};
constexpr std::array<std::string_view, 2> kMotions = {"translation", "rotation"};

struct DofTransition {
  std::size_t motion;
  std::size_t from;
  std::size_t to;
};

std::string Name(std::string_view motion, std::string_view index) {
  return std::string(motion) + "." + std::string(index);
}

int SixIndex(const MotionNumbers& dof, std::string_view motion, std::size_t six) {
  const bool singular = six >= kSingularMaintaining;
  return singular == dof.singular ? dof[Name(motion, kSixNames[six % 3])] : 0;
}

int Increase(const MotionNumbers& before, const MotionNumbers& after, std::string_view motion,
             std::size_t six) {
  return SixIndex(after, motion, six) - SixIndex(before, motion, six);
}

std::vector<DofTransition> DofTransitions(const MotionNumbers& before, const MotionNumbers& after) {
  std::vector<DofTransition> list;
  for (std::size_t motion = 0; motion < kMotions.size(); ++motion) {
    for (std::size_t from = 0; from < 6; ++from) {
      for (std::size_t to = 0; to < 6; ++to) {
        if (Increase(before, after, kMotions[motion], from) < 0 &&
            Increase(before, after, kMotions[motion], to) > 0) {
          list.push_back({motion, from, to});
        }
      }
    }
  }
  return list;
}

bool IsPractical(const DofTransition& t) {
  const auto constraining = [](std::size_t six) {
    return six == kConstraining || six == kSingularConstraining;
  };
  const bool both_singular = t.from >= kSingularMaintaining && t.to >= kSingularMaintaining;
  return !both_singular && !(t.from == kMaintaining && constraining(t.to)) &&
         !(constraining(t.from) && t.to == kMaintaining);
}

bool IsCritical(const DofTransition& t) {
  return (t.from == kSingularMaintaining || t.from == kSingularDetaching) && t.to == kConstraining;
}

std::vector<std::string> SubSkills(const std::vector<DofTransition>& list, const MotionNumbers& before,
                                   const MotionNumbers& after) {
  const auto increases = [&](std::string_view name) { return after[name] > before[name]; };
  std::vector<std::string> skills;
  for (std::size_t motion = 0; motion < kMotions.size(); ++motion) {
    const std::string in_motion = "-in-" + std::string(kMotions[motion]);
    const auto has = [&](std::size_t from, std::size_t to) {
      for (const DofTransition& t : list) {
        if (t.motion == motion && t.from == from && t.to == to) return true;
      }
      return false;
    };
    if (has(kMaintaining, kDetaching)) {
      if (motion == 0) {
        skills.push_back("make-contact" + in_motion);
      } else {
        if (increases("rotation.detaching_type1")) skills.push_back("type1-make-contact" + in_motion);
        if (increases("rotation.detaching_type2")) skills.push_back("type2-make-contact" + in_motion);
      }
    }
    if (has(kDetaching, kMaintaining) || has(kSingularDetaching, kMaintaining))
      skills.push_back("detach-contact" + in_motion);
    if (has(kMaintaining, kSingularMaintaining) && increases(Name(kMotions[motion], "restricted"))) {
      skills.push_back("slide" + in_motion);
    }
  }
  return skills;
}

void ExpectDofTransitions(const Value& value, const std::vector<DofTransition>& expected) {
  const Array& list = AsArray(value);
  for (std::size_t i = 0; i < list.size(); ++i) {
    ExpectKeys(list[i], {"motion", "from", "to"});
    if (i >= expected.size())
      throw Refused(&list[i], "the motion DOFs show no more than " + std::to_string(i));
    const DofTransition& t = expected[i];
    if (AsString(At(list[i], "motion")) != kMotions[t.motion] ||
        AsString(At(list[i], "from")) != kSixNames[t.from] ||
        AsString(At(list[i], "to")) != kSixNames[t.to]) {
      throw Refused(&list[i], "the motion DOFs show, in " + std::string(kMotions[t.motion]) + ", " +
                                  std::string(kSixNames[t.from]) + " -> " + std::string(kSixNames[t.to]));
    }
  }
  if (list.size() < expected.size()) {
    throw Refused(&value, "the motion DOFs show " + std::to_string(expected.size()) + ", not " +
                              std::to_string(list.size()));
  }
}

void ExpectStrings(const Value& value, const std::vector<std::string>& expected) {
  const Array& list = AsArray(value);
  bool equal = list.size() == expected.size();
  for (std::size_t i = 0; i < list.size(); ++i)
    equal = (AsString(list[i]) == (equal ? expected[i] : "")) && equal;
  if (equal) return;
  std::string shown;
  for (const std::string& text : expected) shown += (shown.empty() ? "" : ", ") + text;
  throw Refused(&value, "the motion DOFs show " + (shown.empty() ? "none" : shown));
}

void ExpectFlag(const Value& value, bool expected) {
  if (AsBool(value) != expected)
    throw Refused(&value, std::string("the motion DOFs show ") + (expected ? "true" : "false"));
}

void CheckChanges(const Value& changes, const MotionNumbers& before, const MotionNumbers& after) {
  for (const auto& [name, value] : AsObject(changes)) {
    bool known = false;
    int change = 0;
    for (std::string_view motion : kMotions) {
      for (std::size_t six = 0; six < 6; ++six) {
        if (name != Name(motion, kSixNames[six])) continue;
        known = true;
        change = Increase(before, after, motion, six);
      }
      if (name != Name(motion, "restricted")) continue;
      known = true;
      change = after[name] - before[name];
    }
    if (!known) throw Refused(&value, "no index of transitions is named " + Quote(name));
    if (AsInteger(value) != change) throw Refused(&value, "the motion DOFs show " + std::to_string(change));
  }
}

}  // namespace

void CheckTransitions(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"relations", "names", "transitions"}, {"expects"});
  CheckRelationsAndTransitions(certificate);
}

std::vector<MotionNumbers> CheckRelationsAndTransitions(const Value& certificate) {
  std::vector<MotionNumbers> dofs;
  for (const Value& relation : AsArray(At(certificate, "relations"))) dofs.push_back(CheckRelation(relation));
  const Array& names = AsArray(At(certificate, "names"));
  if (names.size() != dofs.size()) throw Refused(&At(certificate, "names"), "expected one name a relation");
  for (const Value& name : names) AsString(name);

  std::vector<std::pair<std::size_t, std::size_t>> ends;
  for (const Value& transition : AsArray(At(certificate, "transitions"))) {
    ExpectKeys(transition, {"from", "to", "dof_transitions", "practical", "sub_skills", "critical"});
    const std::size_t from = AsIndex(At(transition, "from"), dofs.size());
    const std::size_t to = AsIndex(At(transition, "to"), dofs.size());
    const std::vector<DofTransition> list = DofTransitions(dofs[from], dofs[to]);
    bool practical = true, critical = false;
    for (const DofTransition& t : list) {
      practical = practical && IsPractical(t);
      critical = critical || IsCritical(t);
    }
    ExpectDofTransitions(At(transition, "dof_transitions"), list);
    ExpectFlag(At(transition, "practical"), practical);
    ExpectStrings(At(transition, "sub_skills"), SubSkills(list, dofs[from], dofs[to]));
    ExpectFlag(At(transition, "critical"), critical);
    ends.emplace_back(from, to);
  }
  if (const Value* expects = Find(certificate, "expects")) {
    for (const Value& expect : AsArray(*expects)) {
      ExpectKeys(expect, {"transition", "changes"});
      const auto [from, to] = ends[AsIndex(At(expect, "transition"), ends.size())];
      CheckChanges(At(expect, "changes"), dofs[from], dofs[to]);
    }
  }
  return dofs;
}

}  // namespace tact::check
