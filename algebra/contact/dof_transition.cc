#include "algebra/contact/dof_transition.h"

#include <algorithm>
#include <utility>

namespace tact::algebra {
namespace {

constexpr std::array<Motion, 2> kMotions = {Motion::kTranslation, Motion::kRotation};

bool IsSingular(DofIndex index) { return index >= DofIndex::kSingularMaintaining; }

bool IsConstraining(DofIndex index) {
  return index == DofIndex::kConstraining || index == DofIndex::kSingularConstraining;
}

class Analysis {
 public:
  Analysis(const MotionDof& before, const MotionDof& after, std::vector<DofTransition> dof_transitions)
      : before_(before), after_(after) {
    result_.dof_transitions = std::move(dof_transitions);
  }

  Transition Run() {
    for (const Motion motion : kMotions) SelectSubSkills(motion);
    for (const DofTransition& t : result_.dof_transitions) Judge(t);
    if (result_.sub_skills.empty()) Say("No rule selects a sub-skill: the motion is part of the next one.");
    return result_;
  }

 private:
  void Say(const std::string& sentence) {
    if (!result_.why.empty()) result_.why += " ";
    result_.why += sentence;
  }

  bool Appears(Motion motion, DofIndex from, DofIndex to) const {
    return std::find(result_.dof_transitions.begin(), result_.dof_transitions.end(),
                     DofTransition{motion, from, to}) != result_.dof_transitions.end();
  }

  void Select(SubSkill skill, const std::string& reason) {
    result_.sub_skills.push_back(skill);
    Say(ToString(skill) + ": " + reason + ".");
  }

  void SelectSubSkills(Motion motion) {
    const bool rotation = motion == Motion::kRotation;
    const std::string in = " in " + ToString(motion);
    if (Appears(motion, DofIndex::kMaintaining, DofIndex::kDetaching)) {
      const std::string reason = "a maintaining DOF" + in + " becomes a detaching one";
      if (!rotation) Select(SubSkill::kMakeContactInTranslation, reason);
      if (rotation && after_.rotation.detaching_type1 > before_.rotation.detaching_type1) {
        Select(SubSkill::kType1MakeContactInRotation, reason + " of Type I");
      }
      if (rotation && after_.rotation.detaching_type2 > before_.rotation.detaching_type2) {
        Select(SubSkill::kType2MakeContactInRotation, reason + " of Type II");
      }
    }
    if (Appears(motion, DofIndex::kDetaching, DofIndex::kMaintaining) ||
        Appears(motion, DofIndex::kSingularDetaching, DofIndex::kMaintaining)) {
      Select(rotation ? SubSkill::kDetachContactInRotation : SubSkill::kDetachContactInTranslation,
             "a detaching DOF" + in + " becomes a maintaining one");
    }
    if (!Appears(motion, DofIndex::kMaintaining, DofIndex::kSingularMaintaining)) return;
    const int before = Restricted(before_, motion), after = Restricted(after_, motion);
    const std::string change = std::to_string(before) + " to " + std::to_string(after);
    if (after > before) {
      Select(rotation ? SubSkill::kSlideInRotation : SubSkill::kSlideInTranslation,
             "a maintaining DOF" + in +
                 " becomes a singular maintaining one and the restricted DOF rises from " + change);
      if (before_.translation.detaching == 0) {
        Say("But no detaching DOF in translation was lost, so there was no support to slide on: this is an "
            "approach.");
      }
    } else {
      Say("No slide" + in +
          ": a maintaining DOF becomes a singular maintaining one, but the restricted DOF goes from " +
          change + " (2.6).");
    }
  }

  void Judge(const DofTransition& t) {
    const std::string name = ToString(t.from) + " -> " + ToString(t.to) + " in " + ToString(t.motion);
    if (!IsPractical(t)) {
      result_.practical = false;
      Say("Not practical: " + name + " is not among the 20 kinds of Fig. 2.5.");
    }
    if (t.to == DofIndex::kConstraining &&
        (t.from == DofIndex::kSingularMaintaining || t.from == DofIndex::kSingularDetaching)) {
      result_.critical = true;
      Say("Critical: " + name + " leads through a narrow entrance (2.5).");
    }
  }

