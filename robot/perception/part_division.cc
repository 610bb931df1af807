#include "robot/perception/part_division.h"

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "robot/perception/alignment.h"

namespace tact::perception {
namespace {

using joint::Transform;
using Motions = std::array<Transform, 2>;

constexpr std::size_t kSomePoints = 2500;  // enough to find a motion; the last alignment takes all
constexpr int kMostRounds = 6;
constexpr double kSettled = 0.002;  // share of points that still change
// Surfaces between measured points are known no better than this share of their spacing.
constexpr double kSmallestDeviation = 0.02;

double DeviationFor(const Surface& surface, double residual) {
  return std::max(residual, kSmallestDeviation * surface.spacing);
}

Surface SomeOf(const Surface& surface) {
  return Select(surface, EvenlySpread(surface.points.size(), kSomePoints));
}

std::vector<std::uint32_t> Unexplained(const Surface& source, const Surface& target, const Transform& X_TS,
                                       double residual) {
  const std::vector<double> costs = CostOf(source, target, X_TS, DeviationFor(target, residual));
  std::vector<std::uint32_t> which;
  for (std::uint32_t i = 0; i < costs.size(); ++i) {
    if (costs[i] > 0) which.push_back(i);
  }
  return which;
}

double ShareOf(const std::vector<std::uint32_t>& which, const Surface& surface) {
  return static_cast<double>(which.size()) / static_cast<double>(surface.points.size());
}

// Alignment and subtraction, and alignment of what is left.
struct TwoMotions {
  Alignment first;
  std::optional<Alignment> second;  // if enough is left
  double shared = 0;                // share of the points that either motion explains
  double told_apart = 0;  // share of the points that just one motion explains, for the motion that has fewer
};

TwoMotions FindTwoMotions(const Surface& source, const Surface& target) {
  TwoMotions found;
  const Surface some = SomeOf(source);
  found.first = FindAlignment(some, target);
  const Transform& X_TS = found.first.X_TS;
  const auto left = Unexplained(some, target, X_TS, found.first.residual);
  const auto left_T = Unexplained(target, source, X_TS.Inverse(), found.first.residual);
  found.shared = 1 - ShareOf(left, some);
  if (left.size() < kFewestPoints || left_T.size() < kFewestPoints || ShareOf(left, some) < kLeastPart)
    return found;
  found.second = FindAlignment(Select(some, left), Select(target, left_T));
  const double deviation = DeviationFor(target, std::max(found.first.residual, found.second->residual));
  const auto costs = CostOf(some, target, X_TS, deviation);
  const auto costs_2 = CostOf(some, target, found.second->X_TS, deviation);
  std::array<std::size_t, 2> alone{};
  std::size_t either = 0;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    either += costs[i] == 0 || costs_2[i] == 0;
    alone[0] += costs[i] == 0 && costs_2[i] == kMostCost;
    alone[1] += costs_2[i] == 0 && costs[i] == kMostCost;
  }
  found.shared = static_cast<double>(either) / static_cast<double>(costs.size());
  found.told_apart = static_cast<double>(std::min(alone[0], alone[1])) / static_cast<double>(costs.size());
  return found;
}

class Divider {
 public:
  explicit Divider(std::span<const std::vector<Vector3d>> scans) {
    for (const auto& points : scans) surfaces_.push_back(SurfaceOf(points));
    division_.scans.resize(scans.size());
    for (std::size_t scan = 0; scan < scans.size(); ++scan) {
      division_.scans[scan].noise = surfaces_[scan].noise;
      division_.scans[scan].unit_covariances.fill(Eigen::Matrix<double, 6, 6>::Zero());
    }
  }

  Division Divide() {
    if (!Start()) return division_;
    while (division_.rounds < kMostRounds) {
      ++division_.rounds;
      for (std::size_t scan = 1; scan < surfaces_.size(); ++scan) AlignParts(scan, kSomePoints);
      if (Decide(0) < kSettled) break;
      if (!HasBothParts()) return CannotTell("nothing is left of one part: the scans show one rigid object");
    }
    for (std::size_t scan = 1; scan < surfaces_.size(); ++scan) {
      AlignParts(scan, surfaces_[0].points.size());
      Decide(scan);
    }
    FirstPartLarger();
    double most = 0;
    for (const DividedScan& scan : division_.scans)
      most = std::max(most, joint::RotationLog(scan.X_S0[0].R.transpose() * scan.X_S0[1].R).norm());
    if (most < kLeastTurn)
      return CannotTell("the parts turned against one another by " + Degrees(most) + ", expected at least " +
                        Degrees(kLeastTurn));
    return division_;
  }

 private:
  static std::string Degrees(double radian) {
    return std::to_string(radian * 180 / M_PI).substr(0, 4) + " degrees";
  }
  Division CannotTell(const std::string& why) {
    division_.cannot_tell = why;
    return division_;
  }

