#include "robot/input/knot_move_text.h"

#include <filesystem>

#include "robot/input/json_stream.h"

namespace tact::input {
namespace {

using knot::MoveDirection;
using knot::MoveKind;
using knot::RopeEnd;

constexpr int kMostSegments = 1 << 25;

struct KindName {
  MoveKind kind;
  std::string_view name;
  int segments;
};
constexpr KindName kKinds[] = {{MoveKind::kR1, "R1", 1},
                               {MoveKind::kR2, "R2", 2},
                               {MoveKind::kR3, "R3", 3},
                               {MoveKind::kCross, "Cross", 1}};

const KindName& Find(MoveKind kind) {
  for (const KindName& known : kKinds) {
    if (known.kind == kind) return known;
  }
  throw InvariantError("a move of no kind");
}

// The index of the value among the words.
size_t ReadWord(const JsonValue& value, const std::vector<std::string_view>& words) {
  std::string expected;
  for (size_t i = 0; i < words.size(); ++i) {
    expected += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + Quote(words[i]);
  }
  if (value.kind() != JsonKind::kString) value.FailExpected(expected);
  const std::string word = value.ReadString(expected);
  for (size_t i = 0; i < words.size(); ++i) {
    if (word == words[i]) return i;
  }
  value.Fail("expected " + expected + ", got " + Quote(word));
}

// The member that this kind of move has, or none and then it must be null or left out.
std::optional<JsonValue> Member(const JsonValue& root, std::string_view key, bool wanted,
                                std::string_view kind) {
  const auto member = root.Find(key);
  const bool given = member && member->kind() != JsonKind::kNull;
  if (wanted && !given) return root.At(key);
  if (!wanted && given) {
    member->FailExpected("null as the " + std::string(key) + " of " + std::string(kind));
  }
  return given ? member : std::nullopt;
}

}  // namespace

std::string_view NameOf(MoveKind kind) { return Find(kind).name; }

std::string_view NameOf(MoveDirection direction) {
  return direction == MoveDirection::kAdd ? "add" : direction == MoveDirection::kRemove ? "remove" : "shift";
}

std::string_view NameOf(RopeEnd end) {
  return end == RopeEnd::kSelective ? "selective" : end == RopeEnd::kOther ? "other" : "";
}

knot::Explanation ParseMove(const std::string& text, const std::string& source) {
  const JsonDocument document = JsonDocument::Parse(text, source);
  const JsonValue root = document.root();
  root.ExpectObject({"kind", "direction", "segments", "end", "selective_end", "attr", "order"});
  const KindName& known = kKinds[ReadWord(root.At("kind"), {"R1", "R2", "R3", "Cross"})];
  knot::Explanation read;
  knot::Move& move = read.move;
  move.kind = known.kind;
  const bool shifts = move.kind == MoveKind::kR3;
  const JsonValue direction = root.At("direction");
  move.direction = std::array{MoveDirection::kAdd, MoveDirection::kRemove,
                              MoveDirection::kShift}[ReadWord(direction, {"add", "remove", "shift"})];
  if (shifts != (move.direction == MoveDirection::kShift)) {
    direction.FailExpected(shifts ? "\"shift\" as the direction of R3"
                                  : "\"add\" or \"remove\" as the direction of " + std::string(known.name));
  }
  const JsonValue segments = root.At("segments");
  size_t place = 0;
  for (const JsonValue segment : segments.Elements("an array of segments")) {
    if (place < move.segments.size())
      move.segments[place] = static_cast<int>(segment.ReadInteger(1, kMostSegments));
    ++place;
  }
  if (place != static_cast<size_t>(known.segments)) {
    segments.FailExpected(std::string(known.segments == 1   ? "one segment"
                                      : known.segments == 2 ? "two segments"
                                                            : "three segments") +
                          " of " + std::string(known.name));
  }
  if (const auto end = Member(root, "end", move.kind == MoveKind::kCross, known.name))
    move.end = std::array{RopeEnd::kSelective, RopeEnd::kOther}[ReadWord(*end, {"selective", "other"})];
  if (const auto attr = Member(root, "attr", !shifts, known.name))
    move.attr = static_cast<int>(attr->ReadInteger(1, 4));
  if (const auto order = Member(root, "order", move.kind == MoveKind::kR2, known.name))
    move.opposite = ReadWord(*order, {"same", "opposite"}) == 1;
  if (const auto end = root.Find("selective_end")) read.swapped = ReadWord(*end, {"same", "swapped"}) == 1;
  return read;
}

knot::Explanation ReadMove(const std::string& argument) {
  std::error_code ignored;
  if (argument != "-" && !std::filesystem::exists(argument, ignored))
    return ParseMove(argument, "<argument>");
  InputFile file(argument);
  return ParseMove(std::string(std::istreambuf_iterator<char>(file.stream()), {}), file.name());
}

std::string MoveToJson(const knot::Explanation& explanation) {
  const knot::Move& move = explanation.move;
  const auto quoted = [](std::string_view word) { return "\"" + std::string(word) + "\""; };
  std::string segments;
  for (int i = 0; i < Find(move.kind).segments; ++i)
    segments += (i == 0 ? "" : ",") + std::to_string(move.segments[static_cast<size_t>(i)]);
  return "{\"kind\":" + quoted(NameOf(move.kind)) + ",\"direction\":" + quoted(NameOf(move.direction)) +
         ",\"segments\":[" + segments +
         "],\"end\":" + (move.end == RopeEnd::kNone ? "null" : quoted(NameOf(move.end))) +
         ",\"selective_end\":" + quoted(explanation.swapped ? "swapped" : "same") +
         ",\"attr\":" + (move.kind == MoveKind::kR3 ? "null" : std::to_string(move.attr)) +
         ",\"order\":" + (move.kind != MoveKind::kR2 ? "null" : quoted(move.opposite ? "opposite" : "same")) +
         "}";
}

}  // namespace tact::input
