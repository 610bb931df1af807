#include "robot/perception/part_division.h"

#include <gtest/gtest.h>

#include <limits>

#include "algebra/error.h"
#include "tests/robot/perception/plier_example.h"

namespace tact::perception {
namespace {

// Of the decided points of all scans, the share in the right part, whichever lever is called the first part; and the share of
// all points that are decided.
struct Score {
  double right, decided;
};
Score ScoreOf(const Division& division, const std::vector<PlierScan>& scans) {
  double agree = 0, decided = 0, all = 0;
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    const std::vector<Part>& parts = division.scans[scan].parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      ++all;
      if (parts[i] == Part::kUndecided) continue;
      ++decided;
      agree += static_cast<int>(parts[i]) == scans[scan].seen.meshes[i];
    }
  }
  return {std::max(agree, decided - agree) / decided, decided / all};
}

TEST(PartDivision, NineteenOfTwentyDecidedPointsAreRightAndMostAreDecided) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const std::vector<PlierScan> scans = ScanPlier(SmallStudy(seed));
    const Division division = DivideTwoParts(PointsOf(scans));
    ASSERT_EQ(division.cannot_tell, "") << seed;
    const Score score = ScoreOf(division, scans);
    EXPECT_GT(score.right, 0.97) << seed;
    EXPECT_GT(score.decided, 0.85) << seed;
    EXPECT_GE(CountOf(Part::kFirst, division.scans[0].parts),
              CountOf(Part::kSecond, division.scans[0].parts));
  }
}

TEST(PartDivision, TwoScansAreEnough) {
  PlierStudy study = SmallStudy(4);
  study.openings = {0, 0.4};
  const std::vector<PlierScan> scans = ScanPlier(study);
  const Division division = DivideTwoParts(PointsOf(scans));
  ASSERT_EQ(division.cannot_tell, "");
  EXPECT_GT(ScoreOf(division, scans).right, 0.95);
}

TEST(PartDivision, WhereTheCameraStandsChangesNothing) {
  PlierStudy study = SmallStudy(5);
  study.openings = {0, 0.3};
  std::vector<std::vector<Vector3d>> points = PointsOf(ScanPlier(study));
  const Division before = DivideTwoParts(points);
  // Units change, too.
  const Transform moved{joint::RotationExp({0.5, -1, 2}), Vector3d(3, -4, 5)};
  for (auto& scan : points) {
    for (Vector3d& p : scan) p = moved * (1000 * p);
  }
  const Division after = DivideTwoParts(points);
  for (std::size_t scan = 0; scan < 2; ++scan) {
    EXPECT_EQ(before.scans[scan].parts, after.scans[scan].parts);
    for (std::size_t part = 0; part < 2; ++part) {
      Transform expected = before.scans[scan].X_S0[part];
      expected.p *= 1000;
      const Transform error = (moved * expected * moved.Inverse()).Inverse() * after.scans[scan].X_S0[part];
      EXPECT_LT(joint::RotationLog(error.R).norm(), 1e-7);
      EXPECT_LT((error * moved.p - moved.p).norm(), 1e-4);  // of 150 units of the plier's length
    }
  }
}

std::string WhyNot(const std::vector<std::vector<Vector3d>>& points) {
  return DivideTwoParts(points).cannot_tell;
}

TEST(PartDivision, WhatDoesNotMoveIsNotDivided) {
  PlierStudy study = SmallStudy(6);
  study.openings = {0.2, 0.2};  // put down afresh, but not opened
  const auto points = PointsOf(ScanPlier(study));
  const std::string rigid = "one rigid motion explains the scans: nothing moved, or too little to be seen";
  EXPECT_EQ(WhyNot(points), rigid);
  EXPECT_EQ(WhyNot({points[0], points[0]}), rigid);
}

TEST(PartDivision, LessThanADegreeIsNotTold) {
  PlierStudy study = SmallStudy(7);
  study.openings = {0.2, 0.21};  // 0.57 degrees
  EXPECT_NE(WhyNot(PointsOf(ScanPlier(study))), "");
}

TEST(PartDivision, AnotherObjectIsNamed) {
  PlierStudy study = SmallStudy(8);
  study.openings = {0, 0.3};
  auto points = PointsOf(ScanPlier(study));
  RandomNumbers random(1);
  for (Vector3d& p : points[1]) p = Vector3d(0, 0, 0.7) + 0.04 * random.InBall().normalized();  // a ball
  const std::string why = WhyNot(points);
  EXPECT_EQ(why.find("scans 1 and 2 have only "), 0u) << why;
}

TEST(PartDivision, RefusesWhatIsNoScan) {
  PlierStudy study = SmallStudy(9);
  study.openings = {0, 0.3};
  auto points = PointsOf(ScanPlier(study));
  EXPECT_THROW(DivideTwoParts({}), PreconditionError);
  EXPECT_THROW(DivideTwoParts(std::span(points).first(1)), PreconditionError);
  points[1][3].x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(DivideTwoParts(points), PreconditionError);
  points[1].clear();
  EXPECT_THROW(DivideTwoParts(points), PreconditionError);
}

}  // namespace
}  // namespace tact::perception
