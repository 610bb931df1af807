#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

using Words = std::vector<std::string>;

const std::filesystem::path kRoot = TACT_SOURCE_DIR;
const std::string kPeg = kRoot / "examples/peg_in_hole/peg.off";
const std::string kSlot = kRoot / "examples/peg_in_hole/slot.off";
constexpr const char* kAtRest = R"({"t":[0,0,0],"q":[1,0,0,0]})";

std::string ReadText(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// One line of the CAD form; rest continues the object.
std::string CadForm(const std::string& moving, const std::string& pose, const std::string& rest = "") {
  return R"({"moving":")" + moving + R"(","fixed":")" + kSlot + R"(","unit":"mm","pose":)" + pose + rest +
         "}";
}

// Exit status 2, nothing on standard output, and this message.
void ExpectRefused(const Words& arguments, const std::string& message, const std::string& input = "") {
  const Answer answer = RunTact(arguments, input);
  const std::string what = ::testing::PrintToString(arguments) + " given " + input;
  EXPECT_EQ(answer.status, 2) << what;
  EXPECT_EQ(answer.out, "") << what;
  EXPECT_EQ(answer.err, "tact: " + message + "\n") << what;
}

void ExpectRefusedAsRelation(const std::string& text, const std::string& place_and_message) {
  ExpectRefused({"dof", "-", "--json"}, "<stdin>:" + place_and_message, text);
  ExpectRefused({"modes", "-"}, "<stdin>:" + place_and_message, text);
}

void ExpectPoseRefused(const std::string& pose, const std::string& message) {
  ExpectRefused({"contacts", kPeg, kSlot, "--unit", "mm", "--pose", pose}, message);
}

void ExpectArgumentsRefused(const Words& more, const std::string& message) {
  Words arguments{"contacts", kPeg, kSlot, "--pose", kAtRest};
  arguments.insert(arguments.end(), more.begin(), more.end());
  ExpectRefused(arguments, message);
}

// Six freedoms in all, none detaching or constrained: what no contact at all leaves.
TEST(BadInput, AnEmptyContactListIsNoErrorButFreeMotion) {
  const Answer answer = RunTact({"dof", "-", "--json"}, R"({"contacts":[]})");
  EXPECT_EQ(answer.status, 0);
  EXPECT_EQ(answer.err, "");
  EXPECT_NE(answer.out.find(R"("all":{"maintaining":6,"detaching":0,"constraining":0,"restricted":0})"),
            std::string::npos)
      << answer.out;
}

TEST(BadInput, AContactGivenTwiceIsTheSameAsOnce) {
  const std::string contact = R"({"point":[1,2,3],"planes":[[0,0,1]]})";
  const Answer once = RunTact({"dof", "-", "--json"}, R"({"contacts":[)" + contact + "]}");
  const Answer twice = RunTact({"dof", "-", "--json"}, R"({"contacts":[)" + contact + "," + contact + "]}");
  EXPECT_EQ(twice.status, 0);
  EXPECT_EQ(twice.out, once.out);
}

TEST(BadInput, ContactsThatMeanNothingAreRefusedAtTheirPlace) {
  ExpectRefusedAsRelation(R"({"contacts":[{"point":[0,0,0],"planes":[[0,0,0]]}]})",
                          "1:41: expected a normal that is not zero, got [0, 0, 0]");
  ExpectRefusedAsRelation("{\"contacts\":[\n{\"point\":[0,NaN,0],\"planes\":[[0,0,1]]}]}",
                          "2:13: expected a finite number, got NaN");
  ExpectRefusedAsRelation(R"({"contacts":[{"point":[1e400,0,0],"planes":[[0,0,1]]}]})",
                          "1:24: expected a number within the range of a double, got 1e400");
  ExpectRefusedAsRelation(
      R"({"contacts":[{"point":[0,0,0],"planes":[]}]})",
      "1:40: expected at least one plane, got none; a contact that restricts nothing is to be left out");
}

TEST(BadInput, FilesThatAreNoneAreRefusedByName) {
  for (const char* command : {"dof", "modes", "recognize"}) {
    ExpectRefused({command, "no/such.json"},
                  "no/such.json: expected a readable file, got: No such file or directory");
    ExpectRefused({command, kRoot.string()}, kRoot.string() + ": expected a file, got a folder");
    ExpectRefused({command, kPeg}, kPeg + ":1:1: expected a value, got OFF");
    ExpectRefused({command, "-"}, "<stdin>:1:1: expected a JSON value, got an empty file");
    ExpectRefused({command, "-"},
                  "<stdin>:1:35: expected a closing quote, got the end of the text; the object that begins "
                  "at <stdin>:1:14 is not closed",
                  R"({"contacts":[{"point":[0,1,0],"pla)");
  }
}

// Every bad text of tests/robot/input/bad, through the program: relations, demonstrations, poses.
TEST(BadInput, EveryBadTextIsRefusedWithItsMessage) {
  const std::filesystem::path folder = kRoot / "tests/robot/input/bad";
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path path = entry.path();
    if (path.extension() != ".json") continue;
    ++files;
    const std::string name = path.stem(), message = ReadText(folder / (name + ".expected"));
    Words arguments{"dof", "--json", path};
    if (name.starts_with("demo_")) arguments = {"recognize", path};
    if (name.starts_with("pose_")) arguments = {"contacts", kPeg, kSlot, "--unit", "mm", "--pose", path};
    const Answer answer = RunTact(arguments);
    EXPECT_EQ(answer.status, 2) << name;
    std::string wanted =
        message;  // the file's name stands at the front, and again where a bracket was opened
    for (size_t at = 0; (at = wanted.find(name + ".json", at)) != std::string::npos;
         at += path.string().size())
      wanted.replace(at, name.size() + 5, path);
    EXPECT_EQ(answer.err, "tact: " + wanted) << name;
    // Relations before a bad one are answered.
    if (message.starts_with(name + ".json:1:")) {
      EXPECT_EQ(answer.out, "") << name;
    }
  }
  EXPECT_GE(files, 80U);
}

