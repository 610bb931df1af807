#include "algebra/error.h"
#include "provers/claims/census.h"
#include "provers/claims/claims.h"
#include "provers/claims/peg_insertion.h"
#include "provers/report/solid_drawing.h"

namespace tact::provers {
namespace {

using algebra::SubSkill;
using recognition::SeenRelation;

// What 2.8.2 says of a transition. Changes the text does not mention are not expected.
struct Words {
  std::string quote;  // the sense of the text, in our words
  Changes changes;
  std::vector<SubSkill> sub_skills;
  bool critical;
  std::string silence = {};  // what the text leaves out and the geometry shows
};

const std::vector<SubSkill> kAlign = {SubSkill::kMakeContactInTranslation,
                                      SubSkill::kType1MakeContactInRotation};

Changes OneMaintainingToDetaching() {
  return {{"translation.maintaining", -1},
          {"translation.detaching", 1},
          {"rotation.maintaining", -1},
          {"rotation.detaching", 1}};
}

const std::vector<Words>& TextOfTransitions() {
  static const std::vector<Words> words = {
      {"maintaining DOFs fall by one and detaching DOFs rise by one in both motions, of Type I in rotation; "
       "make-contact in "
       "both; not critical",
       OneMaintainingToDetaching(), kAlign, false},
      {"maintaining DOFs fall by two and detaching DOFs by one in both motions, all to singular maintaining; "
       "restricted DOFs "
       "rise by one; slide in both",
       {{"translation.maintaining", -2},
        {"translation.detaching", -1},
        {"translation.singular_maintaining", 3},
        {"translation.restricted", 1},
        {"rotation.maintaining", -2},
        {"rotation.detaching", -1},
        {"rotation.singular_maintaining", 3},
        {"rotation.restricted", 1}},
       {SubSkill::kSlideInTranslation, SubSkill::kSlideInRotation},
       false},
      {"singular maintaining DOFs fall by three, two to maintaining and one to detaching, in both motions; "
       "part of the next "
       "sub-skill; not critical",
       {{"translation.singular_maintaining", -3},
        {"translation.maintaining", 2},
        {"translation.detaching", 1},
        {"rotation.singular_maintaining", -3},
        {"rotation.maintaining", 2},
        {"rotation.detaching", 1}},
       {},
       false},
      {"the same DOF-transitions and sub-skills as in transition (1)", OneMaintainingToDetaching(), kAlign,
       false},
      {"maintaining DOFs fall by one, to singular maintaining, in both motions; the restricted DOF rises in "
       "rotation only; "
       "slide in rotation only",
       {{"translation.maintaining", -1},
        {"rotation.maintaining", -1},
        {"translation.restricted", 0},
        {"rotation.restricted", 1}},
       {SubSkill::kSlideInRotation},
       false,
       "The text names the maintaining DOFs only. All indices of a singular relation are singular, so the "
       "two detaching "
       "DOFs of E in each motion become singular maintaining as well: 3 in all, not 1."},
      {"a singular maintaining DOF becomes constraining in translation, two in rotation; critical",
       {{"translation.constraining", 1}, {"rotation.constraining", 2}},
       {},
       true,
       "Read as the total change, 'a singular maintaining DOF falls by one, by two in rotation' does not "
       "come out: it falls "
       "from 3 to 0 in both motions, as it must when a relation stops being singular. Read as the share that "
       "becomes "
       "constraining it does; the other share, two in translation and one in rotation, becomes maintaining, "
       "which the text "
       "leaves out here and counts as part of the next sub-skill in transition (3)."},
      {"the same DOF-transitions and sub-skills as in transition (1)", OneMaintainingToDetaching(), kAlign,
       false}};
  return words;
}

int Change(const SeenRelation& before, const SeenRelation& after, const std::string& index) {
  const auto value = [&](const algebra::MotionDof& dof) {
    const size_t dot = index.find('.');
    const auto motion =
        index.substr(0, dot) == "translation" ? algebra::Motion::kTranslation : algebra::Motion::kRotation;
    const std::string kind = index.substr(dot + 1);
    if (kind == "restricted") return Restricted(dof, motion);
    for (int i = 0; i < algebra::kDofIndices; ++i) {
      if (ToString(static_cast<algebra::DofIndex>(i)) == kind) return Indices(dof, motion)[i];
    }
    throw InvariantError("no index " + index);
  };
  return value(after.dof) - value(before.dof);
}

Figure Draw(const Insertion& insertion, size_t i, const View& view) {
  const SeenRelation& r = insertion.seen.relations[i];
  std::vector<DrawnSolid> solids = {
      {insertion.models.fixed, Part::kFixed},
      {Transform(insertion.models.moving, insertion.states[r.first - 1].pose.pose), Part::kMoving}};
  const auto& [t, w] = std::tie(r.dof.translation, r.dof.rotation);
  std::ostringstream caption;
  caption << r.name << (r.dof.singular ? " (singular)" : "") << ": m d c " << t.maintaining << ' '
          << t.detaching << ' ' << t.constraining << " in translation, " << w.maintaining << ' '
          << w.detaching << ' ' << w.constraining << " in rotation; restricted " << t.restricted << " and "
          << w.restricted;
  return {caption.str(), DrawContactRelation(solids, r.relation, view)};
}

Certificate Evidence(const Insertion& insertion, const std::string& id, size_t transition,
                     const Changes& expects) {
  const auto& relations = insertion.seen.relations;
  return TransitionsCertificate(id, id,
                                {{relations[transition].name, relations[transition].relation},
                                 {relations[transition + 1].name, relations[transition + 1].relation}},
                                {{0, expects}});
}

std::string IdOfTransition(size_t t) { return "thesis.2.8.2.transition-" + std::to_string(t + 1); }

Outcome TryTransition(size_t t) {
  const Insertion insertion = WatchInsertion();
  Outcome outcome;
  const Words& words = TextOfTransitions()[t];
  if (insertion.seen.relations.size() != TextOfTransitions().size() + 1) {
    outcome.verdict = Verdict::kNotReproduced;
    outcome.evidence = "The example's poses give another number of contact relations than A to H.";
    return outcome;
  }
  const SeenRelation &before = insertion.seen.relations[t], &after = insertion.seen.relations[t + 1];
  const algebra::Transition& seen = insertion.seen.transitions[t];
  bool agrees = seen.sub_skills == words.sub_skills && seen.critical == words.critical;
  Table table{"What the text says and what the geometry gives", {"index", "text", "geometry"}, {}};
  for (const auto& [index, change] : words.changes) {
    const int got = Change(before, after, index);
    agrees = agrees && got == change;
    table.rows.push_back({index, std::to_string(change), std::to_string(got)});
  }
  outcome.verdict = agrees ? Verdict::kReproduced : Verdict::kNotReproduced;
  outcome.bound = "one demonstration, exact poses (examples/peg_in_hole)";
  outcome.evidence = "The text: " + words.quote + ".\n\nFrom geometry alone: " + seen.why;
  if (!words.silence.empty()) outcome.evidence += "\n\n" + words.silence;
  outcome.tables = {std::move(table)};
  outcome.figures = {Draw(insertion, t, AlongAxis('y')), Draw(insertion, t + 1, AlongAxis('y'))};
  if (agrees) outcome.certificates = {Evidence(insertion, IdOfTransition(t), t, words.changes)};
  return outcome;
}

Outcome TryRelations(Effort) {
  const Insertion insertion = WatchInsertion();
  Outcome outcome;
  outcome.verdict = insertion.seen.relations.size() == 8 ? Verdict::kReproduced : Verdict::kNotReproduced;
  outcome.bound = "one demonstration, exact poses (examples/peg_in_hole)";
  Table table{"The contact relations (singular DOFs where so marked)", {"relation"}, {}};
  for (const std::string& cell : DofHeader()) table.header.push_back(cell.empty() ? "kind" : cell);
  std::vector<std::pair<std::string, algebra::ContactRelation>> relations;
  for (const SeenRelation& r : insertion.seen.relations) {
    table.rows.push_back({r.name});
    for (const std::string& cell : DofCells(r.dof)) table.rows.back().push_back(cell.empty() ? "-" : cell);
    relations.emplace_back(r.name, r.relation);
  }
  outcome.tables = {std::move(table)};
  View view;
  view.width = 420;
  for (size_t i = 0; i < insertion.seen.relations.size(); ++i)
    outcome.figures.push_back(Draw(insertion, i, view));
  outcome.certificates = {
      TransitionsCertificate("thesis.2.8.2.relations", "thesis.2.8.2.relations", relations, {})};
  outcome.evidence =
      "The figure is lost; its eight relations are worked out from the text and given as exact poses of a "
      "peg 4 wide in a slot 4 wide: "
      "nothing touches; a tilted peg's bottom edge on the block; that edge on the near rim; the near rim on "
      "the bottom face, the edge inside; the "
      "far rim on the side face as well; upright with both bottom edges on both rims; inside with both walls "
      "flush; seated.\n\n"
      "E is where a free choice ends. Two line contacts are needed (m = 1 and restricted DOFs 2 and 2 before "
      "F). The edge on the far wall, which "
      "comes to mind first, cannot be one of them: with the near rim on the bottom face, the bottom would "
      "have to span the slot "
      "at a tilt, 4 / cos(tilt), and it is 4 long; so without clearance it fits at tilt zero only. The near "
      "rim on the bottom face "
      "and the far rim on the side face do it, for every tilt: the edge between them runs on the circle over "
      "the two rims (Thales), down to F.\n\n"
      "In the drawings a blue dot is a contacting point with one separate plane, a magenta diamond one with "
      "several, hollow where the peg hides it; an arrow is a plane's normal, to its legal side, and a ring "
      "is a "
      "normal along the line of sight. m d c are the maintaining, detaching and constraining DOFs.";
  return outcome;
}

}  // namespace

std::vector<Claim> PegInsertionClaims() {
  std::vector<Claim> claims = {{"thesis.2.8.2.relations",
                                "The peg insertion passes through eight contact relations, A to H.",
                                "2.8.2, Fig. 2.23", "symbolic", TryRelations}};
  for (size_t t = 0; t < TextOfTransitions().size(); ++t) {
    claims.push_back({IdOfTransition(t),
                      "Transition (" + std::to_string(t + 1) + "): " + TextOfTransitions()[t].quote + ".",
                      "2.8.2, transition (" + std::to_string(t + 1) + ")", "symbolic",
                      [t](Effort) { return TryTransition(t); }});
  }
  return claims;
}

}  // namespace tact::provers
