#include "robot/input/pose_log_header.h"

#include <algorithm>
#include <cctype>

namespace tact::input {
namespace {

using Words = std::vector<std::string>;

constexpr std::array<std::string_view, kLogFields> kNames = {"time", "x", "y", "z", "qx", "qy", "qz", "qw"};

template <size_t n>
bool IsOneOf(std::string_view word, const std::array<std::string_view, n>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::array<std::string_view, 4> kTimes = {"time", "timestamp", "stamp", "t"};
constexpr std::array<std::string_view, 7> kRotations = {"q",        "quat", "quaternion", "orientation",
                                                        "rotation", "rot",  "attitude"};
constexpr std::array<std::string_view, 7> kLocations = {"p",           "t",     "pos",     "position",
                                                        "translation", "trans", "location"};

struct Name {
  Words words;
  std::string unit;
};

Name ParseName(std::string_view text) {
  Name name;
  const size_t bracket = std::min(text.find_first_of("[("), text.size());
  bool open = false;
  for (const char c : text.substr(0, bracket)) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (letter && !open) name.words.emplace_back();
    if (letter) name.words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    open = letter;
  }
  for (const char c : text.substr(bracket)) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) name.unit += c;
  }
  return name;
}

int Component(char letter, bool rotation) {
  const size_t at = std::string_view("xyzw").find(letter);
  if (at == std::string_view::npos || (at == 3 && !rotation)) return -1;
  return (rotation ? kLogQx : kLogX) + static_cast<int>(at);
}

// The field that a column of this name holds; -1: none.
int FieldOf(const Words& words) {
  if (words.empty()) return -1;
  const std::string& last = words.back();
  if (words.size() == 1) {
    if (IsOneOf(last, kTimes)) return kLogTime;
    if (last.size() == 2 && last[0] == 'q') return Component(last[1], true);
    if (last.size() == 2 && (last[0] == 't' || last[0] == 'p')) return Component(last[1], false);
    return last.size() == 1 ? Component(last[0], false) : -1;
  }
  if (last.size() != 1) return -1;
  const auto has = [&](const auto& known) {
    return std::any_of(words.begin(), words.end() - 1,
                       [&](const std::string& word) { return IsOneOf(word, known); });
  };
  if (has(kRotations)) return Component(last[0], true);
  return has(kLocations) ? Component(last[0], false) : -1;
}

std::vector<std::string> Split(std::string_view line, char separator) {
  std::vector<std::string> fields;
  if (separator != ' ') {
    for (size_t start = 0; start <= line.size();) {
      const size_t end = std::min(line.find(separator, start), line.size());
      fields.emplace_back(line.substr(start, end - start));
      start = end + 1;
    }
    return fields;
  }
  bool open = false;
  for (const char c : line) {
    const bool blank = c == ' ' || c == '\t' || c == '\r';
    if (!blank && !open && (c != '[' || fields.empty())) fields.emplace_back();  // a unit belongs to its name
    if (!blank) fields.back() += c;
    open = !blank;
  }
  return fields;
}

double SecondsOf(const std::string& unit) {
  if (unit == "ns") return 1e-9;
  if (unit == "us") return 1e-6;
  return unit == "ms" ? 1e-3 : 1;
}

}  // namespace

bool LogHeader::knows_any() const {
  return std::any_of(columns.begin(), columns.end(), [](int column) { return column >= 0; });
}

std::vector<std::string_view> LogHeader::Missing() const {
  std::vector<std::string_view> missing;
  for (int field = kLogX; field < kLogFields; ++field) {
    if (columns[field] < 0) missing.push_back(kNames[field]);
  }
  return missing;
}

LogHeader ParseLogHeader(std::string_view line) {
  LogHeader header;
  header.columns.fill(-1);
  line.remove_prefix(std::min(line.find_first_not_of("#% \t"), line.size()));
  if (line.find(',') != std::string_view::npos)
    header.separator = ',';
  else if (line.find(';') != std::string_view::npos)
    header.separator = ';';
  for (const std::string& text : Split(line, header.separator)) {
    const Name name = ParseName(text);
    const int column = header.count++, field = FieldOf(name.words);
    if (field < 0) continue;
    if (header.columns[field] >= 0) header.twice = kNames[field];
    header.columns[field] = column;
    if (field == kLogTime) header.seconds = SecondsOf(name.unit);
    if (field == kLogX) header.unit = cad::ParseLengthUnit(name.unit);
  }
  return header;
}

}  // namespace tact::input
