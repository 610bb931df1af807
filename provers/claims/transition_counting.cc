#include "provers/claims/transition_counting.h"

#include <array>
#include <mutex>

#include "algebra/contact/contact_finder.h"
#include "provers/certificate_writer.h"
#include "provers/report/solid_drawing.h"
#include "provers/report/text.h"

namespace tact::provers {
namespace {

using enumerators::FamilySize;
using enumerators::Measure;
using enumerators::SolidPair;
using enumerators::TallyKey;
using enumerators::TransitionCount;
using enumerators::TransitionPlace;

CountedFamilies CountAll(FamilySize size) {
  CountedFamilies counted;
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

struct Shown {
  algebra::ContactRelation before, after;
  std::vector<Figure> figures;
};

Shown Show(const CountedFamilies& counted, const TallyKey& key, const TransitionPlace& place,
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

}  // namespace

const CountedFamilies& FamiliesFor(Effort effort) {
  static std::array<CountedFamilies, 3> counted;
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

std::string BoundOf(const CountedFamilies& counted) {
  return Digits(counted.total.pairs) + " pairs of solids; all " + Digits(counted.total.borders) +
         " pairs of neighbouring contact formations by translation, and " + Digits(counted.total.tilts) +
         " found by tilting about axis-parallel lines through contacts; each both ways";
}

std::optional<CountedPlace> FirstPlace(const TransitionCount& count, Measure measure, bool opens, int motion,
                                       int from, int to) {
  for (const int lost : {1, 2, 3, 0}) {
    const TallyKey key{measure, lost, opens, motion, from, to};
    const auto at = count.tallies.find(key);
    if (at != count.tallies.end()) return std::pair(key, at->second.first);
  }
  return std::nullopt;
}

void AddExample(const CountedFamilies& counted, const std::string& claim, const std::string& name,
                const std::string& caption, const CountedPlace& at, Outcome* outcome) {
  Shown shown = Show(counted, at.first, at.second, caption);
  outcome->figures.insert(outcome->figures.end(), shown.figures.begin(), shown.figures.end());
  outcome->certificates.push_back(
      TransitionsCertificate(claim + "." + name, claim,
                             {{"before", std::move(shown.before)}, {"after", std::move(shown.after)}}, {}));
}

}  // namespace tact::provers