// Open, self-intersecting, not planar, inverted, of zero area, cut, ...: every file of tests/robot/cad/bad.
TEST(BadInput, EveryBadMeshIsRefusedWithItsMessage) {
  const std::filesystem::path folder = kRoot / "tests/robot/cad/bad";
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = entry.path().extension();
    if (extension == ".expected" || extension == ".md") continue;
    ++files;
    std::string message = ReadText(folder / (entry.path().stem().string() + ".expected"));
    if (message.ends_with('\n')) message.pop_back();
    ExpectRefused({"contacts", entry.path(), kSlot, "--unit", "mm", "--pose", kAtRest},
                  folder.string() + "/" + message);
  }
  EXPECT_GE(files, 60U);
  ExpectRefused({"contacts", kPeg, "no/such.off", "--unit", "mm", "--pose", kAtRest},
                "no/such.off: expected a readable file, got: No such file or directory");
  const std::filesystem::path examples = kRoot / "examples";
  ExpectRefused({"contacts", kPeg, examples, "--unit", "mm", "--pose", kAtRest},
                examples.string() +
                    ": expected a mesh file named .off, .obj, .stl, .ply, .step or .stp, got no extension");
}

TEST(BadInput, AUnitIsAskedForAndMustBeKnown) {
  const std::string wanted =
      "--unit: expected mm, cm, m or in, the unit of both models and of the pose, got ";
  ExpectArgumentsRefused({}, wanted + "none; a mesh has no unit");
  ExpectArgumentsRefused({"--unit", "furlong"}, wanted + "furlong");
}

// The peg in metres beside the slot in millimetres.
TEST(BadInput, ModelsOfSizesAHundredfoldApartAreNoted) {
  std::istringstream off(ReadText(kPeg));
  std::string small, line;
  for (int number = 0; std::getline(off, line); ++number) {
    std::istringstream words(line);
    double x = 0, y = 0, z = 0;
    std::string more;
    if (number > 2 && words >> x >> y >> z && !(words >> more)) {
      line = std::to_string(x / 1000) + " " + std::to_string(y / 1000) + " " + std::to_string(z / 1000);
    }
    small += line + "\n";
  }
  const TemporaryFile peg("peg_in_metres.off", small);
  const std::string note =
      "the moving model is 0.008 mm long and the fixed one 14 mm: are both files in mm?\n";
  const Answer contacts = RunTact({"contacts", peg.path(), kSlot, "--unit", "mm", "--pose", kAtRest});
  EXPECT_EQ(contacts.status, 0);
  EXPECT_EQ(contacts.err, "tact: note: " + note);
  const Answer dof = RunTact({"dof", "-"}, CadForm(peg.path(), kAtRest));
  EXPECT_EQ(dof.status, 0);
  EXPECT_EQ(dof.err, "tact: note: <stdin>:1:1: " + note);
}