  // Motions between the first scan and each other one, and the parts by the pair that tells them apart best.
  bool Start() {
    std::size_t best = 0;
    starts_.resize(surfaces_.size());
    for (std::size_t scan = 1; scan < surfaces_.size(); ++scan) {
      starts_[scan] = FindTwoMotions(surfaces_[0], surfaces_[scan]);
      if (starts_[scan].shared < kLeastShared) {
        CannotTell("scans 1 and " + std::to_string(scan + 1) + " have only " +
                   std::to_string(std::lround(100 * starts_[scan].shared)) +
                   " % of their points in common: expected the same object from about the same side");
        return false;
      }
      if (starts_[scan].second && (best == 0 || starts_[scan].told_apart > starts_[best].told_apart))
        best = scan;
    }
    if (best == 0 || starts_[best].told_apart < kLeastPart / 2) {
      CannotTell("one rigid motion explains the scans: nothing moved, or too little to be seen");
      return false;
    }
    Accept(best, 0, starts_[best].first);
    Accept(best, 1, *starts_[best].second);
    placed_.assign(surfaces_.size(), false);
    placed_[0] = placed_[best] = true;
    Decide(0);
    if (!HasBothParts())
      CannotTell("one rigid motion explains the scans: nothing moved, or too little to be seen");
    return division_.cannot_tell.empty();
  }

  void Accept(std::size_t scan, std::size_t part, const Alignment& alignment) {
    division_.scans[scan].X_S0[part] = alignment.X_TS;
    division_.scans[scan].residuals[part] = alignment.residual;
    division_.scans[scan].unit_covariances[part] = alignment.unit_covariance;
  }

  Surface PointsOf(Part part, std::size_t most) const {
    std::vector<std::uint32_t> which;
    const std::vector<Part>& parts = division_.scans[0].parts;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
      if (parts[i] == part) which.push_back(i);
    }
    std::vector<std::uint32_t> taken;
    for (const std::uint32_t i : EvenlySpread(which.size(), most)) taken.push_back(which[i]);
    return Select(surfaces_[0], taken);
  }

  bool HasBothParts() const {
    for (const Part part : {Part::kFirst, Part::kSecond}) {
      const std::size_t count = CountOf(part, division_.scans[0].parts);
      if (count < kFewestPoints ||
          static_cast<double>(count) < kLeastPart * static_cast<double>(surfaces_[0].points.size()))
        return false;
    }
    return true;
  }

  // Each part with the scan, by some of its points in the first scan.
  void AlignParts(std::size_t scan, std::size_t most) {
    for (std::size_t part = 0; part < 2; ++part) {
      const Surface points = PointsOf(static_cast<Part>(part), most);
      std::vector<Transform> starts = {division_.scans[scan].X_S0[part]};
      AlignmentOptions options;
      if (!placed_[scan]) {
        starts = {starts_[scan].first.X_TS};
        if (starts_[scan].second) starts.push_back(starts_[scan].second->X_TS);
        options.first_gate = 3 * kGateOverSpacing * surfaces_[scan].spacing;
      }
      Alignment best;
      best.inliers = -1;
      for (const Transform& start : starts) {
        const Alignment tried = Align(points, surfaces_[scan], start, options);
        if (tried.inliers > best.inliers) best = tried;
      }
      Accept(scan, part, best);
    }
    placed_[scan] = true;
  }

  void FirstPartLarger() {
    const std::vector<Part>& parts = division_.scans[0].parts;
    if (CountOf(Part::kFirst, parts) >= CountOf(Part::kSecond, parts)) return;
    for (DividedScan& scan : division_.scans) {
      std::swap(scan.X_S0[0], scan.X_S0[1]);
      std::swap(scan.residuals[0], scan.residuals[1]);
      std::swap(scan.unit_covariances[0], scan.unit_covariances[1]);
      for (Part& part : scan.parts) {
        if (part != Part::kUndecided) part = part == Part::kFirst ? Part::kSecond : Part::kFirst;
      }
    }
  }

  // The parts of a scan's points by all other scans in place; the share of points that changed.
  double Decide(std::size_t scan) {
    DividedScan& divided = division_.scans[scan];
    std::vector<double> evidence(surfaces_[scan].points.size(), 0);
    for (std::size_t other = 0; other < surfaces_.size(); ++other) {
      if (other == scan || !placed_[other]) continue;
      for (std::size_t part = 0; part < 2; ++part) {
        const DividedScan& to = division_.scans[other];
        const Transform X_TS = to.X_S0[part] * divided.X_S0[part].Inverse();
        const double deviation = DeviationFor(
            surfaces_[other],
            std::max({to.residuals[0], to.residuals[1], divided.residuals[0], divided.residuals[1]}));
        const std::vector<double> costs = CostOf(surfaces_[scan], surfaces_[other], X_TS, deviation);
        for (std::size_t i = 0; i < costs.size(); ++i) evidence[i] += (part == 0 ? -0.5 : 0.5) * costs[i];
      }
    }
    std::vector<Part> parts = PartsBy(MeanField(surfaces_[scan], evidence));
    std::size_t same = 0;
    for (std::size_t i = 0; i < divided.parts.size(); ++i) same += parts[i] == divided.parts[i];
    divided.parts = std::move(parts);
    return 1 - static_cast<double>(same) / static_cast<double>(divided.parts.size());
  }

  std::vector<Surface> surfaces_;
  std::vector<TwoMotions> starts_;
  std::vector<bool> placed_;
  Division division_;
};

}  // namespace

std::size_t CountOf(Part part, std::span<const Part> parts) {
  return static_cast<std::size_t>(std::count(parts.begin(), parts.end(), part));
}

Division DivideTwoParts(std::span<const std::vector<Vector3d>> scans) {
  if (scans.size() < 2)
    throw PreconditionError("expected at least two scans of the object in different states, got " +
                            std::to_string(scans.size()));
  return Divider(scans).Divide();
}

}  // namespace tact::perception
