#include "robot/recognition/recognition.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "algebra/error.h"
#include "robot/cad/mesh.h"

namespace tact::recognition {
namespace {

using algebra::MotionDof;
using algebra::Pose;
using algebra::Rational;
using algebra::Rotation;

const std::string kRoot = TACT_SOURCE_DIR;

Recognition RecognizeExample() {
  const std::string path = kRoot + "/examples/peg_in_hole/demonstration.json";
  std::ifstream file(path);
  return Recognize(input::ReadDemonstration(file, path));
}

// Maintaining, detaching, constraining in translation; the same in rotation; restricted in translation and rotation.
using Row = std::array<int, 8>;

Row RowOf(const MotionDof& dof) {
  const auto& t = dof.translation;
  const auto& r = dof.rotation;
  return {t.maintaining, t.detaching,    t.constraining, r.maintaining,
          r.detaching,   r.constraining, t.restricted,   r.restricted};
}

// The rows that the text of [thesis, 2.8.2] implies: each change it states, from "nothing touches" on.
TEST(Recognition, TheExamplesEightRelationsAreThoseOfThePegInsertion) {
  const Recognition seen = RecognizeExample();
  const std::vector<Row> rows = {{3, 0, 0, 3, 0, 0, 0, 0}, {2, 1, 0, 2, 1, 0, 1, 1}, {3, 0, 0, 3, 0, 0, 2, 2},
                                 {2, 1, 0, 2, 1, 0, 1, 1}, {1, 2, 0, 1, 2, 0, 2, 2}, {3, 0, 0, 3, 0, 0, 2, 3},
                                 {2, 0, 1, 1, 0, 2, 1, 2}, {1, 1, 1, 0, 1, 2, 2, 3}};
  ASSERT_EQ(seen.relations.size(), rows.size());
  for (size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(RowOf(seen.relations[i].dof), rows[i]) << seen.relations[i].name;
    EXPECT_EQ(seen.relations[i].dof.singular, i == 2 || i == 5) << seen.relations[i].name;
  }
}

TEST(Recognition, OnlyTheSixthTransitionIsCritical) {
  const Recognition seen = RecognizeExample();
  ASSERT_EQ(seen.transitions.size(), 7U);
  for (size_t i = 0; i < 7; ++i) EXPECT_EQ(seen.transitions[i].critical, i == 5) << i + 1;
}

TEST(Recognition, StatesWithTheSameContactsAreOneRelation) {
  std::istringstream text(R"({"relations":[
    {"name":"free","contacts":[]},
    {"name":"down","contacts":[{"point":[0,0,0],"planes":[[0,0,1]]}]},
    {"name":"still","contacts":[{"point":[0,0,0],"planes":[[0,0,1]]}]}]})");
  const Recognition seen = Recognize(input::ReadDemonstration(text, "text"));
  ASSERT_EQ(seen.relations.size(), 2U);
  EXPECT_EQ(seen.relations[1].first, 2U);
  EXPECT_EQ(seen.relations[1].last, 3U);
  EXPECT_EQ(seen.transitions.size(), 1U);
}

input::CadModels Models(const std::string& moving, const std::string& fixed, cad::LengthUnit unit,
                        Rational tolerance) {
  return {kRoot + "/" + moving, kRoot + "/" + fixed, unit, std::move(tolerance)};
}

input::CadModels ExampleModels() {
  return Models("examples/peg_in_hole/peg.off", "examples/peg_in_hole/slot.off", cad::LengthUnit::kMillimetre,
                0);
}

TEST(PosedModels, InterpenetrationIsRefusedWithDepthAndPlace) {
  const ModelPair models = LoadModels(ExampleModels());
  try {
    ContactsInPose(models, Pose{Rotation{}, {0, 0, -6}}, "here");
    FAIL();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("here: expected models that touch, got models that interpenetrate, by 1 mm at"),
              std::string::npos)
        << message;
  }
}

