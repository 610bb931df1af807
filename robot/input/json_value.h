/// @file
/// JSON text as values that know their place, so that every refusal can name file, line and column.
/// Model   A document owns the text and one 16-byte node a value, in the order of the text; a JsonValue is a
/// handle
///         into it. Numbers stay text until they are read, so none is ever rounded.
/// Exact   a number is the decimal it writes; where a number is wanted, a string "p/q" will do.
/// Errors  InputError `source:line:column: expected this, got that`: bad syntax, a key given twice, nesting
/// beyond
///         kDeepestNesting, a number beyond the range of a double or longer than kLongestNumber.
/// Cost    16 bytes a value beside the text; finding a key is linear in the object's keys.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/error.h"
#include "algebra/screw/vector3.h"

namespace tact::input {

inline constexpr size_t kDeepestNesting = 64;       // our forms need 6
inline constexpr size_t kLongestNumber = 2000;      // characters; powers of ten are built by multiplication
inline constexpr size_t kLongestText = 0xFFFFFFFF;  // offsets have 32 bits

/// The text ends before its value does.
class CutShortError : public InputError {
 public:
  using InputError::InputError;
};

enum class JsonKind : uint8_t { kNull, kFalse, kTrue, kNumber, kString, kArray, kObject };

class JsonValue;

class JsonDocument {
 public:
  /// source names the text in messages; its first line is number first_line there.
  static JsonDocument Parse(std::string text, std::string source, size_t first_line = 1);

  /// Valid while the document lives and does not move.
  JsonValue root() const;
  const std::string& source() const { return source_; }
  /// "source:line:column" of a byte of the text; columns count characters from 1.
  std::string Where(size_t offset) const;

 private:
  friend class JsonValue;
  friend class JsonBuilder;

  // A value; its subtree is nodes [own index, end). In an object keys (strings) and values alternate.
  struct Node {
    uint32_t offset;  // of the first character in the text
    uint32_t end;
    uint32_t extra;  // array, object: number of members; string: index into unescaped_ or kNone
    JsonKind kind;
  };
  static constexpr uint32_t kNone = 0xFFFFFFFF;

  std::string_view String(const Node& node) const;
  std::string_view Number(const Node& node) const;

  std::string text_;
  std::string source_;
  size_t first_line_ = 1;
  std::vector<Node> nodes_;
  std::vector<std::string> unescaped_;  // the strings written with escapes
};

/// A value in a document: a handle, cheap to copy.
class JsonValue {
 public:
  class Iterator;
  class Range;

  JsonKind kind() const { return node().kind; }
  bool is_object() const { return kind() == JsonKind::kObject; }
  bool is_array() const { return kind() == JsonKind::kArray; }

  /// Refuses what is no object and, naming the known keys, an object with any other key.
  void ExpectObject(std::initializer_list<std::string_view> known_keys) const;
  /// The member of that key; precondition: an object.
  std::optional<JsonValue> Find(std::string_view key) const;
  /// The same, refused if absent.
  JsonValue At(std::string_view key) const;

  /// The elements of an array; `what` names what was expected: "an array of contacts".
  Range Elements(std::string_view what) const;
  /// Number of elements or members.
  size_t size() const { return node().extra; }

  algebra::Rational ReadRational() const;
  /// Within [low, high].
  int64_t ReadInteger(int64_t low, int64_t high) const;
  std::string ReadString(std::string_view what) const;
  algebra::Vector3 ReadVector3() const;
  /// count numbers; shape shows them: "[w, x, y, z]".
  std::vector<algebra::Rational> ReadNumbers(size_t count, std::string_view shape) const;

  /// "source:line:column".
  std::string Where() const { return document_->Where(node().offset); }
  /// What it is, for people: "an array of 2 values", "the number 3".
  std::string Describe() const;
  /// Throws InputError `source:line:column: message`.
  [[noreturn]] void Fail(const std::string& message) const;
  /// Throws InputError `source:line:column: expected what, got <Describe()>`.
  [[noreturn]] void FailExpected(std::string_view what) const;

 private:
  friend class JsonDocument;
  JsonValue(const JsonDocument* document, uint32_t index) : document_(document), index_(index) {}
  const JsonDocument::Node& node() const { return document_->nodes_[index_]; }

  const JsonDocument* document_;
  uint32_t index_;
};

class JsonValue::Iterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = JsonValue;
  using difference_type = std::ptrdiff_t;
  using pointer = const JsonValue*;
  using reference = JsonValue;

  explicit Iterator(JsonValue at) : at_(at) {}
  JsonValue operator*() const { return at_; }
  Iterator& operator++() {
    at_.index_ = at_.node().end;
    return *this;
  }
  bool operator==(const Iterator& other) const { return at_.index_ == other.at_.index_; }

 private:
  JsonValue at_;
};

class JsonValue::Range {
 public:
  explicit Range(JsonValue array) : array_(array) {}
  Iterator begin() const { return Iterator(JsonValue(array_.document_, array_.index_ + 1)); }
  Iterator end() const { return Iterator(JsonValue(array_.document_, array_.node().end)); }
  size_t size() const { return array_.size(); }

 private:
  JsonValue array_;
};

/// The text in quotes, shortened when long, its control characters shown as '?'.
std::string Quote(std::string_view text);
/// "a", "a and b", "a, b and c", each in quotes.
std::string QuoteList(const std::vector<std::string_view>& words);

}  // namespace tact::input