TEST(BadInput, PosesThatAreNoneAreRefused) {
  ExpectPoseRefused(R"({"t":[0,0,3],"q":[0,0,0,0]})",
                    "--pose:1:18: expected a quaternion that is not zero, got [0, 0, 0, 0]; no rotation is "
                    "[1, 0, 0, 0]");
  const std::string wanted = "--pose:1:23: expected a rotation matrix, got no rotation: ";
  ExpectPoseRefused(R"({"t":[0,0,3],"matrix":[[1,0,0],[0,2,0],[0,0,1]]})",
                    wanted + "row 2 times itself is 4, not 1");
  ExpectPoseRefused(R"({"t":[0,0,3],"matrix":[[1,0,0],[0,-1,0],[0,0,1]]})",
                    wanted + "the determinant is -1 (a mirror image)");
  ExpectPoseRefused(R"({"t":[0,0,3],"axis":[0,0,0],"angle":1})",
                    "--pose:1:21: expected an axis that is not zero, got [0, 0, 0]");
  ExpectPoseRefused("", "--pose: expected a pose in JSON or the name of a file of it, got nothing");
  ExpectPoseRefused("no/such.json", "no/such.json: expected a readable file, got: No such file or directory");
}

// By hand: the wall begins at x = 2 and the shaft ends at x = 3, its lower end well inside the slot.
TEST(BadInput, ModelsThatInterpenetrateAreRefusedWithDepthAndPlace) {
  const std::string deep = R"({"t":[1,0,-3],"q":[1,0,0,0]})";
  for (const Words& arguments :
       {Words{"contacts", kPeg, kSlot, "--unit", "mm", "--pose", deep}, Words{"dof", "-"}}) {
    const Answer answer = RunTact(arguments, CadForm(kPeg, deep));
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.out, "");
    const std::string place = arguments.front() == "dof" ? "<stdin>:1:1" : "--pose";
    EXPECT_EQ(
        answer.err.find("tact: " + place +
                        ": expected models that touch, got models that interpenetrate, by 1 mm at (3, "),
        0U)
        << answer.err;
  }
}

TEST(BadInput, TolerancesThatMeanNothingAreRefused) {
  const std::string wanted =
      "--tolerance: expected a number of millimetres, not negative and in the range of a double, got ";
  for (const char* tolerance : {"-0.1", "nan", "wide", "1e400", "1/0"}) {
    ExpectArgumentsRefused({"--unit", "mm", "--tolerance", tolerance}, wanted + tolerance);
  }
  ExpectArgumentsRefused({"--unit", "mm", "--tolerance", "8"},
                         kPeg +
                             ": expected a tolerance below the size of the model, 8 mm, got 8: everything "
                             "would count as contact");
  ExpectRefused({"dof", "-"}, "<stdin>:2:14: expected a tolerance that is not negative, got the number -1",
                CadForm(kPeg, kAtRest, ",\n \"tolerance\":-1"));
}

TEST(BadInput, CommandsAndOptionsThatAreNoneAreNamed) {
  ExpectRefused({"enumerate", "dof-clases"},
                "expected what to enumerate, one of dof-classes, dof-transitions, p-data, moves, got "
                "'dof-clases'; tact "
                "enumerate --help says "
                "more");
  ExpectRefused({"frobnicate"},
                "expected a command, one of dof, modes, contacts, recognize, plan, demonstration, joint, "
                "parts, verify, "
                "enumerate, knot, got "
                "'frobnicate'; tact "
                "--help says more");
  ExpectRefused({"dof", "--wrong", "-"},
                "The following argument was not expected: --wrong; tact dof --help says more");
  ExpectRefused({"dof"}, "FILE is required; tact dof --help says more");
  ExpectRefused({"contacts", kPeg, kSlot}, "--pose is required; tact contacts --help says more");
}

TEST(BadInput, ElementsThatAreNotThereOrDoNotTouchAreNamedAtTheirPlace) {
  const auto refused = [](const std::string& pair, const std::string& message) {
    ExpectRefused({"dof", "-"}, "<stdin>:2:14: " + message,
                  CadForm(kPeg, kAtRest, ",\n \"contacts\":[" + pair + "]"));
  };
  refused(R"({"moving":{"vertex":0},"fixed":{"face":10}})",
          "expected an element of the fixed model, got face 10; its face elements are 0 to 9");
  refused(R"({"moving":{"edge":24},"fixed":{"face":0}})",
          "expected an element of the moving model, got edge 24; its edge elements are 0 to 23");
  refused(R"({"moving":{"vertex":0},"fixed":{"face":0}})",
          "expected elements that touch, got vertex 0 of the moving model and face 0 of the fixed one, which "
          "do not; tact contacts lists those that do");
}

}  // namespace
}  // namespace tact::cli
