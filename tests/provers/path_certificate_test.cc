// Paths as certificates: written by the engines, read by the checker.
#include "provers/path_certificate.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "algebra/error.h"
#include "provers/check/check.h"
#include "tests/provers/path_scenes.h"

namespace tact::provers {
namespace {

using nlohmann::json;

std::string Why(const Certificate& certificate) { return check::CheckCertificate(certificate.json).why; }

class PathScene : public testing::TestWithParam<NamedScene> {};
INSTANTIATE_TEST_SUITE_P(PathCertificate, PathScene, testing::ValuesIn(PathScenes()),
                         [](const auto& one) { return one.param.name; });

TEST_P(PathScene, IsAcceptedForthAndBack) {
  EXPECT_EQ(Why(PathCertificate("path", "a.claim", GetParam().scene)), "");
  EXPECT_EQ(Why(PathCertificate("path", "a.claim", GetParam().scene, PathDirection::kBack)), "");
}

}  // namespace
}  // namespace tact::provers
