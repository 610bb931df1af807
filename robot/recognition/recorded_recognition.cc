#include "robot/recognition/recorded_recognition.h"

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "robot/recognition/relation_sequence.h"

namespace tact::recognition {
namespace {

using joint::Transform;

constexpr int kNoiseRounds = 6;
constexpr double kNoiseRange = 8;  // estimated noise stays within the first guess times and by this

// Each scene's best candidate by itself says how large errors are.
PoseNoise EstimateNoise(const ProximitySolid& moving, const ProximitySolid& fixed,
                        const std::vector<NamedTransform>& scenes, double reward) {
  const PoseNoise first{kFirstRotation, kFirstRotation * moving.diameter() / 2};
  PoseNoise noise = first;
  for (int round = 0; round < kNoiseRounds; ++round) {
    Eigen::Vector2d squares = Eigen::Vector2d::Ones(),
                    shares = Eigen::Vector2d::Ones();  // the guess counts as one
    for (const NamedTransform& scene : scenes) {
      const auto candidates =
          FindRelationCandidates(moving, fixed, scene.X_FM, {.noise = noise, .reward = reward});
      const RelationCandidate& best = candidates.front();
      squares += Eigen::Vector2d(best.change.head<3>().squaredNorm(), best.change.tail<3>().squaredNorm());
      shares += best.share;
    }
    const auto better = [](double now, double factor, double start) {
      return std::clamp(now * factor, start / kNoiseRange, start * kNoiseRange);
    };
    noise = {better(noise.rotation, std::sqrt(squares[0] / shares[0]), first.rotation),
             better(noise.location, std::sqrt(squares[1] / shares[1]), first.location)};
  }
  return noise;
}

class Recording {
 public:
  Recording(const ModelPair& models, const RecordingSearch& search)
      : models_(models), search_(search), moving_(models.moving), fixed_(models.fixed) {}

  RecordedRecognition Run(const std::vector<NamedTransform>& scenes) {
    RecordedRecognition answer;
    answer.noise = search_.noise ? *search_.noise : EstimateNoise(moving_, fixed_, scenes, search_.reward);
    for (size_t i = 0; i < scenes.size(); ++i) {
      RecognizedScene scene = Scene(scenes[i], answer.noise);
      scene.number = i + 1;
      if (scene.candidates.empty()) {
        answer.skipped.push_back(scene.name);
      } else {
        answer.scenes.push_back(std::move(scene));
      }
    }
    if (answer.scenes.empty()) {
      throw InputError(
          "expected poses that errors of the tracker explain, got one solid deep inside the other in every "
          "scene; "
          "check units and frames, or give a larger --noise");
    }
    std::vector<std::vector<double>> costs;
    for (const RecognizedScene& scene : answer.scenes) {
      costs.emplace_back();
      for (const SceneCandidate& candidate : scene.candidates) costs.back().push_back(candidate.cost);
    }
    const auto sequence = FindRelationSequence(costs, [&](size_t k, size_t from, size_t to) {
      return Step(answer.scenes[k - 1].candidates[from], answer.scenes[k].candidates[to]);
    });
    std::vector<input::NamedPose> states;
    for (size_t k = 0; k < answer.scenes.size(); ++k) {
      RecognizedScene& scene = answer.scenes[k];
      scene.chosen = sequence.chosen[k];
      states.push_back({scene.name, {scene.candidates[scene.chosen].X_FM, true}, "scene " + scene.name});
      if (k == 0) continue;
      const RecognizedScene& before = answer.scenes[k - 1];
      const auto best = Validity(before.candidates.front(), scene.candidates.front());
      if (!best.valid()) answer.rejected.push_back({k, best});
      const auto chosen = Validity(before.candidates[before.chosen], scene.candidates[scene.chosen]);
      if (!chosen.valid()) answer.gaps.push_back({k, chosen});
    }
    ModelPair exactly = models_;
    exactly.tolerance = 0;
    answer.recognition = Recognize(exactly, states);
    for (SeenRelation& relation : answer.recognition.relations) {
      relation.first = answer.scenes[relation.first - 1].number;
      relation.last = answer.scenes[relation.last - 1].number;
    }
    return answer;
  }

 private:
  TransitionValidity Validity(const SceneCandidate& from, const SceneCandidate& to) const {
    return ValidityOf({from.found.primitives, from.dof}, {to.found.primitives, to.dof}, models_.moving,
                      models_.fixed);
  }
  double Step(const SceneCandidate& from, const SceneCandidate& to) const {
    if (SameElements(from.found.primitives, to.found.primitives)) return 0;
    return search_.change + (Validity(from, to).valid() ? 0 : search_.invalid);
  }

  RecognizedScene Scene(const NamedTransform& seen, const PoseNoise& noise) const {
    RecognizedScene scene;
    scene.name = seen.name;
    scene.seen_FM = seen.X_FM;
    // The most plausible few, further ones until one has an exact pose, and the empty relation: nothing may touch.
    size_t tried = 0;
    for (const RelationCandidate& candidate :
         FindRelationCandidates(moving_, fixed_, seen.X_FM, {.noise = noise, .reward = search_.reward})) {
      if (tried++ < search_.candidates || scene.candidates.empty() || candidate.contacts.empty())
        Try(candidate, noise, &scene);
    }
    std::stable_sort(scene.candidates.begin(), scene.candidates.end(),
                     [](const auto& a, const auto& b) { return a.cost < b.cost; });
    return scene;
  }

  void Try(const RelationCandidate& candidate, const PoseNoise& noise, RecognizedScene* scene) const {
    ExactPose exact = FindExactPose(models_.moving, models_.fixed, candidate.contacts, candidate.X_FM);
    if (!exact.X_FM) {
      ++scene->left_out;
      return;
    }
    const bool again =
        std::any_of(scene->candidates.begin(), scene->candidates.end(), [&](const auto& other) {
          return SameElements(other.found.primitives, exact.found.primitives) &&
                 other.found.relation.singular() == exact.found.relation.singular();
        });
    if (again) return;
    SceneCandidate tried;
    tried.X_FM = *exact.X_FM;
    tried.found = std::move(exact.found);
    tried.dof = ComputeMotionDof(tried.found.relation);
    const Transform X = joint::ToTransform(tried.X_FM);
    const Eigen::Vector3d middle = moving_.middle();
    tried.turned = joint::RotationLog(X.R * scene->seen_FM.R.transpose()).norm();
    tried.moved = (X * middle - scene->seen_FM * middle).norm();
    tried.cost =
        (std::pow(tried.turned / noise.rotation, 2) + std::pow(tried.moved / noise.location, 2)) / 2 -
        search_.reward * tried.dof.all.restricted + (tried.dof.singular ? search_.coincidence : 0);
    scene->candidates.push_back(std::move(tried));
  }

  const ModelPair& models_;
  const RecordingSearch& search_;
  ProximitySolid moving_, fixed_;
};

}  // namespace

RecordedRecognition RecognizeRecording(const ModelPair& models, const std::vector<NamedTransform>& scenes,
                                       const RecordingSearch& search) {
  if (scenes.empty()) throw PreconditionError("RecognizeRecording: no scenes");
  return Recording(models, search).Run(scenes);
}

}  // namespace tact::recognition
