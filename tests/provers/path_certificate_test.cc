// Paths as certificates: written by the engines, read by the checker.
#include "provers/path_certificate.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "algebra/error.h"
#include "provers/check/check.h"
#include "tests/algebra/contact/touching_solids.h"
#include "tests/provers/certificate_oracle.h"
#include "tests/provers/path_scenes.h"

namespace tact::provers {
namespace {

using nlohmann::json;

std::string Why(const json& certificate) { return check::CheckCertificate(certificate.dump()).why; }

json Written(const Scene& scene, PathDirection direction = PathDirection::kForth) {
  return json::parse(PathCertificate("path", "a.claim", scene, direction).json);
}

class PathScene : public testing::TestWithParam<NamedScene> {};
INSTANTIATE_TEST_SUITE_P(PathCertificate, PathScene, testing::ValuesIn(PathScenes()),
                         [](const auto& one) { return one.param.name; });

TEST_P(PathScene, IsAcceptedForthAndBack) {
  for (const PathDirection direction : {PathDirection::kForth, PathDirection::kBack}) {
    const json certificate = Written(GetParam().scene, direction);
    EXPECT_EQ(Why(certificate), "");
    EXPECT_TRUE(oracle::IsRight(certificate));
    const bool back = direction == PathDirection::kBack;
    EXPECT_EQ(certificate["relations"][back ? 2 : 0]["contacts"].size(), GetParam().contacts_before);
    EXPECT_EQ(certificate["relations"][back ? 0 : 2]["contacts"].size(), GetParam().contacts_after);
  }
}

long long Mutate(long long n, std::mt19937& random) {
  const long long changes[] = {n + 1, n - 1, -n, 0, 2 * n, n + 7, n - 7};
  return changes[random() % 7];
}

// Each number of the geometry, of the planes and of the relations.
TEST_P(PathScene, AChangedNumberIsRefusedJustIfTheCertificateIsWrongThen) {
  const json original = Written(GetParam().scene);
  std::mt19937 random(20060329);
  size_t wrong = 0, right = 0;
  const json flat = original.flatten();
  constexpr size_t kTried = 120;  // of some hundreds
  const size_t skip = std::max<size_t>(1, flat.size() / kTried);
  for (const auto& [path, value] : flat.items()) {
    if (!value.is_number_integer() || path.find("/dof/") != path.npos || random() % skip != 0) continue;
    const json::json_pointer place(path);
    json mutant = original;
    mutant.at(place) = Mutate(value, random);
    if (mutant == original) continue;
    const bool is_right = oracle::IsRight(mutant);
    EXPECT_EQ(Why(mutant) == "", is_right)
        << path << ": " << value << " -> " << mutant.at(place) << ": " << Why(mutant);
    ++(is_right ? right : wrong);
  }
  EXPECT_GT(wrong, 20u);
  EXPECT_GT(right, 0u);
}

std::string Refusal(const Scene& scene) {
  try {
    PathCertificate("path", "a.claim", scene);
  } catch (const PreconditionError& error) {
    return error.what();
  }
  return "";
}

const Scene& Named(const std::string& name) {
  static const auto scenes = PathScenes();
  return std::find_if(scenes.begin(), scenes.end(), [&](const auto& one) { return one.name == name; })->scene;
}

TEST(PathCertificate, EveryKindOfPlaneAndPathIsAmongTheScenes) {
  std::set<std::string> seen;
  for (const NamedScene& named : PathScenes()) {
    const json certificate = Written(named.scene);
    for (const auto& [key, value] : certificate["path"].items()) seen.insert(key);
    for (const json& row : certificate["planes"]) {
      for (const json& list : row) {
        if (list.size() > 1) seen.insert("halved");
        for (const json& plane : list) {
          for (const auto& [key, value] : plane.items()) seen.insert(key);
        }
      }
    }
  }
  for (const char* kind : {"line", "rotation", "normal", "carried", "edges", "halved"})
    EXPECT_EQ(seen.count(kind), 1u) << kind;
}

TEST(PathCertificate, APathThatIsInterruptedIsRefused) {
  Scene scene = Named("BlockDropsOnTable");
  scene.path = MotionPath::Line({0, 0, -3});
  EXPECT_EQ(
      Refusal(scene),
      "no path for a certificate: moving vertex 0 and fixed face 2 do not touch at s = 0, but do at s = "
      "2/3");
  scene = Named("BlockSlidesOverTheBorder");
  scene.path = MotionPath::Line({2, 0, 0});
  EXPECT_NE(Refusal(scene).find("no path for a certificate: moving"), std::string::npos) << Refusal(scene);
}

// A tip on two flush tables: together they are one face, each of them ends in an edge there.
TEST(PathCertificate, ContactsAtASeamOfPiecesAreRefused) {
  const Scene scene{{{{0, 0, 0}, {1, 1, 3}, {-1, 1, 3}, {-1, -1, 3}, {1, -1, 3}}},
                    {Corners({-3, -3, -1}, {0, 3, 0}), Corners({0, -3, -1}, {3, 3, 0})},
                    MotionPath::Line({0, 1, 0})};
  EXPECT_NE(Refusal(scene).find("seam"), std::string::npos) << Refusal(scene);
}

TEST(PathCheck, EachNumberOfTheHandMadeCertificatesChangedInManyWays) {
  size_t wrong = 0, right = 0;
  for (const char* name : {"tip_leaves", "face_lies_down"}) {
    std::ifstream in(std::string(TACT_SOURCE_DIR) + "/tests/check/certificates/" + name + ".json");
    const json original = json::parse(in);
    const json flat = original.flatten();
    for (const auto& [path, value] : flat.items()) {
      if (!value.is_number_integer()) continue;
      const long long n = value;
      for (const long long changed : {n + 1, n - 1, -n, 0LL, 2 * n, n + 5}) {
        if (changed == n) continue;
        json mutant = original;
        mutant.at(json::json_pointer(path)) = changed;
        const bool is_right = oracle::IsRight(mutant);
        EXPECT_EQ(Why(mutant) == "", is_right)
            << path << ": " << n << " -> " << changed << ": " << Why(mutant);
        ++(is_right ? right : wrong);
      }
    }
  }
  EXPECT_GT(wrong, 300u);
  EXPECT_GT(right, 50u);
}

TEST(PathCheck, ADepartedContactIsNotClaimedAnew) {
  json certificate = Written(Named("BlockDropsOnTable"));
  certificate["path"]["line"] = {0, 0, -1, 1};  // the block stops above the table
  EXPECT_EQ(Why(certificate), "relations[2].contacts[0]: the pieces do not touch there with these planes");
  certificate = Written(Named("BlockDropsOnTable"));
  certificate["path"]["line"] = {0, 0, -4, 1};  // and here inside
  EXPECT_EQ(Why(certificate),
            "planes[0][0][0]: moving corner 0 is not on its side throughout, or cannot be decided");
}

TEST(PathCheck, AContactLeftOutIsFoundThoughTheMotionDofsStayRight) {
  json certificate = Written(Named("PegReachesTheGround"));
  // The middle of the four corners of a face does for the motion DOFs, with all evidence anew.
  const algebra::ContactRelation kept = [&] {
    auto relation = FollowScene(Named("PegReachesTheGround")).end.relation;
    relation.contacts.pop_back();
    return relation;
  }();
  const json other = json::parse(TransitionsCertificate("path", "a.claim", {{"after", kept}}, {}).json);
  certificate["relations"][2] = other["relations"][0];
  EXPECT_EQ(Why(certificate), "relations[2].contacts: the pieces touch elsewhere too, at [1,1,1,1]");
}

TEST(PathCheck, ATouchThatGoesInTheMiddleIsRefused) {
  json certificate = Written(Named("CrossedEdgesSlideToAnEnd"));
  certificate["path"]["line"] = {3, 0, 0, 1};
  const std::string why = Why(certificate);
  EXPECT_NE(why.find("before s = 1"), std::string::npos) << why;
}

TEST(PathCheck, MotionDofsThatChangeBeforeTheEndAreRefused) {
  json certificate = Written(Named("BlockDropsOnTable"));
  certificate["relations"][1] = certificate["relations"][2];
  certificate["transitions"] = json::array();
  EXPECT_EQ(Why(certificate), "relations[1].dof: the motion DOFs change before s = 1");
}

// Property: whatever path FollowPath accepts has a certificate that the checker accepts.
TEST(PathCertificate, RandomPathsWithoutEventsAreAccepted) {
  std::map<std::string, int> seen;
  for (unsigned seed = 0; seed < 300; ++seed) {
    algebra::Dice dice(seed);
    const auto fixed = algebra::RandomTetrahedron(dice);
    auto moving = algebra::RandomlyPlaced(dice, algebra::RandomTetrahedron(dice), fixed);
    if (seed % 3 == 0) moving = Transform(moving, algebra::Pose{{}, dice.RollVector(-3, 3)});
    Scene scene{{{}}, {{}}, {}};
    for (const auto& v : moving.solid.vertices) scene.moving_pieces[0].push_back(v.point);
    for (const auto& v : fixed.solid.vertices) scene.fixed_pieces[0].push_back(v.point);
    const Vector3 vector = Rational(1, dice.Roll(2, 9)) * dice.RollVector(-2, 2);
    if (vector.IsZero()) continue;
    scene.path = dice.Roll(0, 1) == 0 ? MotionPath::Line(vector)
                                      : MotionPath::Rotation(fixed.solid.vertices[0].point, vector);
    const auto path = FollowScene(scene);
    if (path.event || ComputeMotionDof(path.start.relation) != ComputeMotionDof(path.middle.relation))
      continue;
    const json certificate = Written(scene);
    ASSERT_EQ(Why(certificate), "") << "seed " << seed;
    ++seen[path.start.relation.contacts.empty() ? "apart" : "touching"];
  }
  EXPECT_GT(seen["apart"], 0);
  EXPECT_GT(seen["touching"], 0);
}

}  // namespace
}  // namespace tact::provers
