#include "robot/input/pose_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "algebra/error.h"
#include "robot/cad/text_lines.h"
#include "robot/input/json_value.h"
#include "robot/input/text_token.h"

namespace tact::input {
namespace {

using joint::Transform;

constexpr size_t kNumbers = 8;  // of a pose's line
constexpr int kMostScenes = 10'000'000;
constexpr std::string_view kModels = "No of Models:", kScenes = "No of Scenes:";
constexpr std::string_view kBlanks = " \t\r";

std::string Short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

class PoseListReader {
 public:
  PoseListReader(std::istream& in, std::string source) : in_(in), source_(std::move(source)) {}

  PoseList Read() {
    PoseList list;
    const int models = ReadCount(kModels, 1, kMostScenes);
    if (models != 2)
      Fail(kModels.size(),
           "expected 2 models, the moving one and the fixed one, got " + std::to_string(models));
    list.moving = ReadModel("the moving model's file");
    list.fixed = ReadModel("the fixed model's file");
    const int scenes = ReadCount(kScenes, 1, kMostScenes);
    for (int k = 1; k <= scenes; ++k) {
      const std::string of = " of scene " + std::to_string(k) + " of " + std::to_string(scenes);
      if (!NextLine()) FailAtEnd("the moving model's pose" + of);
      ListedScene scene;
      scene.where = source_ + ":" + std::to_string(number_) + ":1";
      scene.X_CM = ReadPose();
      if (!ReadLine()) FailAtEnd("the fixed model's pose" + of);
      if (IsBlank()) Fail(0, "expected the fixed model's pose" + of + ", got a blank line");
      scene.X_CF = ReadPose();
      list.scenes.push_back(std::move(scene));
    }
    if (NextLine()) {
      Fail(0, "expected the end after " + std::to_string(scenes) + " scenes, as stated above, got " +
                  Quote(line_));
    }
    return list;
  }

 private:
  bool ReadLine() {
    if (!std::getline(in_, line_)) return false;
    ++number_;
    return true;
  }
  bool IsBlank() const { return line_.find_first_not_of(kBlanks) == std::string::npos; }
  bool NextLine() {
    while (ReadLine()) {
      if (!IsBlank()) return true;
    }
    return false;
  }

  [[noreturn]] void Fail(size_t offset, const std::string& message) const {
    SourceText{line_, source_, number_}.Fail(offset, message);
  }
  [[noreturn]] void FailAtEnd(const std::string& what) const {
    throw InputError(source_ + ":" + std::to_string(number_ + 1) + ":1: expected " + what +
                     ", got the end of the file");
  }

  // The whole number after a title.
  int ReadCount(std::string_view title, int low, int high) {
    const std::string expected = "\"" + std::string(title) + " N\"";
    if (!NextLine()) FailAtEnd(expected);
    if (line_.compare(0, title.size(), title) != 0) Fail(0, "expected " + expected + ", got " + Quote(line_));
    const std::string_view after = std::string_view(line_).substr(title.size());
    const std::vector<Word> words = WordsOf({after, source_, number_}, "", "\r");
    if (words.size() != 1)
      Fail(title.size(), "expected one number after the title, got " + std::to_string(words.size()));
    const SourceText text{line_, source_, number_};
    return ReadWholeNumber(text, {words[0].text, words[0].offset + title.size()}, low, high,
                           "a whole number");
  }

  std::filesystem::path ReadModel(const std::string& what) {
    if (!NextLine()) FailAtEnd(what);
    if (line_.compare(0, kScenes.size(), kScenes) == 0) Fail(0, "expected " + what + ", got " + Quote(line_));
    const size_t first = line_.find_first_not_of(kBlanks), last = line_.find_last_not_of(kBlanks);
    std::string name = line_.substr(first, last - first + 1);
    if (name.find('\0') != std::string::npos) Fail(0, "expected " + what + ", got a zero byte in its name");
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path path(name);
    return (path.is_absolute() ? path : std::filesystem::path(source_).parent_path() / path)
        .lexically_normal();
  }

  double Number(const Word& word) const {
    const auto value = cad::ParseFinite(word.text);
    if (!value) Fail(word.offset, "expected a number, got " + Quote(word.text));
    return *value;
  }

  Transform ReadPose() {
    const SourceText text{line_, source_, number_};
    const std::vector<Word> words = WordsOf(text, "", "\r");
    if (words.size() != kNumbers) {
      Fail(words.empty() ? 0 : words.back().offset,
           "expected 8 numbers, <flag> tx ty tz ax ay az angle, got " + std::to_string(words.size()));
    }
    ReadWholeNumber(text, words[0], -1'000'000, 1'000'000, "a flag, a whole number");
    Transform X;
    Eigen::Vector3d axis;
    for (size_t i = 0; i < 3; ++i) {
      X.p[static_cast<Eigen::Index>(i)] = Number(words[1 + i]);
      axis[static_cast<Eigen::Index>(i)] = Number(words[4 + i]);
      if (std::abs(X.p[static_cast<Eigen::Index>(i)]) > kFarthestListed)
        Fail(words[1 + i].offset, "expected a location a camera can see, got " + Quote(words[1 + i].text));
    }
    const double angle = Number(words[7]), length = axis.stableNorm();
    if (std::abs(angle) > kLargestListedAngle) {
      Fail(words[7].offset,
           "expected an angle in radian, at most a turn, got " + Short(angle) + "; is it in degrees?");
    }
    if (std::abs(length - 1) > kLargestAxisError) {
      if (angle == 0) return X;
      Fail(words[4].offset, "expected an axis of length one, got one of length " + Short(length));
    }
    X.R = joint::RotationExp(angle / length * axis);
    return X;
  }

  std::istream& in_;
  std::string source_, line_;
  size_t number_ = 0;
};

}  // namespace

PoseList ReadPoseList(std::istream& in, const std::string& source) {
  return PoseListReader(in, source).Read();
}

}  // namespace tact::input
