/// @file
/// From a recording with a tracker's errors to contact relations, transitions and sub-skills [thesis, 2.7, 2.8].
/// Model   Of every scene the candidates of relation_candidates.h, as exact poses (exact_pose.h); those that penetrate or have
///         no exact pose nearby are left out. A candidate costs half its change's square, in units of the noise, minus
///         `reward` for each DOF that it restricts, plus `coincidence` if it is singular: a corner on an edge is passed,
///         nothing holds it there. A step between scenes
///         costs nothing if the same elements touch, `change` if not, and `invalid` more if transition_validity.h finds
///         no valid transition (scenes are samples: what lies between may not have been seen). The most plausible
///         sequence (relation_sequence.h) is recognized as exact states are.
///         Noise that is not given is estimated: a candidate's change should be as large as the noise makes it in the
///         DOFs that it takes away, rotation and location apart; from a start of kFirstRotation for the solid's reach.
/// Frames  the fixed solid's.
/// Exact   contacts, motion DOFs, transitions: of the exact poses.
/// Cost    a tenth of a second a scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/recognition/exact_pose.h"
#include "robot/recognition/posed_models.h"
#include "robot/recognition/recognition.h"
#include "robot/recognition/relation_candidates.h"
#include "robot/recognition/transition_validity.h"

namespace tact::recognition {

inline constexpr double kFirstRotation = 0.035;  // radian, 2 degrees: what stereo vision does

struct RecordingSearch {
  std::optional<PoseNoise> noise;
  double reward = 3, coincidence = 4, change = 2, invalid = 6;  // nat
  size_t candidates = 8;                                        // a scene, tried exactly
};

struct NamedTransform {
  std::string name;
  joint::Transform X_FM;
};

struct SceneCandidate {
  algebra::Pose X_FM;
  algebra::FoundContacts found;
  algebra::MotionDof dof;
  double turned = 0, moved = 0;  // from the pose seen: radian, and the solid's middle
  double cost = 0;
};

struct RecognizedScene {
  size_t number = 0;  // among the scenes given, from 1
  std::string name;
  joint::Transform seen_FM;
  std::vector<SceneCandidate> candidates;  // best first
  size_t chosen = 0;
  size_t left_out = 0;  // candidates without an exact pose
};

/// A step between scenes that is no valid transition, and why.
struct RejectedTransition {
  size_t scene = 0;  // the second's place among the recognized ones, from 0
  TransitionValidity validity;
};

struct RecordedRecognition {
  PoseNoise noise;
  std::vector<RecognizedScene> scenes;
  std::vector<std::string> skipped;          // names of scenes whose pose no exact one near it explains
  Recognition recognition;                   // of the chosen sequence; first and last are numbers of scenes
  std::vector<RejectedTransition> rejected;  // between the scenes' own best candidates
  std::vector<RejectedTransition> gaps;      // in the chosen sequence: what was passed there no scene shows
};

/// PreconditionError: no scenes. InputError: every scene is skipped.
RecordedRecognition RecognizeRecording(const ModelPair& models, const std::vector<NamedTransform>& scenes,
                                       const RecordingSearch& search = {});

}  // namespace tact::recognition
