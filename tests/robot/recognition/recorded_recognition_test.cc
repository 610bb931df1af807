#include "robot/recognition/recorded_recognition.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "algebra/error.h"
#include "robot/input/recorded_demonstration.h"
#include "robot/perception/random_numbers.h"
#include "tests/robot/recognition/peg_states.h"

namespace tact::recognition {
namespace {

constexpr double kDegree = M_PI / 180;

// Every state three times, each with other errors.
std::vector<NamedTransform> Recorded(const PegStates& states, double degrees, double length, unsigned seed) {
  perception::RandomNumbers random(seed);
  const auto normal = [&random] {
    return Eigen::Vector3d(random.Gaussian(), random.Gaussian(), random.Gaussian());
  };
  std::vector<NamedTransform> scenes;
  for (const auto& state : states.demonstration.states) {
    for (int time = 0; time < 3; ++time) {
      joint::Transform X = ToTransform(state.pose.pose);
      X.R = joint::RotationExp(degrees * kDegree * normal()) * X.R;
      X.p += length * normal();
      scenes.push_back({state.name, X});
    }
  }
  return scenes;
}

TEST_F(PegStates, RecordedWithErrorsTheInsertionIsRecognized) {
  const auto seen = RecognizeRecording(models, Recorded(*this, 0.5, 0.02, 1),
                                       {.noise = PoseNoise{0.5 * kDegree, 0.02}, .candidates = 12});
  for (size_t i = 0; i < demonstration.states.size(); ++i) {
    const auto& state = demonstration.states[i];
    const auto right = ContactsInPose(models, state.pose.pose, state.where);
    if (right.relation.singular()) continue;  // a coincidence that errors may hide
    for (size_t k = 3 * i; k < 3 * i + 3; ++k) {
      const RecognizedScene& scene = seen.scenes[k];
      EXPECT_TRUE(SameElements(scene.candidates[scene.chosen].found.primitives, right.primitives))
          << "state " << state.name << ", scene " << k + 1;
    }
  }
}

TEST_F(PegStates, ChosenPosesHaveTheirContactsExactly) {
  const auto seen = RecognizeRecording(models, Recorded(*this, 1, 0.05, 2));
  for (const RecognizedScene& scene : seen.scenes) {
    const SceneCandidate& chosen = scene.candidates[scene.chosen];
    const auto again = FindContacts(Transform(models.moving, chosen.X_FM), models.fixed, 0);
    EXPECT_FALSE(again.penetration);
    EXPECT_EQ(again.relation, chosen.found.relation);
  }
}

// The first guess is off by a factor of three and more.
TEST_F(PegStates, TheNoiseIsEstimated) {
  const auto seen = RecognizeRecording(models, Recorded(*this, 0.5, 0.02, 3));
  EXPECT_GT(seen.noise.rotation, 0.2 * kDegree);
  EXPECT_LT(seen.noise.rotation, 1.2 * kDegree);
  EXPECT_LT(seen.noise.location, 0.08);
}

TEST_F(PegStates, APoseDeepInsideIsLeftOut) {
  joint::Transform X = ToTransform(demonstration.states.back().pose.pose);
  X.p.x() += 1;  // into the wall
  const RecordingSearch search{.noise = PoseNoise{0.01, 0.01}};
  EXPECT_THROW(RecognizeRecording(models, {{"deep", X}}, search), InputError);
  const auto free = ToTransform(demonstration.states.front().pose.pose);
  const auto seen = RecognizeRecording(models, {{"before", free}, {"deep", X}, {"after", free}}, search);
  EXPECT_EQ(seen.skipped, (std::vector<std::string>{"deep"}));
  ASSERT_EQ(seen.recognition.relations.size(), 1U);
  EXPECT_EQ(seen.recognition.relations[0].last, 3U);
}

TEST(RecordedRecognition, TheRecordedPegGoesInAndEndsSeated) {
  const std::string list = std::string(TACT_SOURCE_DIR) + "/../shared/data/peg_in_hole/peg_in_hole.pose.list";
  if (!std::filesystem::exists(list)) GTEST_SKIP() << "no recordings beside the project";
  const auto recording = input::ReadRecording(list);
  const ModelPair models = LoadModels(recording.models);
  std::vector<NamedTransform> scenes;
  for (const auto& scene : recording.scenes) scenes.push_back({scene.name, scene.X_FM});
  const RecordedRecognition seen = RecognizeRecording(models, scenes);
  ASSERT_EQ(seen.scenes.size(), 41U);
  // By eye: in the air; an edge on the block's top; a side on the slot's rim; tilted between both rims; between the
  // walls; seated on the slot's bottom and on both shoulders.
  const auto& relations = seen.recognition.relations;
  std::vector<std::string> kinds;
  for (const SeenRelation& relation : relations) {
    std::string kind;
    for (const auto& primitive : relation.primitives) kind += (kind.empty() ? "" : ", ") + KindOf(primitive);
    kinds.push_back(kind);
  }
  EXPECT_EQ(kinds, (std::vector<std::string>{"", "edge-face", "face-edge", "face-edge, face-edge",
                                             "face-face, face-face",
                                             "face-face, face-face, face-face, face-face, face-face"}));
  const auto& dof = relations.back().dof;
  EXPECT_EQ(dof.translation.maintaining, 1);
  EXPECT_EQ(dof.translation.detaching, 1);
  EXPECT_EQ(dof.translation.constraining, 1);
  EXPECT_EQ(dof.rotation.restricted, 3);
  EXPECT_EQ(relations.back().last, 41U);
  for (const RejectedTransition& gap : seen.gaps) EXPECT_EQ(gap.scene, 32U);  // it is set upright unseen
}

}  // namespace
}  // namespace tact::recognition
