#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

std::string Scan(int number) {
  return std::string(TACT_SOURCE_DIR) + "/examples/plier/scan" + std::to_string(number) + ".xyz";
}

// The truth stands in examples/README.md.
TEST(PartsCommand, FindsThePinOfTheExample) {
  const TemporaryFile drawing("parts.svg", "");
  const Answer answer =
      RunTact({"parts", Scan(1), Scan(2), Scan(3), Scan(4), Scan(5), "--json", "--svg", drawing.path()});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  EXPECT_EQ(json["type"], "revolute");
  const std::vector<double> direction = json["axis"]["direction"], point = json["axis"]["point"];
  const double cosine = 0.16690 * direction[0] + 0.35320 * direction[1] - 0.92054 * direction[2];
  EXPECT_GT(cosine, std::cos(3 * json["errors"]["direction"].get<double>()));
  EXPECT_LT(json["errors"]["direction"].get<double>(), 0.02);
  // The distance between the pin and the point found.
  const double x = point[0] - 11.391, y = point[1] - 8.585, z = point[2] - 700.600;
  const double along = 0.16690 * x + 0.35320 * y - 0.92054 * z;
  EXPECT_LT(std::sqrt(x * x + y * y + z * z - along * along), 4 * json["errors"]["point"].get<double>());
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(json["scans"][i]["angle"].get<double>(), 0.13 * double(i), 0.004);
  EXPECT_EQ(json["scans"][0]["parts"].get<std::string>().size(), 2736u);  // the lines of scan1.xyz
  std::ifstream file(drawing.path());
  std::ostringstream svg;
  svg << file.rdbuf();
  EXPECT_EQ(svg.str().find("<svg"), 0u);
  EXPECT_NE(svg.str().find("#2a62b0"), std::string::npos);
}

TEST(PartsCommand, SaysThatItCannotTell) {
  const Answer answer = RunTact({"parts", Scan(1), Scan(1)});
  EXPECT_EQ(answer.status, 1);
  EXPECT_EQ(answer.out,
            "cannot tell: one rigid motion explains the scans: nothing moved, or too little to be seen\n");
}

TEST(PartsCommand, RefusesOneScanAndWhatIsNone) {
  const Answer one = RunTact({"parts", Scan(1)});
  EXPECT_EQ(one.status, 2);
  EXPECT_NE(one.err.find("expected two scans or more"), std::string::npos) << one.err;
  const TemporaryFile empty("empty.xyz", "");
  const Answer none = RunTact({"parts", Scan(1), empty.path()});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("expected a scan of at least 50 points"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace tact::cli
