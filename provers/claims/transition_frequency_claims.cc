#include <algorithm>
#include <array>
#include <limits>

#include "algebra/contact/motion_path.h"
#include "enumerators/lattice_solid.h"
#include "enumerators/shown_transitions.h"
#include "provers/claims/census.h"
#include "provers/claims/claims.h"
#include "provers/claims/transition_counting.h"
#include "provers/report/count_matrix.h"
#include "provers/report/solid_drawing.h"

namespace tact::provers {
namespace {

using algebra::DofIndex;
using algebra::kDofIndices;
using algebra::Motion;
using enumerators::Measure;
using enumerators::TransitionCount;

constexpr std::array<Motion, 2> kMotions = {Motion::kTranslation, Motion::kRotation};
std::string Name(int index) { return enumerators::Symbol(static_cast<DofIndex>(index)); }

bool Practical(int from, int to) {
  return algebra::IsPractical({Motion::kTranslation, static_cast<DofIndex>(from), static_cast<DofIndex>(to)});
}

// ---- 2.3.1: frequently and seldom

Table KindTable(const CountedFamilies& counted, int motion) {
  Table table{"How often each kind of DOF-transition appears in " +
                  ToString(kMotions[static_cast<size_t>(motion)]) + ", by direction",
              {"kind", "in Fig. 2.5", "closing", "opening"},
              {}};
  for (const FamilyCount& family : counted.families) table.header.push_back(family.family);
  for (int from = 0; from < kDofIndices; ++from) {
    for (int to = 0; to < kDofIndices; ++to) {
      if (from == to) continue;
      auto& row = table.rows.emplace_back();
      row = {Name(from) + " -> " + Name(to), Practical(from, to) ? "yes" : "no",
             Digits(Sum(counted.total, Measure::kByDirection, false, motion, from, to)),
             Digits(Sum(counted.total, Measure::kByDirection, true, motion, from, to))};
      for (const FamilyCount& family : counted.families)
        row.push_back(Digits(BothWays(family.count, Measure::kByDirection, motion, from, to)));
    }
  }
  return table;
}

// Both ways together; n of one direction closing is n of the other opening.
Table PassageTable(const CountedFamilies& counted) {
  Table table{"By what motion: the dimensions that a straight motion loses when it closes, or a tilt",
              {"pair", "in Fig. 2.5", "translation: one", "two", "three", "tilt", "rotation: one", "two",
               "three", "tilt"},
              {}};
  for (int a = 0; a < kDofIndices; ++a) {
    for (int b = a + 1; b < kDofIndices; ++b) {
      auto& row = table.rows.emplace_back();
      row = {Name(a) + " - " + Name(b), Practical(a, b) ? "yes" : "no"};
      for (int motion = 0; motion < 2; ++motion) {
        for (const int lost : {1, 2, 3, 0}) {
          row.push_back(Digits(counted.total.Count({Measure::kByDirection, lost, false, motion, a, b}) +
                               counted.total.Count({Measure::kByDirection, lost, false, motion, b, a})));
        }
      }
    }
  }
  return table;
}

Table ReadingTable(const CountedFamilies& counted) {
  Table table{"By how a DOF-transition is read, both ways and both motions together",
              {"pair", "in Fig. 2.5", "by direction", "forced by the counts",
               "every falling with every rising", "of these no direction goes so"},
              {}};
  for (int a = 0; a < kDofIndices; ++a) {
    for (int b = a + 1; b < kDofIndices; ++b) {
      auto& row = table.rows.emplace_back();
      row = {Name(a) + " - " + Name(b), Practical(a, b) ? "yes" : "no"};
      for (const Measure measure :
           {Measure::kByDirection, Measure::kForced, Measure::kAllPairs, Measure::kOnlyByCounts}) {
        uint64_t sum = 0;
        for (int motion = 0; motion < 2; ++motion)
          sum +=
              BothWays(counted.total, measure, motion, a, b) + BothWays(counted.total, measure, motion, b, a);
        row.push_back(Digits(sum));
      }
    }
  }
  return table;
}

Figure MatrixFigure(const TransitionCount& count, bool opens) {
  std::vector<CountPanel> panels;
  std::vector<std::vector<bool>> impractical(kDofIndices, std::vector<bool>(kDofIndices));
  for (int motion = 0; motion < 2; ++motion) {
    CountPanel panel{std::string(opens ? "Opening" : "Closing") + ", in " +
                         ToString(kMotions[static_cast<size_t>(motion)]),
                     {}};
    for (int from = 0; from < kDofIndices; ++from) {
      auto& row = panel.counts.emplace_back();
      for (int to = 0; to < kDofIndices; ++to) {
        row.push_back(from == to ? 0 : Sum(count, Measure::kByDirection, opens, motion, from, to));
        impractical[static_cast<size_t>(from)][static_cast<size_t>(to)] = from != to && !Practical(from, to);
      }
    }
    panels.push_back(std::move(panel));
  }
  std::vector<std::string> names;
  for (int i = 0; i < kDofIndices; ++i) names.push_back(Name(i));
  return {opens ? "The same motions backwards: out of the formation where more touches."
                : "How often which DOF becomes which, by direction, when more comes into contact.",
          DrawCountMatrix(names, panels, impractical, "not among the 20 practical kinds of Fig. 2.5")};
}

std::string PairName(int from, int to) { return Name(from) + " - " + Name(to); }

struct Range {
  uint64_t least = std::numeric_limits<uint64_t>::max(), most = 0, never = 0, kinds = 0;
  void Add(uint64_t count) {
    least = std::min(least, count);
    most = std::max(most, count);
    never += count == 0 ? 1 : 0;
    ++kinds;
  }
};

Outcome TrySeldom(Effort effort) {
  const CountedFamilies& counted = FamiliesFor(effort);
  const std::string id = "thesis.2.3.1.seldom";
  Outcome outcome;
  outcome.bound = BoundOf(counted);
  bool separated = true;
  std::string ranges;
  std::pair<int, int> common;  // the most frequent impractical kind
  uint64_t most = 0;
  std::array<std::string, 2> never;  // pairs of impractical and of practical kinds
  for (int motion = 0; motion < 2; ++motion) {
    Range practical, impractical;
    for (int from = 0; from < kDofIndices; ++from) {
      for (int to = 0; to < kDofIndices; ++to) {
        if (from == to) continue;
        const uint64_t count = BothWays(counted.total, Measure::kByDirection, motion, from, to);
        (Practical(from, to) ? practical : impractical).Add(count);
        if (count == 0 && from < to && motion == 0) {
          std::string& list = never[Practical(from, to) ? 1 : 0];
          list += (list.empty() ? "" : ", ") + PairName(from, to);
        }
        if (Practical(from, to) || motion == 1 || count <= most) continue;
        most = count;
        common = {from, to};
      }
    }
    separated = separated && practical.least > impractical.most;
    const std::string name = ToString(kMotions[static_cast<size_t>(motion)]);
    ranges += " In " + name + " a practical kind appears " + Digits(practical.least) + " to " +
              Digits(practical.most) + " times, an impractical one " + Digits(impractical.least) + " to " +
              Digits(impractical.most) + " times.";
    outcome.numbers.emplace_back(name + ": practical kinds never met",
                                 static_cast<long long>(practical.never));
    outcome.numbers.emplace_back(name + ": most frequent impractical kind",
                                 static_cast<long long>(impractical.most));
  }
  outcome.verdict = separated ? Verdict::kReproduced : Verdict::kNotReproduced;
  outcome.numbers.emplace_back("contact formations", static_cast<long long>(counted.total.formations));
  outcome.numbers.emplace_back("formations whose DOFs vary within them",
                               static_cast<long long>(counted.total.uneven_formations));
  outcome.tables = {KindTable(counted, 0), KindTable(counted, 1), PassageTable(counted),
                    ReadingTable(counted)};
  outcome.figures = {MatrixFigure(counted.total, false), MatrixFigure(counted.total, true)};
  outcome.evidence =
      "A contact formation is a connected set of poses at which the same elements touch. For solids with "
      "integer corners all formations by translation are found, and all pairs of which one is in the closure "
      "of the other: one pair is one transition closing, into the formation where more touches, and one "
      "opening. Counted is whether some direction of motion goes from the one kind to the other where the "
      "motion ends." +
      ranges;
  if (separated) {
    outcome.evidence += "\n\nA threshold separates the twenty from the ten.";
  } else {
    outcome.evidence +=
        "\n\nNo threshold separates the twenty from the ten. Never met in translation are, of the "
        "impractical "
        "pairs, " +
        (never[0].empty() ? "none" : never[0]) + "; of the practical ones, " +
        (never[1].empty() ? "none" : never[1]) +
        ". By a straight motion neither M nor D turns into C or SC (docs/dof-transitions.md, Theorem 3), and "
        "the tilts "
        "tried end where faces lie flush; turns that end in a jam would show D - C. The most frequent "
        "impractical "
        "pair is " +
        PairName(common.first, common.second) + ": " + Digits(most) +
        " times each way in translation. A part that runs along an edge and meets a "
        "wall, or leaves one, does that.\n\nWhat separates the twenty from the ten is not how many places "
        "there are for "
        "a kind, but what it takes to get there (thesis.2.3.1.practical-20): to hold a singular contact on "
        "the way, or "
        "to turn and meet two contacts at once.";
    for (const bool opens : {false, true}) {
      const auto at = FirstPlace(counted.total, Measure::kByDirection, opens, 0, common.first, common.second);
      if (!at) continue;
      AddExample(counted, id, "impractical",
                 Name(common.first) + " -> " + Name(common.second) + ", impractical and often met", *at,
                 &outcome);
      break;
    }
  }
  outcome.evidence +=
      "\n\nOf " + Digits(counted.total.formations) + " formations, " +
      Digits(counted.total.uneven_formations) +
      " were found to have motion DOFs that vary from place to place "
      "(thesis.2.3.same-elements); so the DOFs before a transition are taken just before its end.";
  return outcome;
}

// ---- 2.3: do the touching elements decide the DOFs?

Outcome TrySameElements(Effort) {
  const std::string id = "thesis.2.3.same-elements";
  // The hull of four corners of a cube no two of which share an edge, between walls as far apart as the cube is wide.
  const algebra::Polyhedron tetrahedron = enumerators::CornerHulls()[3];
  const algebra::Polyhedron slot =
      enumerators::LatticeSolid({{{0, 0, 0}, {3, 1, 2}}}, {{{1, 0, 1}, {2, 1, 2}}});
  const algebra::Polyhedron deep = Transform(tetrahedron, {{}, {1, {-1, 4}, 1}});
  const algebra::PathContacts path = FollowPath(deep, slot, algebra::MotionPath::Line({0, {-1, 2}, 0}));
  const algebra::MotionDof before = ComputeMotionDof(path.start.relation),
                           after = ComputeMotionDof(path.end.relation);
  const bool same = !path.event && enumerators::PairsOf(path.start) == enumerators::PairsOf(path.end);
  Outcome outcome;
  outcome.bound = "one motion of a tetrahedron in a slot";
  outcome.evidence =
      "A regular tetrahedron stands between the walls of a slot and is pulled along it by half its width. "
      "All the way the same elements touch, as the exact path shows. An edge's crossing and a vertex push it "
      "from either side, along two segments. Deep in the slot the segments cross, and the pushes block "
      "turning; "
      "half way out they come apart, and it can turn off one wall or the other.";
  if (!same || before == after) {
    outcome.evidence += " This did not come out.";
    return outcome;
  }
  outcome.verdict = Verdict::kRefuted;
  outcome.numbers = {{"constraining DOF in rotation, deep", before.rotation.constraining},
                     {"constraining DOF in rotation, far", after.rotation.constraining}};
  outcome.tables = {{"The same elements touch", DofHeader(), {DofCells(before), DofCells(after)}}};
  for (const auto& [name, at] :
       {std::pair("deep in the slot", &path.start), std::pair("far out", &path.end)}) {
    const algebra::Rational s = at == &path.start ? 0 : 1;
    outcome.figures.push_back(
        {std::string("The tetrahedron ") + name,
         DrawContactRelation({{slot, Part::kFixed},
                              {Transform(deep, {{}, {0, algebra::Rational(-1, 2) * s, 0}}), Part::kMoving}},
                             at->relation, {})});
  }
  outcome.certificates = {TransitionsCertificate(
      id + ".tetrahedron", id, {{"deep", path.start.relation}, {"far", path.end.relation}},
      {{0, {{"rotation.constraining", after.rotation.constraining - before.rotation.constraining}}}})};
  outcome.evidence +=
      "\n\nSo a contact relation is more than a list of elements: motion DOFs, and with them "
      "DOF-transitions in rotation, can change in the middle of a motion that makes and breaks no contact. "
      "DOFs in translation cannot, as long as the normals stay.";
  return outcome;
}

// ---- 2.3.1: what straight motions can do

Outcome TryStraightMotions(Effort effort) {
  const CountedFamilies& counted = FamiliesFor(effort);
  Outcome outcome;
  outcome.bound = BoundOf(counted);
  Table table{"Tried on every transition by a translation", {"law", "tried", "broken"}, {}};
  uint64_t broken = 0;
  const auto& laws = enumerators::TransitionLaws();
  for (size_t i = 0; i < laws.size(); ++i) {
    const int law = static_cast<int>(i);
    const uint64_t tried = BothWays(counted.total, Measure::kLawTried, 0, law, 0),
                   failed = BothWays(counted.total, Measure::kLawBroken, 0, law, 0);
    broken += failed;
    table.rows.push_back({laws[i].statement, Digits(tried), Digits(failed)});
    outcome.numbers.emplace_back(laws[i].id + " tried", static_cast<long long>(tried));
  }
  outcome.numbers.emplace_back("broken", static_cast<long long>(broken));
  outcome.verdict = broken == 0 ? Verdict::kHoldsTo : Verdict::kUndecided;
  outcome.tables = {std::move(table)};
  outcome.evidence =
      "docs/dof-transitions.md, Theorem 3, has the proof. Here it is held against every pair of neighbouring "
      "contact "
      "formations of the families, the relations found from the solids alone and the directions followed to "
      "the end of "
      "the motion.";
  if (broken != 0) outcome.evidence += " Some transitions break it: the theorem or the engine is wrong.";
  return outcome;
}

}  // namespace

std::vector<Claim> TransitionFrequencyClaims() {
  return {{"thesis.2.3.same-elements", "As long as the same elements touch, the motion DOFs stay the same.",
           "2.3, taken for granted", "symbolic", TrySameElements},
          {"thesis.2.3.1.seldom",
           "The 20 practical kinds of DOF-transitions appear frequently, the other 10 seldom.",
           "2.3.1, Fig. 2.5", "exhaustive", TrySeldom},
          {"thesis.2.3.1.straight-motions",
           "By a straight motion constraint comes up only where a singular relation is left, and between "
           "non-singular "
           "relations only maintaining DOFs change, to detaching ones.",
           "2.3.1, added", "exhaustive", TryStraightMotions},
          RulesDecideClaim()};
}

}  // namespace tact::provers
