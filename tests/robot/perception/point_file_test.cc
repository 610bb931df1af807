#include "robot/perception/point_file.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "tests/robot/perception/plier_example.h"

namespace tact::perception {
namespace {

std::string Lines(int count, const std::string& line) {
  std::string text;
  for (int i = 0; i < count; ++i) text += line + "\n";
  return text;
}

std::string Refusal(const std::string& contents) {
  try {
    ReadPoints(contents, "scan.xyz");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PointFile, ReadsCoordinatesAndLeavesOutWhatFollows) {
  const auto points = ReadPoints("# x y z nx ny nz\n" + Lines(60, "1 -2.5 3e2 0 0 1"), "scan.xyz");
  ASSERT_EQ(points.size(), 60u);
  EXPECT_EQ(points[59], Eigen::Vector3d(1, -2.5, 300));
}

TEST(PointFile, RefusesWhatIsNoPoint) {
  EXPECT_EQ(Refusal(""), "scan.xyz:0: expected a scan of at least 50 points, x y z a line, got none");
  EXPECT_EQ(Refusal(Lines(3, "1 2 3")),
            "scan.xyz:3: expected a scan of at least 50 points, x y z a line, got 3");
  EXPECT_EQ(Refusal("1 2\n"), "scan.xyz:1: expected a point, x y z, got \"1 2\"");
  EXPECT_EQ(Refusal("1 2 3\n1 2\n"), "scan.xyz:2: expected 3 numbers as in the lines before, got \"1 2\"");
  EXPECT_EQ(Refusal("1 2 nan\n"),
            "scan.xyz:1: expected a finite number in the range of a double, got \"nan\"");
  EXPECT_EQ(Refusal("ply\nformat ascii 1.0\n"),
            "scan.xyz:1: expected a point a line, x y z (a PLY file has to be written as such text), got a "
            "PLY file");
}

// The example's README says which study it is.
TEST(PointFile, TheExampleIsTheStudyItSays) {
  const std::vector<PlierScan> scans = ScanPlier(SmallStudy(1));
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const auto points =
        ReadPointFile(std::string(TACT_SOURCE_DIR) + "/examples/plier/scan" + std::to_string(i + 1) + ".xyz");
    ASSERT_EQ(points.size(), scans[i].seen.points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      EXPECT_LT((points[k] - 1000 * scans[i].seen.points[k]).cwiseAbs().maxCoeff(), 0.0051);
  }
}

}  // namespace
}  // namespace tact::perception