// Seated, the shoulder's face 4 lies on the block's face 4 with the four corners of their common rectangle.
TEST(PosedModels, NamedElementsSelectTheirContacts) {
  const ModelPair models = LoadModels(ExampleModels());
  const Pose seated{Rotation{}, {0, 0, -5}};
  using algebra::ElementKind;
  const auto shoulder =
      ContactsOfElements(models, seated, {{{ElementKind::kFace, 4}, {ElementKind::kFace, 4}}}, "");
  ASSERT_EQ(shoulder.contacts.size(), 4U);
  for (const auto& c : shoulder.contacts) EXPECT_EQ(c.planes, (std::vector<algebra::Vector3>{{0, 0, 1}}));
  EXPECT_THROW(ContactsOfElements(models, seated, {{{ElementKind::kFace, 40}, {ElementKind::kFace, 4}}}, ""),
               InputError);
  EXPECT_THROW(ContactsOfElements(models, seated, {{{ElementKind::kFace, 5}, {ElementKind::kFace, 4}}}, ""),
               InputError);
}

TEST(PosedModels, AMetreModelAgainstAMillimetreOneIsNoted) {
  const auto folder = std::filesystem::temp_directory_path() / "tact_posed_models_test";
  std::filesystem::create_directories(folder);
  const std::string peg = (folder / "peg.off").string();
  std::ofstream(peg) << "OFF\n4 4 0\n0 0 0\n.01 0 0\n0 .01 0\n0 0 .01\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const ModelPair models =
      LoadModels({peg, kRoot + "/examples/peg_in_hole/slot.off", cad::LengthUnit::kMillimetre, 0});
  std::filesystem::remove_all(folder);
  ASSERT_EQ(models.notes.size(), 1U);
  EXPECT_NE(models.notes[0].find("are both files in mm?"), std::string::npos) << models.notes[0];
}

// Real pegs with 2 mm of play. Seated: turned over by 180 degrees about z, the cap's shoulder on the bottle's rim.
class RealPegs : public testing::TestWithParam<std::string> {
 protected:
  static std::string Folder() { return "../shared/data/pegs/objects_2mm_" + GetParam() + "_cube_"; }
  void SetUp() override {
    if (!std::filesystem::exists(kRoot + "/" + Folder() + "cap.obj")) GTEST_SKIP() << "no shared data here";
  }
  static Row SeatedWith(const Rational& tolerance) {
    const ModelPair models =
        LoadModels(Models(Folder() + "cap.obj", Folder() + "bottle.obj", cad::LengthUnit::kMetre, tolerance));
    const Pose seated{Rotation::FromQuaternion(0, 0, 0, 1), {0, Rational(8, 100), 0}};
    return RowOf(ComputeMotionDof(ContactsInPose(models, seated, "seated").relation));
  }
};

// A face on a face: slides both ways, turns about its normal, lifts and tilts off.
TEST_P(RealPegs, ExactlyOnlyTheShoulderTouches) { EXPECT_EQ(SeatedWith(0), (Row{2, 1, 0, 1, 2, 0, 1, 2})); }

// A peg in its hole can only be pulled out.
TEST_P(RealPegs, WithinAMillimetreTheyArePegsInTheirHoles) {
  EXPECT_EQ(SeatedWith(Rational(1, 1000)), (Row{0, 1, 2, 0, 0, 3, 3, 3}));
}

INSTANTIATE_TEST_SUITE_P(Shapes, RealPegs, testing::Values("Line", "Hexagon"));

// The recorded peg, seated: 35 mm in 35 mm, both walls, the floor and both shoulders flush; open in depth.
TEST(PosedModels, TheRecordedPegSeatedHasThePegsDofs) {
  const std::string folder = "../shared/data/peg_in_hole/";
  if (!std::filesystem::exists(kRoot + "/" + folder + "peg.off")) GTEST_SKIP() << "no shared data here";
  const ModelPair models =
      LoadModels(Models(folder + "peg.off", folder + "hole.off", cad::LengthUnit::kMillimetre, 0));
  const auto found = ContactsInPose(models, Pose{}, "seated");
  EXPECT_EQ(found.primitives.size(), 5U);
  EXPECT_EQ(RowOf(ComputeMotionDof(found.relation)), (Row{1, 1, 1, 0, 1, 2, 2, 3}));
}

}  // namespace
}  // namespace tact::recognition
