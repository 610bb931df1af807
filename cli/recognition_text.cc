#include "cli/recognition_text.h"

#include <fmt/format.h>

#include "cli/json_text.h"

namespace tact::cli {
namespace {

using recognition::Recognition;
using recognition::SeenRelation;

std::string RelationToJson(const SeenRelation& r) {
  return R"({"frames":[)" + std::to_string(r.first) + "," + std::to_string(r.last) + R"(],"name":)" +
         JsonString(r.name) + R"(,"contacts":)" + ContactsToJson(r.relation) + R"(,"dof":)" + ToJson(r.dof) +
         "}";
}

std::string TransitionToJson(const algebra::Transition& t, size_t from) {
  std::string text = R"({"from":)" + std::to_string(from) + R"(,"to":)" + std::to_string(from + 1) +
                     R"(,"dof_transitions":[)";
  for (size_t i = 0; i < t.dof_transitions.size(); ++i)
    text += (i == 0 ? "" : ",") + ToJson(t.dof_transitions[i]);
  text += std::string(R"(],"practical":)") + (t.practical ? "true" : "false") + R"(,"sub_skills":[)";
  for (size_t i = 0; i < t.sub_skills.size(); ++i)
    text += (i == 0 ? "" : ",") + JsonString(ToString(t.sub_skills[i]));
  return text + R"(],"critical":)" + (t.critical ? "true" : "false") + R"(,"why":)" + JsonString(t.why) + "}";
}

}  // namespace

std::string ToJsonMembers(const Recognition& recognition) {
  std::string text = R"("relations":[)";
  for (size_t i = 0; i < recognition.relations.size(); ++i) {
    text += (i == 0 ? "" : ",") + RelationToJson(recognition.relations[i]);
  }
  text += R"(],"transitions":[)";
  for (size_t i = 0; i < recognition.transitions.size(); ++i) {
    text += (i == 0 ? "" : ",") + TransitionToJson(recognition.transitions[i], i);
  }
  return text + "]";
}

std::string ContactSummary(const SeenRelation& r) {
  if (r.relation.contacts.empty()) return "nothing touches";
  if (r.primitives.empty()) return std::to_string(r.relation.contacts.size()) + " contacts";
  std::string text;
  for (size_t i = 0; i < r.primitives.size();) {
    const std::string kind = KindOf(r.primitives[i]);
    size_t same = i;
    while (same < r.primitives.size() && KindOf(r.primitives[same]) == kind) ++same;
    text +=
        (text.empty() ? "" : ", ") + (same - i > 1 ? std::to_string(same - i) + " " : std::string()) + kind;
    i = same;
  }
  return text;
}

namespace {

std::string Three(int a, int b, int c) { return fmt::format("{} {} {}", a, b, c); }

constexpr const char* kRelationRow = "{:<12}{:<10}{:<13}{:<10}{:<12}{}\n";

std::string RelationTable(const Recognition& recognition) {
  std::string text =
      "maintaining, detaching, constraining DOFs (singular ones where marked s), then restricted DOFs in "
      "translation "
      "and rotation\n";
  text +=
      fmt::format(kRelationRow, "relation", "states", "translation", "rotation", "restricted", "contacts");
  for (const SeenRelation& r : recognition.relations) {
    const algebra::TranslationDof& t = r.dof.translation;
    const algebra::RotationDof& w = r.dof.rotation;
    const std::string states =
        std::to_string(r.first) + (r.last > r.first ? "-" + std::to_string(r.last) : "");
    text += fmt::format(kRelationRow, r.name, states,
                        Three(t.maintaining, t.detaching, t.constraining) + (r.dof.singular ? " s" : ""),
                        Three(w.maintaining, w.detaching, w.constraining),
                        fmt::format("{} {}", t.restricted, w.restricted), ContactSummary(r));
  }
  return text;
}

// "translation  maintaining -> detaching", one a line.
std::string DofTransitionLines(const algebra::Transition& t) {
  std::string text;
  for (const algebra::DofTransition& d : t.dof_transitions) {
    text += fmt::format("    {:<13}", ToString(d.motion)) + ToString(d.from) + " -> " + ToString(d.to) +
            (IsPractical(d) ? "" : "   (not practical)") + "\n";
  }
  return text;
}

std::string TransitionList(const Recognition& recognition) {
  std::string text;
  for (size_t i = 0; i < recognition.transitions.size(); ++i) {
    const algebra::Transition& t = recognition.transitions[i];
    text += "\n(" + std::to_string(i + 1) + ") " + recognition.relations[i].name + " -> " +
            recognition.relations[i + 1].name + (t.critical ? "   CRITICAL" : "") +
            (t.practical ? "" : "   NOT PRACTICAL") + "\n" + DofTransitionLines(t);
    text += "    sub-skills:  ";
    for (size_t k = 0; k < t.sub_skills.size(); ++k) text += (k == 0 ? "" : ", ") + ToString(t.sub_skills[k]);
    text += t.sub_skills.empty() ? "none\n" : "\n";
    text += "    why:         " + t.why + "\n";
  }
  return text;
}

}  // namespace

std::string ToText(const Recognition& recognition) {
  return RelationTable(recognition) + TransitionList(recognition);
}

}  // namespace tact::cli