  const MotionDof& before_;
  const MotionDof& after_;
  Transition result_;
};

}  // namespace

std::string ToString(Motion motion) { return motion == Motion::kTranslation ? "translation" : "rotation"; }

std::string ToString(DofIndex index) {
  static const char* const kNames[] = {"maintaining",          "detaching",          "constraining",
                                       "singular_maintaining", "singular_detaching", "singular_constraining"};
  return kNames[static_cast<int>(index)];
}

std::string ToString(SubSkill skill) {
  static const char* const kNames[] = {"make-contact-in-translation",
                                       "detach-contact-in-translation",
                                       "slide-in-translation",
                                       "type1-make-contact-in-rotation",
                                       "type2-make-contact-in-rotation",
                                       "detach-contact-in-rotation",
                                       "slide-in-rotation"};
  return kNames[static_cast<int>(skill)];
}

bool IsPractical(const DofTransition& t) {
  if (IsSingular(t.from) && IsSingular(t.to)) return false;
  const bool maintaining_constraining = (t.from == DofIndex::kMaintaining && IsConstraining(t.to)) ||
                                        (t.to == DofIndex::kMaintaining && IsConstraining(t.from));
  return !maintaining_constraining;
}

std::array<int, kDofIndices> Indices(const MotionDof& dof, Motion motion) {
  const bool translation = motion == Motion::kTranslation;
  const std::array<int, 3> kinds = {translation ? dof.translation.maintaining : dof.rotation.maintaining,
                                    translation ? dof.translation.detaching : dof.rotation.detaching,
                                    translation ? dof.translation.constraining : dof.rotation.constraining};
  std::array<int, kDofIndices> indices{};
  for (size_t i = 0; i < 3; ++i) indices[dof.singular ? i + 3 : i] = kinds[i];
  return indices;
}

int Restricted(const MotionDof& dof, Motion motion) {
  return motion == Motion::kTranslation ? dof.translation.restricted : dof.rotation.restricted;
}

std::vector<DofTransition> DofTransitionsByCounts(const MotionDof& before, const MotionDof& after) {
  std::vector<DofTransition> transitions;
  for (const Motion motion : kMotions) {
    const auto a = Indices(before, motion), b = Indices(after, motion);
    for (int from = 0; from < kDofIndices; ++from) {
      for (int to = 0; to < kDofIndices; ++to) {
        if (b[from] < a[from] && b[to] > a[to])
          transitions.push_back({motion, static_cast<DofIndex>(from), static_cast<DofIndex>(to)});
      }
    }
  }
  return transitions;
}

bool IsAmbiguous(const MotionDof& before, const MotionDof& after) {
  for (const Motion motion : kMotions) {
    const auto a = Indices(before, motion), b = Indices(after, motion);
    int falls = 0, rises = 0;
    for (int i = 0; i < kDofIndices; ++i) {
      falls += b[i] < a[i] ? 1 : 0;
      rises += b[i] > a[i] ? 1 : 0;
    }
    if (falls > 1 && rises > 1) return true;
  }
  return false;
}

Transition ApplyRules(const MotionDof& before, const MotionDof& after,
                      std::vector<DofTransition> dof_transitions) {
  return Analysis(before, after, std::move(dof_transitions)).Run();
}

Transition AnalyzeTransition(const MotionDof& before, const MotionDof& after) {
  Transition result = ApplyRules(before, after, DofTransitionsByCounts(before, after));
  result.ambiguous = IsAmbiguous(before, after);
  if (result.ambiguous) {
    result.why +=
        " Several indices decrease and several increase: every pair of them is listed, since nothing says "
        "which "
        "belongs to which.";
  }
  return result;
}

}  // namespace tact::algebra
