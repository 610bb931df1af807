#include "robot/joint/consensus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "robot/joint/joint_jacobian.h"
#include "robot/joint/least_squares.h"

namespace tact::joint {
namespace {

constexpr std::size_t kMostJudges = 60;  // poses that judge a sample; more change the median little
constexpr double kFar = 9;              // of the median squared error: beyond, a pose does not count at first
constexpr double kLeastSquare = 1e-24;  // radian^2, metre^2: no error at all

int PosesOfSample(JointType type) {
  constexpr std::array<int, kJointTypes.size()> kCounts = {1, 2, 2, 3, 3, 3, 3, 6};
  return kCounts[static_cast<std::size_t>(type)];
}

// Numbers that every machine draws alike.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  std::size_t Below(std::size_t bound) { return engine_() % bound; }
  Eigen::Vector3d Direction() {
    for (;;) {
      const Eigen::Vector3d point(Symmetric(), Symmetric(), Symmetric());
      if (const double norm = point.norm(); norm > 0.1 && norm < 1) return point / norm;
    }
  }

 private:
  double Symmetric() { return static_cast<double>(engine_() >> 11) * 0x1p-52 - 1; }
  std::mt19937_64 engine_;
};

struct Errors {
  std::vector<double> rotation, translation;  // squared

  void Measure(const Joint& joint, std::span<const Transform> poses, std::size_t stride) {
    rotation.clear(), translation.clear();
    for (std::size_t i = 0; i < poses.size(); i += stride) {
      const Vector6 error = PoseError(joint, CoordinatesNear(joint, poses[i]), poses[i]);
      rotation.push_back(error.head<3>().squaredNorm());
      translation.push_back(error.tail<3>().squaredNorm());
    }
  }
};

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return std::max(*middle, kLeastSquare);
}

}  // namespace

Consensus FindConsensus(JointType type, std::span<const Transform> poses, int samples, std::uint64_t seed) {
  Draw draw(seed);
  const auto count = std::min(poses.size(), static_cast<std::size_t>(PosesOfSample(type)));
  const std::size_t stride = 1 + (poses.size() - 1) / kMostJudges;
  Joint best{type, {}, {}, 0, 0};
  double least = std::numeric_limits<double>::infinity();
  Errors errors;
  std::vector<std::size_t> chosen(count);
  std::vector<Transform> sample(count);
  for (int round = 0; round < samples; ++round) {
    for (std::size_t& index : chosen) index = draw.Below(poses.size());
    std::sort(chosen.begin(), chosen.end());
    for (std::size_t i = 0; i < count; ++i) sample[i] = poses[chosen[i]];
    Joint joint;
    if (type == JointType::kTwoAxis) {
      OrientationMoment moment;
      for (const Transform& X_BA : sample) moment.Add(X_BA.R);
      joint = FitCenters(PolishTwoAxes(moment, draw.Direction()), PassOver(sample));
    } else {
      joint = FitLeastSquares(type, sample);
    }
    errors.Measure(joint, poses, stride);
    const double score = std::log(Median(errors.rotation)) + std::log(Median(errors.translation));
    if (score < least) least = score, best = joint;
  }
  errors.Measure(best, poses, 1);
  const double rotation = kFar * Median(errors.rotation), translation = kFar * Median(errors.translation);
  Consensus consensus{best, {}};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    consensus.weights.push_back(errors.rotation[i] <= rotation && errors.translation[i] <= translation);
  }
  return consensus;
}

}  // namespace tact::joint
