#include "robot/joint/pose_series.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "algebra/error.h"

namespace tact::joint {
namespace {

input::PoseLog Read(const std::string& text, const std::string& name = "log") {
  std::istringstream in(text);
  return input::ReadPoseLog(in, name);
}

void ExpectSame(const Transform& a, const Transform& b) {
  EXPECT_LT((a.R - b.R).norm() + (a.p - b.p).norm(), 1e-12);
}

std::string Line(double time, const Transform& X) {
  std::ostringstream line;
  line.precision(17);
  const Eigen::Quaterniond q(X.R);
  line << time << " " << X.p.x() << " " << X.p.y() << " " << X.p.z() << " " << q.x() << " " << q.y() << " "
       << q.z() << " " << q.w() << "\n";
  return line.str();
}

Transform AnyTransform() {
  const auto number = [] { return *rc::gen::inRange(-30, 30) / 10.0; };
  return {RotationExp({number(), number(), number()}), {number(), number(), number()}};
}

TEST(PoseSeries, TheInverseOfALogIsTheOtherLinksPose) {
  const input::PoseLog log = Read("1 2 3 0 0 1 1\n");
  ExpectSame(SeriesOf(log).poses[0] * SeriesOf(log, true).poses[0], {});
}

// X_BA = X_WB^-1 X_WA, wherever W is.
RC_GTEST_PROP(PoseSeries, TwoAbsoluteLogsGiveTheRelativePosesWhateverTheirFrame, ()) {
  const Transform X_VW = AnyTransform();
  std::string a, b;
  std::vector<Transform> relative;
  for (int i = 0; i < 5; ++i) {
    const Transform X_WB = AnyTransform(), X_BA = AnyTransform();
    relative.push_back(X_BA);
    a += Line(i, X_VW * X_WB * X_BA);
    b += Line(i, X_VW * X_WB);
  }
  const PoseSeries series = SeriesOf(Read(a), Read(b));
  RC_ASSERT(series.poses.size() == 5U);
  for (int i = 0; i < 5; ++i)
    RC_ASSERT((series.poses[i].R - relative[i].R).norm() + (series.poses[i].p - relative[i].p).norm() <
              1e-10);
}

TEST(PoseSeries, TimesAreMatchedToTheNearestWithinTheLimit) {
  const auto a = Read("0.00 1 0 0 0 0 0 1\n0.12 2 0 0 0 0 0 1\n0.56 3 0 0 0 0 0 1\n9.0 4 0 0 0 0 0 1\n", "a");
  const auto b =
      Read("0.0 0 10 0 0 0 0 1\n0.1 0 20 0 0 0 0 1\n0.5 0 30 0 0 0 0 1\n0.6 0 40 0 0 0 0 1\n", "b");
  const PoseSeries series = SeriesOf(a, b);  // the usual step of b is 0.1: within 0.05
  ASSERT_EQ(series.poses.size(), 3U);
  ExpectSame(series.poses[0], {Eigen::Matrix3d::Identity(), {1, -10, 0}});
  ExpectSame(series.poses[1], {Eigen::Matrix3d::Identity(), {2, -20, 0}});
  ExpectSame(series.poses[2], {Eigen::Matrix3d::Identity(), {3, -40, 0}});
  EXPECT_EQ(series.notes[0].find("3 of 4 poses have a partner"), 0U) << series.notes[0];
  EXPECT_EQ(SeriesOf(a, b, 0.01).poses.size(), 1U);
  EXPECT_EQ(SeriesOf(a, b, 100).poses.size(), 4U);
  EXPECT_THROW(SeriesOf(a, Read("77 0 0 0 0 0 0 1\n", "late")), InputError);
}

TEST(PoseSeries, WithoutTimesLogsAreMatchedLineByLineOrRefused) {
  const auto two = Read("1 0 0 0 0 0 1\n2 0 0 0 0 0 1\n"), one = Read("1 0 0 0 0 0 1\n");
  EXPECT_EQ(SeriesOf(two, two).poses.size(), 2U);
  EXPECT_THROW(SeriesOf(two, one), InputError);
}

TEST(PoseSeries, WhatLooksWrongIsSaid) {
  const auto said = [](const std::string& text) {
    const auto found = Suspicions(SeriesOf(Read(text)));
    return found.empty() ? "" : found[0];
  };
  EXPECT_EQ(said("0.1 0 0 0 0 0 1\n0.2 0 0 0 0 0 1\n0.3 0 0 0 0 0.1 1\n"), "");
  EXPECT_EQ(
      said("1 0 0 0 0 0 1\n\n1 0 0 0 0 1 0.1\n").find("between lines 1 and 3 the link turns by 169 degrees"),
      0U);
  EXPECT_EQ(said("1 0 0 0 0 0 1\n1 0 0 0 0 0 1\n1 0 0 0 0 0 1\n").find("2 poses repeat the one before"), 0U);
  EXPECT_EQ(
      said("0.5 0 0 0 0 0 1\n0.6 0 0 0 0 0 1\n700 0 0 0 0 0 1\n800 0 0 0 0 0 1\n").find("2 of 4 locations"),
      0U);
  EXPECT_EQ(said("500 0 0 0 0 0 1\n600 0 0 0 0 0 1\n").find("A is 600 m away from B"), 0U);
}

}  // namespace
}  // namespace tact::joint
