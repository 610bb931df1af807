#include "provers/claims/joint_trials.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

#include "robot/perception/vision_noise.h"

namespace tact::provers {
namespace {

using Eigen::Vector3d;
using joint::Transform;

// SplitMix64 [Steele et al. 2014]. Its streams from neighbouring states are one stream, shifted: so a seed is mixed
// before it is the state.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(Mixed(Mixed(seed + 1) ^ seed)) {}
  // In [0, 1).
  double Uniform() { return static_cast<double>(Next() >> 11) * 0x1p-53; }
  Vector3d Direction() {
    const double z = 2 * Uniform() - 1, angle = 2 * std::numbers::pi * Uniform(), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  Eigen::Matrix3d Orientation() {
    // Two points on circles make a uniform unit quaternion [Shoemake 1992].
    const double u = Uniform(), a = 2 * std::numbers::pi * Uniform(), b = 2 * std::numbers::pi * Uniform();
    const double s = std::sqrt(1 - u), t = std::sqrt(u);
    return Eigen::Quaterniond(t * std::cos(b), s * std::sin(a), s * std::cos(a), t * std::sin(b))
        .toRotationMatrix();
  }

 private:
  static std::uint64_t Mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::uint64_t Next() { return Mixed(state_ += 0x9e3779b97f4a7c15); }
  std::uint64_t state_;
};

std::vector<joint::Coordinates> DrawCoordinates(const TrialSetup& setup, Random& random) {
  std::vector<joint::Coordinates> all(static_cast<size_t>(setup.poses), joint::Coordinates::Zero());
  const auto side = static_cast<size_t>(std::lround(std::sqrt(setup.poses)));
  for (size_t i = 0; i < all.size(); ++i) {
    for (int k = 0; k < joint::JointDof(setup.type); ++k) {
      double share = 0;
      switch (setup.placing) {
        case Placing::kEqual:
          share = static_cast<double>(i) / (setup.poses - 1);
          break;
        case Placing::kGrid:
          share = static_cast<double>(k == 0 ? i / side : i % side) / static_cast<double>(side - 1);
          break;
        case Placing::kRandom:
          share = random.Uniform();
          break;
      }
      all[i][k] = share * setup.amount;
    }
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
  return all;
}

}  // namespace

Trial DrawTrial(const TrialSetup& setup, std::uint64_t seed) {
  Random random(seed);
  Trial trial;
  trial.truth.type = setup.type;
  trial.truth.pitch = setup.pitch;
  for (Transform* frame : {&trial.truth.X_AJ, &trial.truth.X_BJ}) {
    frame->R = random.Orientation();
    frame->p = setup.distance * random.Direction();
  }
  for (const joint::Coordinates& q : DrawCoordinates(setup, random)) {
    const Transform X_BA = PoseAt(trial.truth, q);
    trial.exact.push_back(X_BA);
    trial.noisy.push_back(perception::AddVisionNoise(X_BA, {kMostTurn, kMostShift}, random));
  }
  return trial;
}

std::vector<std::vector<double>> RunTrials(
    int trials, int values, const std::function<void(std::uint64_t seed, double* values)>& measure) {
  std::vector<std::vector<double>> rows(static_cast<size_t>(values),
                                        std::vector<double>(static_cast<size_t>(trials)));
  std::atomic<int> next = 0;
  const auto work = [&] {
    std::vector<double> measured(static_cast<size_t>(values));
    for (int i = next++; i < trials; i = next++) {
      measure(static_cast<std::uint64_t>(i), measured.data());
      for (size_t k = 0; k < measured.size(); ++k) rows[k][static_cast<size_t>(i)] = measured[k];
    }
  };
  std::jthread second(work);
  work();
  second.join();
  return rows;
}

double LineAngle(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

int TrialsFor(Effort effort) {
  constexpr std::array trials = {200, 10000, 40000};
  return trials[static_cast<size_t>(effort)];
}

}  // namespace tact::provers
