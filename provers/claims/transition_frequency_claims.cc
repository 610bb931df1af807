#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <mutex>
#include <optional>

#include "algebra/contact/contact_finder.h"
#include "algebra/contact/dof_transition.h"
#include "enumerators/transition_count.h"
#include "provers/certificate_writer.h"
#include "provers/claims/claims.h"
#include "provers/report/count_matrix.h"
#include "provers/report/solid_drawing.h"
#include "provers/report/text.h"

namespace tact::provers {
namespace {

using algebra::DofIndex;
using algebra::DofTransition;
using algebra::kDofIndices;
using algebra::Motion;
using enumerators::FamilySize;
using enumerators::Measure;
using enumerators::SolidPair;
using enumerators::TallyKey;
using enumerators::TransitionCount;
using enumerators::TransitionPlace;

constexpr std::array<Motion, 2> kMotions = {Motion::kTranslation, Motion::kRotation};
const std::vector<std::string> kNames = {"M", "D", "C", "SM", "SD", "SC"};

struct FamilyCount {
  std::string family;
  TransitionCount count;
};

struct Counted {
  std::vector<SolidPair> pairs;
  std::vector<FamilyCount> families;
  TransitionCount total;
};

Counted CountAll(FamilySize size) {
  Counted counted;
  counted.pairs = enumerators::SolidPairs(size);
  for (size_t unit = 0; unit < counted.pairs.size(); ++unit) {
    const TransitionCount count = CountTransitions(counted.pairs[unit], unit);
    if (counted.families.empty() || counted.families.back().family != counted.pairs[unit].family)
      counted.families.push_back({counted.pairs[unit].family, {}});
    Merge(&counted.families.back().count, count);
    Merge(&counted.total, count);
  }
  return counted;
}

// Counted once for all claims; they may ask on several threads.
const Counted& CountedFor(Effort effort) {
  static std::array<Counted, 3> counted;
  static std::array<std::once_flag, 3> done;
  const auto size = static_cast<size_t>(effort);
  std::call_once(done[size], [&] { counted[size] = CountAll(static_cast<FamilySize>(size)); });
  return counted[size];
}
static_assert(static_cast<int>(Effort::kQuick) == static_cast<int>(FamilySize::kSmall) &&
              static_cast<int>(Effort::kFull) == static_cast<int>(FamilySize::kLarge));

uint64_t Sum(const TransitionCount& count, Measure measure, bool opens, int motion, int from, int to) {
  uint64_t sum = 0;
  for (int lost = 0; lost <= 3; ++lost) sum += count.Count({measure, lost, opens, motion, from, to});
  return sum;
}

uint64_t BothWays(const TransitionCount& count, Measure measure, int motion, int from, int to) {
  return Sum(count, measure, false, motion, from, to) + Sum(count, measure, true, motion, from, to);
}

std::string Digits(uint64_t count) { return GroupedDigits(static_cast<long long>(count)); }

std::string Share(uint64_t part, uint64_t whole) {
  return whole == 0 ? "-" : ShortDecimal(100 * static_cast<double>(part) / static_cast<double>(whole)) + " %";
}

bool Practical(int from, int to) {
  return algebra::IsPractical({Motion::kTranslation, static_cast<DofIndex>(from), static_cast<DofIndex>(to)});
}

std::string Bound(const Counted& counted) {
  return Digits(counted.total.pairs) + " pairs of solids; all " + Digits(counted.total.borders) +
         " pairs of neighbouring contact formations by translation, and " + Digits(counted.total.tilts) +
         " found by tilting about axis-parallel lines through contacts; each both ways";
}

// ---- a transition as drawings and as a certificate

struct Shown {
  algebra::ContactRelation before, after;
  std::vector<Figure> figures;
};

Shown Show(const Counted& counted, const TallyKey& key, const TransitionPlace& place,
           const std::string& caption) {
  const SolidPair& pair = counted.pairs[place.unit];
  const enumerators::PlacePoses poses = PosesOf(place);
  Shown shown;
  for (const bool later : {false, true}) {
    const algebra::Polyhedron moving = Transform(pair.moving, later == key.opens ? poses.open : poses.border);
    const auto relation = FindContacts(moving, pair.fixed, 0).relation;
    View view;
    view.width = 420;
    shown.figures.push_back(
        {caption + ": " + pair.name + (later ? ", after" : ", before"),
         DrawContactRelation({{pair.fixed, Part::kFixed}, {moving, Part::kMoving}}, relation, view)});
    (later ? shown.after : shown.before) = relation;
  }
  return shown;
}

// The first place of the tally with that measure and those kinds; straight motions before tilts.
std::optional<std::pair<TallyKey, TransitionPlace>> FirstPlace(const TransitionCount& count, Measure measure,
                                                               bool opens, int motion, int from, int to) {
  for (const int lost : {1, 2, 3, 0}) {
    const TallyKey key{measure, lost, opens, motion, from, to};
    const auto at = count.tallies.find(key);
    if (at != count.tallies.end()) return std::pair(key, at->second.first);
  }
  return std::nullopt;
}

void AddExample(const Counted& counted, const std::string& id, const std::string& name,
                const std::string& caption, const std::pair<TallyKey, TransitionPlace>& at,
                Outcome* outcome) {
  Shown shown = Show(counted, at.first, at.second, caption);
  outcome->figures.insert(outcome->figures.end(), shown.figures.begin(), shown.figures.end());
  outcome->certificates.push_back(TransitionsCertificate(
      id + "." + name, id, {{"before", std::move(shown.before)}, {"after", std::move(shown.after)}}, {}));
}

// ---- 2.3.1: frequently and seldom

Table KindTable(const Counted& counted, int motion) {
  Table table{"How often each kind of DOF-transition appears in " +
                  ToString(kMotions[static_cast<size_t>(motion)]) + ", by direction",
              {"kind", "in Fig. 2.5", "closing", "opening"},
              {}};
  for (const FamilyCount& family : counted.families) table.header.push_back(family.family);
  for (int from = 0; from < kDofIndices; ++from) {
    for (int to = 0; to < kDofIndices; ++to) {
      if (from == to) continue;
      auto& row = table.rows.emplace_back();
      row = {kNames[static_cast<size_t>(from)] + " -> " + kNames[static_cast<size_t>(to)],
             Practical(from, to) ? "yes" : "no",
             Digits(Sum(counted.total, Measure::kByDirection, false, motion, from, to)),
             Digits(Sum(counted.total, Measure::kByDirection, true, motion, from, to))};
      for (const FamilyCount& family : counted.families)
        row.push_back(Digits(BothWays(family.count, Measure::kByDirection, motion, from, to)));
    }
  }
  return table;
}

// Both ways together; n of one direction closing is n of the other opening.
Table PassageTable(const Counted& counted) {
  Table table{"By what motion: the dimensions that a straight motion loses when it closes, or a tilt",
              {"pair", "in Fig. 2.5", "translation: one", "two", "three", "tilt", "rotation: one", "two",
               "three", "tilt"},
              {}};
  for (int a = 0; a < kDofIndices; ++a) {
    for (int b = a + 1; b < kDofIndices; ++b) {
      auto& row = table.rows.emplace_back();
      row = {kNames[static_cast<size_t>(a)] + " - " + kNames[static_cast<size_t>(b)],
             Practical(a, b) ? "yes" : "no"};
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

Table ReadingTable(const Counted& counted) {
  Table table{"By how a DOF-transition is read, both ways and both motions together",
              {"pair", "in Fig. 2.5", "by direction", "forced by the counts",
               "every falling with every rising", "of these no direction goes so"},
              {}};
  for (int a = 0; a < kDofIndices; ++a) {
    for (int b = a + 1; b < kDofIndices; ++b) {
      auto& row = table.rows.emplace_back();
      row = {kNames[static_cast<size_t>(a)] + " - " + kNames[static_cast<size_t>(b)],
             Practical(a, b) ? "yes" : "no"};
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
  return {opens ? "The same motions backwards: out of the formation where more touches."
                : "How often which DOF becomes which, by direction, when more comes into contact.",
          DrawCountMatrix(kNames, panels, impractical, "not among the 20 practical kinds of Fig. 2.5")};
}

std::string PairName(int from, int to) {
  return kNames[static_cast<size_t>(from)] + " - " + kNames[static_cast<size_t>(to)];
}

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
  const Counted& counted = CountedFor(effort);
  const std::string id = "thesis.2.3.1.seldom";
  Outcome outcome;
  outcome.bound = Bound(counted);
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
                 kNames[static_cast<size_t>(common.first)] + " -> " +
                     kNames[static_cast<size_t>(common.second)] + ", impractical and often met",
                 *at, &outcome);
      break;
    }
  }
  outcome.evidence +=
      "\n\nOf " + Digits(counted.total.formations) + " formations, " +
      Digits(counted.total.uneven_formations) +
      " were found to have motion DOFs in rotation that vary from place to place while the same elements "
      "touch "
      "(a regular tetrahedron between the walls of a slot is one that does, from standard effort on): motion "
      "DOFs "
      "depend on where the contacting points lie, not on which elements touch alone. So the DOFs before a "
      "transition are taken just before its end.";
  return outcome;
}

// ---- 2.3.1: what straight motions can do

Outcome TryStraightMotions(Effort effort) {
  const Counted& counted = CountedFor(effort);
  Outcome outcome;
  outcome.bound = Bound(counted);
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

// ---- 2.6: do the rules name a primitive?

std::string SkillNames(int named) {
  std::string text;
  for (int i = 0; i < 7; ++i) {
    if ((named >> i & 1) == 0) continue;
    text += (text.empty() ? "" : ", ") + ToString(static_cast<algebra::SubSkill>(i));
  }
  return text.empty() ? "none" : text;
}

// Make-contact, detach-contact, slide: one act, in one motion or in both.
int ActsOf(int named) {
  const auto has = [named](algebra::SubSkill skill) { return (named >> static_cast<int>(skill) & 1) != 0; };
  using enum algebra::SubSkill;
  return (has(kMakeContactInTranslation) || has(kType1MakeContactInRotation) ||
                  has(kType2MakeContactInRotation)
              ? 1
              : 0) +
         (has(kDetachContactInTranslation) || has(kDetachContactInRotation) ? 1 : 0) +
         (has(kSlideInTranslation) || has(kSlideInRotation) ? 1 : 0);
}

Outcome TryRulesDecide(Effort effort) {
  const Counted& counted = CountedFor(effort);
  const std::string id = "thesis.2.6.rules-decide";
  Outcome outcome;
  outcome.bound = Bound(counted);
  // [closing, opening][acts].
  std::array<std::array<uint64_t, 4>, 2> acts{};
  std::array<std::array<std::optional<std::pair<TallyKey, TransitionPlace>>, 4>, 2> first;
  std::array<uint64_t, 4> unnamed{};  // closing, no act: by whether the relation is singular before, after
  std::map<int, std::array<std::array<uint64_t, 2>, 2>> by_names;  // [closing, opening][translation, tilt]
  for (const auto& [key, tally] : counted.total.tallies) {
    if (key.measure != Measure::kSubSkills) continue;
    const size_t way = key.opens ? 1 : 0, number = static_cast<size_t>(ActsOf(key.to));
    acts[way][number] += tally.count;
    by_names[key.to][way][key.lost_dimensions == 0 ? 1 : 0] += tally.count;
    if (way == 0 && number == 0) unnamed[static_cast<size_t>(key.from)] += tally.count;
    auto& place = first[way][number];
    const auto rank = [](const TallyKey& k, const TransitionPlace& p) {
      return std::pair(k.lost_dimensions == 0, p.unit);
    };
    if (!place || rank(key, tally.first) < rank(place->first, place->second)) place = {key, tally.first};
  }
  Table names{"What the rules name where some motion DOF changes",
              {"sub-skills", "closing, straight", "closing, tilt", "opening, straight", "opening, tilt"},
              {}};
  for (const auto& [named, n] : by_names)
    names.rows.push_back(
        {SkillNames(named), Digits(n[0][0]), Digits(n[0][1]), Digits(n[1][0]), Digits(n[1][1])});
  Table numbers{"Acts named: make-contact, detach-contact, slide", {"", "none", "one", "two", "three"}, {}};
  for (const size_t way : {size_t{0}, size_t{1}}) {
    auto& row = numbers.rows.emplace_back();
    row = {way == 0 ? "closing" : "opening"};
    const uint64_t all = acts[way][0] + acts[way][1] + acts[way][2] + acts[way][3];
    for (const uint64_t n : acts[way]) row.push_back(Digits(n) + " (" + Share(n, all) + ")");
  }
  outcome.tables = {std::move(numbers), std::move(names)};
  const uint64_t none = acts[0][0] + acts[1][0], one = acts[0][1] + acts[1][1];
  const uint64_t more = acts[0][2] + acts[0][3] + acts[1][2] + acts[1][3];
  uint64_t same = 0, ambiguous = 0, critical = 0;
  for (const bool opens : {false, true}) {
    same += Sum(counted.total, Measure::kSameDofs, opens, 0, 0, 0);
    ambiguous += Sum(counted.total, Measure::kAmbiguous, opens, 0, 0, 0);
    critical += Sum(counted.total, Measure::kCritical, opens, 0, 0, 0);
  }
  const uint64_t closing_critical = Sum(counted.total, Measure::kCritical, false, 0, 0, 0);
  outcome.numbers = {{"no act named", static_cast<long long>(none)},
                     {"one act named", static_cast<long long>(one)},
                     {"two acts or more named", static_cast<long long>(more)},
                     {"make-contact and detach-contact named",
                      static_cast<long long>(Sum(counted.total, Measure::kMakeAndDetach, false, 0, 0, 0) +
                                             Sum(counted.total, Measure::kMakeAndDetach, true, 0, 0, 0))},
                     {"several fall and several rise", static_cast<long long>(ambiguous)},
                     {"critical", static_cast<long long>(critical)},
                     {"critical, closing", static_cast<long long>(closing_critical)},
                     {"no motion DOF changes", static_cast<long long>(same)}};
  outcome.verdict = none + more == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  const auto example = [&](size_t way, size_t number, const std::string& name, const std::string& caption) {
    if (first[way][number]) AddExample(counted, id, name, caption, *first[way][number], &outcome);
  };
  example(0, 0, "closing-none", "More comes into contact, and no sub-skill is named");
  example(1, 0, "opening-none", "Contacts open, and no sub-skill is named");
  example(0, 1, "closing-one", "One act is named");
  for (const size_t way : {size_t{0}, size_t{1}}) {
    for (const size_t number : {size_t{2}, size_t{3}})
      example(way, number, "two-" + std::to_string(2 * way + number), "Several acts are named");
  }
  outcome.evidence =
      "For every transition in which a motion DOF changes, the rules of 2.6 were asked, literally. "
      "Make-contact in "
      "translation, in rotation of Type I and of Type II count as one act, and so do the two ways to detach "
      "and to "
      "slide.\n\n" +
      std::string(more == 0 ? "Never do the rules name two acts that differ"
                            : "In " + Digits(more) + " transitions the rules name two acts or more") +
      "; they name none in " + Digits(none) + " of " + Digits(none + one + more) +
      " transitions. Backwards that is meant: leaving a singular relation counts as part of the next "
      "sub-skill (2.4.4). "
      "But forwards, " +
      Digits(acts[0][0]) +
      " transitions bring more into contact and are named by no rule: from singular relations " +
      Digits(unnamed[1]) + " into non-singular ones, as when an edge on an edge is laid down flush, and " +
      Digits(unnamed[3]) +
      " into singular ones, as when a part runs along an edge and meets a wall; from "
      "non-singular ones " +
      Digits(unnamed[0] + unnamed[2]) +
      ". What a robot does to bring more into contact is a make-contact, and no rule says so there. "
      "Corrected: a "
      "transition after which more touches, and that no rule names, is a make-contact.\n\nSeveral indices "
      "fall "
      "and several rise in " +
      Digits(ambiguous) +
      " transitions; there the text does not say which became which, and only the directions do "
      "(thesis.2.3.2.make-contact-rule and the claims after it).\n\nCritical are " +
      Digits(critical) + " transitions, " + Digits(closing_critical) +
      " of them closing: the narrow entrance is passed when rims are left for the walls, where fewer "
      "elements touch.";
  return outcome;
}

}  // namespace

std::vector<Claim> TransitionFrequencyClaims() {
  return {{"thesis.2.3.1.seldom",
           "The 20 practical kinds of DOF-transitions appear frequently, the other 10 seldom.",
           "2.3.1, Fig. 2.5", "exhaustive", TrySeldom},
          {"thesis.2.3.1.straight-motions",
           "By a straight motion constraint comes up only where a singular relation is left, and between "
           "non-singular "
           "relations only maintaining DOFs change, to detaching ones.",
           "2.3.1, added", "exhaustive", TryStraightMotions},
          {"thesis.2.6.rules-decide", "For every change of motion DOFs the rules name one sub-skill.", "2.6",
           "exhaustive", TryRulesDecide}};
}

}  // namespace tact::provers
