#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "enumerators/shown_transitions.h"
#include "provers/claims/claims.h"
#include "provers/claims/peg_insertion.h"
#include "provers/path_certificate.h"
#include "robot/perception/random_numbers.h"
#include "robot/recognition/recorded_recognition.h"

namespace tact::provers {
namespace {

using recognition::RecordedRecognition;
using recognition::SameElements;
using recognition::TransitionValidity;
using recognition::ValidityOf;

struct Step {
  std::string name;
  TransitionValidity validity;
};

// What happens between the solids of a scene, and the seven transitions of the peg insertion: motions that are there.
std::vector<Step> RealSteps() {
  std::vector<Step> steps;
  for (const enumerators::ShownScene& shown : enumerators::ShowScenes()) {
    const algebra::Scene& scene = shown.given.scene;
    const algebra::PathContacts path = FollowScene(scene);
    steps.push_back(
        {shown.given.story,
         ValidityOf({path.middle.primitives, shown.dof_before}, {path.end.primitives, shown.dof_after},
                    UnionOfHulls(scene.moving_pieces), UnionOfHulls(scene.fixed_pieces))});
  }
  const Insertion insertion = WatchInsertion();
  const auto& relations = insertion.seen.relations;
  for (size_t i = 0; i + 1 < relations.size(); ++i) {
    steps.push_back({"peg insertion, " + relations[i].name + " to " + relations[i + 1].name,
                     ValidityOf({relations[i].primitives, relations[i].dof},
                                {relations[i + 1].primitives, relations[i + 1].dof}, insertion.models.moving,
                                insertion.models.fixed)});
  }
  return steps;
}

Outcome TryInclusion(Effort) {
  Outcome outcome;
  outcome.verdict = Verdict::kHoldsTo;
  long long included = 0;
  const auto steps = RealSteps();
  for (const Step& step : steps) {
    included += step.validity.included ? 1 : 0;
    if (step.validity.included) continue;
    outcome.verdict = Verdict::kRefuted;
    outcome.no_certificate = "The scene is in the ledger's drawings: " + step.name;
  }
  outcome.bound = std::to_string(steps.size()) + " motions of solids, exact from end to end";
  outcome.evidence =
      "A relation includes a contact primitive of the other if one of its own has the same elements, or "
      "elements "
      "that hold or bound them: what touches before the end still touches at the end, where more does. Sets "
      "of "
      "point contacts will not do for states that are samples: an edge that sticks out of a face touches it "
      "with "
      "other points when it has slid a little, in the same relation.";
  outcome.numbers = {{"motions", static_cast<long long>(steps.size())}, {"included", included}};
  return outcome;
}

// A relation whose constraining DOFs are not zero is not left for none at all by any small motion.
Outcome TryInverse(Effort) {
  const Insertion insertion = WatchInsertion();
  const auto& free = insertion.seen.relations.front();
  const auto& seated = insertion.seen.relations.back();
  const TransitionValidity validity = ValidityOf({free.primitives, free.dof}, {seated.primitives, seated.dof},
                                                 insertion.models.moving, insertion.models.fixed);
  Outcome outcome;
  const bool stays = seated.dof.translation.constraining > 0;
  outcome.verdict = validity.included && stays ? Verdict::kProved : Verdict::kUndecided;
  outcome.bound = "one example";
  outcome.evidence =
      "The peg on the slot's bottom includes every contact of the peg in the air: there are none. Yet no "
      "motion "
      "leads from one to the other without another relation between: with a constraining DOF in translation "
      "the "
      "two walls stay in contact under every legal motion, until the slot's mouth.";
  outcome.numbers = {{"constraining_in_translation", seated.dof.translation.constraining}};
  const std::string id = "thesis.2.7.4.inverse";
  outcome.certificates = {MotionDofCertificate(id + ".seated", id, seated.relation,
                                               {{{{"translation.constraining", 1}}, "positive"}})};
  return outcome;
}

Outcome TryPracticalFilter(Effort) {
  Outcome outcome;
  long long rejected = 0;
  Table table{"Motions that are there, and rejected", {"motion"}, {}};
  const auto steps = RealSteps();
  for (const Step& step : steps) {
    if (step.validity.practical) continue;
    ++rejected;
    table.rows.push_back({step.name});
  }
  outcome.verdict = rejected > 0 ? Verdict::kRefuted : Verdict::kHoldsTo;
  outcome.bound = std::to_string(steps.size()) + " motions of solids, exact from end to end";
  outcome.evidence =
      "The thesis rejects a transition with a DOF-transition other than the twenty that it calls practical. "
      "Solids "
      "that move as they must show the other ten as well: such a filter rejects what happened. It is right "
      "as a "
      "prior: none of the peg insertion's seven transitions is rejected, so tact weighs it as one.";
  outcome.numbers = {{"motions", static_cast<long long>(steps.size())}, {"rejected", rejected}};
  const std::string id = "thesis.2.7.4.practical-filter";
  const auto first =
      std::find_if(steps.begin(), steps.end(), [](const Step& step) { return !step.validity.practical; });
  if (first != steps.end()) {
    const auto place = static_cast<size_t>(first - steps.begin());
    outcome.certificates = {
        PathCertificate(id + ".rejected", id, enumerators::DofTransitionScenes().at(place).scene)};
  }
  if (!table.rows.empty()) outcome.tables = {std::move(table)};
  return outcome;
}

// The insertion as a tracker would record it: each state some times, each time with other errors.
struct Watched {
  int relations = 0, found = 0, in_order = 0;  // of the eight; sequences with all of them
};

constexpr int kTimes = 4;  // scenes a state

void WatchNoisily(const Insertion& insertion, double degrees, double length, std::uint64_t seed,
                  Watched* watched, std::vector<int>* found_by_state) {
  perception::RandomNumbers random(seed);
  const double radian = degrees * std::numbers::pi / 180;
  std::vector<recognition::NamedTransform> scenes;
  for (const auto& state : insertion.states) {
    for (int time = 0; time < kTimes; ++time) {
      joint::Transform X = joint::ToTransform(state.pose.pose);
      X.R = joint::RotationExp(radian *
                               Eigen::Vector3d(random.Gaussian(), random.Gaussian(), random.Gaussian())) *
            X.R;
      X.p += length * Eigen::Vector3d(random.Gaussian(), random.Gaussian(), random.Gaussian());
      scenes.push_back({state.name, X});
    }
  }
  const RecordedRecognition seen = RecognizeRecording(
      insertion.models, scenes, {.noise = recognition::PoseNoise{radian, length}, .candidates = 12});
  int found = 0;
  std::vector<int> right(insertion.states.size());
  for (const recognition::RecognizedScene& scene : seen.scenes) {
    const size_t i = (scene.number - 1) / kTimes;
    if (SameElements(scene.candidates[scene.chosen].found.primitives, insertion.seen.relations[i].primitives))
      ++right[i];
  }
  for (size_t i = 0; i < right.size(); ++i) {
    (*found_by_state)[i] += right[i];
    found += 2 * right[i] > kTimes ? 1 : 0;
  }
  watched->relations += static_cast<int>(insertion.states.size());
  watched->found += found;
  watched->in_order += found == static_cast<int>(insertion.states.size()) ? 1 : 0;
}

Outcome TryNoisyInsertion(Effort effort) {
  const Insertion insertion = WatchInsertion();
  const int trials = effort == Effort::kQuick ? 2 : effort == Effort::kStandard ? 10 : 50;
  Table table{"Scenes recognized as the state they are of (%), by state; the peg is 4 long, a unit",
              {"errors (deg, length)"},
              {}};
  for (const auto& state : insertion.states) table.header.push_back(state.name);
  table.header.emplace_back("states by majority");
  Outcome outcome;
  long long found = 0, relations = 0;
  const std::vector<std::pair<double, double>> levels = {{0.25, 0.01}, {1, 0.05}, {2, 0.1}};
  for (const auto& [degrees, length] : levels) {
    Watched watched;
    std::vector<int> by_state(insertion.states.size());
    for (int trial = 0; trial < trials; ++trial)
      WatchNoisily(insertion, degrees, length, static_cast<std::uint64_t>(trial) + 1, &watched, &by_state);
    std::vector<std::string> row = {fmt::format("{}, {}", degrees, length)};
    for (const int right : by_state) row.push_back(fmt::format("{:.0f}", 100.0 * right / (kTimes * trials)));
    row.push_back(fmt::format("{} of {}", watched.found, watched.relations));
    table.rows.push_back(std::move(row));
    if (found == 0) found = watched.found, relations = watched.relations;
  }
  outcome.verdict = 10 * found >= 9 * relations ? Verdict::kReproduced : Verdict::kNotReproduced;
  outcome.bound =
      fmt::format("{} recordings of {} scenes a level of errors", trials, insertion.states.size() * kTimes);
  outcome.evidence =
      "The thesis recognizes the peg insertion from a stereo camera's poses, singular relations among them, "
      "which it explains by rough estimation that prefers relations with more contact primitives. Here the "
      "insertion's eight states are recorded with Gaussian errors, and the most plausible sequence of "
      "contact "
      "relations is found: reproduced if with the smallest errors nine of ten states are. With larger ones "
      "the "
      "singular relations (C, F) are lost first: a corner on a rim is a coincidence that nothing holds in "
      "place.";
  outcome.numbers = {{"states", relations}, {"found_with_small_errors", found}};
  outcome.tables = {std::move(table)};
  return outcome;
}

}  // namespace

std::vector<Claim> WatchedInsertionClaims() {
  return {{"thesis.2.7.4.inclusion",
           "Of two contact relations between which a transition is valid, one includes every contact "
           "primitive of "
           "the other.",
           "2.7.4", "exhaustive", TryInclusion},
          {"thesis.2.7.4.inverse", "That one relation includes the other does not make the transition valid.",
           "2.7.4", "exhaustive", TryInverse},
          {"thesis.2.7.4.practical-filter",
           "A transition with a DOF-transition that is not one of the twenty practical ones is invalid.",
           "2.7.4", "exhaustive", TryPracticalFilter},
          {"thesis.2.8.1.insertion-watched",
           "From noisy poses the system recognizes the contact relations of the peg insertion, singular ones "
           "among them.",
           "2.8.1, Figures 2.20 and 2.22", "simulation", TryNoisyInsertion}};
}

}  // namespace tact::provers
