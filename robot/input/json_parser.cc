// The only file that sees the JSON package: it turns the package's events into nodes, and its complaints into
// ours.
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "robot/input/json_value.h"

namespace tact::input {
namespace {

constexpr std::string_view kWhitespace = " \t\r\n";
constexpr std::string_view kWordCharacters =
    "0123456789+-._ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";

constexpr std::string_view kNumberStarts = "0123456789+-.";
constexpr size_t kLongestWord = 40;  // of a bad token, shown in a message

bool IsNumberCharacter(char c) {
  return std::string_view("0123456789+-.eE").find(c) != std::string_view::npos;
}

// Walks the text and leaves its position where we can see it.
class CountingIterator {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, const char** position) : at_(at), position_(position) {}
  const char& operator*() const { return *at_; }
  CountingIterator& operator++() {
    *position_ = ++at_;
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  const char** position_;
};

}  // namespace

// Takes the package's events. After an event the position is just behind its token, or one further for a
// number (the character that ended it has been read).
class JsonBuilder {
 public:
  explicit JsonBuilder(JsonDocument& document)
      : document_(document), text_(document.text_), position_(document.text_.data()) {}

  void Run() {
    if (const size_t zero = text_.find('\0'); zero != std::string::npos) {
      throw InputError(document_.Where(zero) + ": expected UTF-8 text, got a zero byte");
    }
    if (text_.starts_with("\xEF\xBB\xBF")) last_end_ = 3;  // a byte order mark, which the package skips
    const CountingIterator first(text_.data(), &position_);
    const CountingIterator last(text_.data() + text_.size(), &position_);
    if (!nlohmann::json::sax_parse(first, last, this)) throw InvariantError("JSON refused without a reason");
  }

  bool null() { return AddLiteral(JsonKind::kNull, 4); }
  bool boolean(bool value) {
    return value ? AddLiteral(JsonKind::kTrue, 4) : AddLiteral(JsonKind::kFalse, 5);
  }
  bool number_integer(int64_t) { return AddNumber(); }
  bool number_unsigned(uint64_t) { return AddNumber(); }
  bool number_float(double, const std::string&) { return AddNumber(); }
  bool binary(std::vector<uint8_t>&) { throw InvariantError("JSON text has no binary values"); }
  bool string(std::string& value) {
    CountElement();
    return AddString(value);
  }
  bool key(std::string& value) {
    ++document_.nodes_[open_.back()].extra;
    return AddString(value);
  }
  bool start_object(size_t) { return Open(JsonKind::kObject); }
  bool start_array(size_t) { return Open(JsonKind::kArray); }
  bool end_array() { return Close(); }
  bool end_object() {
    RefuseRepeatedKeys();
    return Close();
  }

  template <typename Exception>
  [[noreturn]] bool parse_error(size_t characters_read, const std::string&, const Exception& complaint) {
    // What was read last stands in the complaint too; it must not be taken for the package's words.
    std::string words = complaint.what();
    if (const size_t quoted = words.find("; last read: '"); quoted != std::string::npos) {
      words.erase(quoted, words.rfind('\'') + 1 - quoted);
    }
    Refuse(characters_read, words);
  }

 private:
  size_t Offset() const { return static_cast<size_t>(position_ - text_.data()); }

  void CountElement() {
    if (open_.empty()) return;
    JsonDocument::Node& parent = document_.nodes_[open_.back()];
    if (parent.kind == JsonKind::kArray) ++parent.extra;
  }

  void Add(JsonKind kind, size_t start, size_t end, uint32_t extra) {
    const uint32_t next = static_cast<uint32_t>(document_.nodes_.size() + 1);
    document_.nodes_.push_back({static_cast<uint32_t>(start), next, extra, kind});
    last_end_ = end;
  }

  bool AddLiteral(JsonKind kind, size_t length) {
    CountElement();
    Add(kind, Offset() - length, Offset(), 0);
    return true;
  }

  bool AddNumber() {
    CountElement();
    size_t start = Offset();
    if (!IsNumberCharacter(text_[start - 1])) --start;
    while (start > 0 && IsNumberCharacter(text_[start - 1])) --start;
    size_t end = start;
    while (end < text_.size() && IsNumberCharacter(text_[end])) ++end;
    Add(JsonKind::kNumber, start, end, 0);
    return true;
  }

  // A quote opens or closes a string unless an odd number of backslashes stands before it.
  bool AddString(std::string& value) {
    const size_t close = Offset() - 1;
    size_t start = close;
    for (bool escaped = true; escaped;) {
      start = text_.rfind('"', start - 1);
      size_t backslashes = 0;
      while (backslashes < start && text_[start - 1 - backslashes] == '\\') ++backslashes;
      escaped = backslashes % 2 == 1;
    }
    uint32_t extra = JsonDocument::kNone;
    if (std::string_view(text_).substr(start, close - start).find('\\') != std::string_view::npos) {
      extra = static_cast<uint32_t>(document_.unescaped_.size());
      document_.unescaped_.push_back(value);
    }
    Add(JsonKind::kString, start, Offset(), extra);
    return true;
  }

  bool Open(JsonKind kind) {
    CountElement();
    if (open_.size() == kDeepestNesting) {
      throw InputError(document_.Where(Offset() - 1) + ": expected at most " +
                       std::to_string(kDeepestNesting) + " levels of brackets, got one more");
    }
    open_.push_back(static_cast<uint32_t>(document_.nodes_.size()));
    Add(kind, Offset() - 1, Offset(), 0);
    return true;
  }

  bool Close() {
    document_.nodes_[open_.back()].end = static_cast<uint32_t>(document_.nodes_.size());
    open_.pop_back();
    last_end_ = Offset();
    return true;
  }

  void RefuseRepeatedKeys() {
    keys_.clear();
    const std::vector<JsonDocument::Node>& nodes = document_.nodes_;
    for (size_t i = open_.back() + size_t{1}; i < nodes.size(); i = nodes[i + 1].end) {
      keys_.emplace_back(document_.String(nodes[i]), nodes[i].offset);
    }
    std::sort(keys_.begin(), keys_.end());
    const auto twice = std::adjacent_find(keys_.begin(), keys_.end(),
                                          [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice == keys_.end()) return;
    throw InputError(document_.Where((twice + 1)->second) + ": expected each key once, got " +
                     Quote(twice->first) + " again (first at " + document_.Where(twice->second) + ")");
  }

  // Where the token that ends at `end` begins: behind the last good one, blanks and at most one separator.
  size_t BadTokenStart(size_t end) const {
    size_t start = text_.find_first_not_of(kWhitespace, last_end_);
    if (start == std::string::npos) return text_.size();
    const bool separator = text_[start] == ',' || text_[start] == ':';
    if (separator && start + 1 < end) start = text_.find_first_not_of(kWhitespace, start + 1);
    return std::min(start, text_.size());
  }

  static std::string DescribeCharacter(char c) {
    if (c > 0x20 && c < 0x7F) return std::string("'") + c + "'";
    char name[16];
    std::snprintf(name, sizeof name, "0x%02X", static_cast<unsigned char>(c));
    return std::string("the byte ") + name;
  }

  std::string DescribeToken(size_t start) const {
    if (start >= text_.size()) return "the end of the text";
    const std::string_view rest = std::string_view(text_).substr(start);
    if (rest[0] == '"') return "the string " + Quote(rest.substr(1, rest.find('"', 1) - 1));
    const size_t length = std::min(rest.find_first_not_of(kWordCharacters), rest.size());
    if (length == 0) return DescribeCharacter(rest[0]);
    return std::string(rest.substr(0, std::min(length, kLongestWord))) + (length > kLongestWord ? "..." : "");
  }

  [[noreturn]] void Fail(size_t offset, const std::string& what) const {
    throw InputError(document_.Where(offset) + ": expected " + what);
  }

  // The package says what it was reading and what displeased it; we say it in our words, at the place itself.
  [[noreturn]] void Refuse(size_t characters_read, std::string_view complaint) const {
    const auto says = [&](std::string_view words) { return complaint.find(words) != std::string_view::npos; };
    if (characters_read > text_.size())
      FailCut(says("invalid string") ? "a closing quote" : Expected(complaint));
    const size_t last = characters_read == 0 ? 0 : characters_read - 1;
    const std::string character = DescribeCharacter(text_[last]);
    if (says("must be escaped")) Fail(last, "a closing quote, got " + character + " in a string");
    if (says("after backslash")) Fail(last, "one of \" \\ / b f n r t u after a backslash, got " + character);
    if (says("hex digits")) Fail(last, "four hexadecimal digits after \\u, got " + character);
    if (says("surrogate")) Fail(last, "a surrogate pair \\uD8.. \\uDC.., got one half of it");
    if (says("ill-formed UTF-8")) {
      size_t lead = last;  // the package stops behind the byte that promised more
      while (lead > 0 && last - lead < 3 && (text_[lead] & 0xC0) != 0xC0) --lead;
      const size_t culprit = (text_[lead] & 0xC0) == 0xC0 ? lead : last;
      Fail(culprit, "UTF-8 text, got " + DescribeCharacter(text_[culprit]));
    }

    size_t start = BadTokenStart(characters_read);
    const bool number_goes_on = start >= characters_read;  // 01, 1-2, 1.5.3
    if (number_goes_on) start = document_.nodes_.back().offset;
    const std::string got = DescribeToken(start);
    if (says("number overflow")) Fail(start, "a number within the range of a double, got " + got);
    const std::string unsigned_got = got[0] == '-' ? got.substr(1) : got;
    for (const char* word : {"NaN", "nan", "Infinity", "inf"}) {
      if (unsigned_got == word) Fail(start, "a finite number, got " + got);
    }
    if (got == "'/'" && !open_.empty() && document_.nodes_.back().kind == JsonKind::kNumber) {
      Fail(start, Expected(complaint) + ", got '/'; a fraction goes in quotes: \"1/3\"");
    }
    const bool number = number_goes_on ||
                        (says("parsing value") && kNumberStarts.find(text_[start]) != std::string_view::npos);
    Fail(start, (number ? "a number as JSON writes it" : Expected(complaint)) + ", got " + got);
  }

  static std::string Expected(std::string_view complaint) {
    const auto says = [&](std::string_view words) { return complaint.find(words) != std::string_view::npos; };
    if (says("; expected end of input")) return "the end of the text (several values go one a line)";
    if (says("parsing object key")) return "a key in quotes";
    if (says("parsing object separator")) return "':' after the key";
    if (says("parsing object")) return "',' or '}'";
    if (says("parsing array")) return "',' or ']'";
    return "a value";
  }

  [[noreturn]] void FailCut(const std::string& expected) const {
    std::string message =
        document_.Where(text_.size()) + ": expected " + expected + ", got the end of the text";
    if (!open_.empty()) {
      const JsonDocument::Node& open = document_.nodes_[open_.back()];
      message += std::string("; the ") + (open.kind == JsonKind::kArray ? "array" : "object") +
                 " that begins at " + document_.Where(open.offset) + " is not closed";
    }
    throw CutShortError(message);
  }

  JsonDocument& document_;
  const std::string& text_;
  const char* position_;
  size_t last_end_ = 0;         // behind the last token that was taken
  std::vector<uint32_t> open_;  // the arrays and objects not yet closed
  std::vector<std::pair<std::string_view, uint32_t>> keys_;
};

JsonDocument JsonDocument::Parse(std::string text, std::string source, size_t first_line) {
  JsonDocument document;
  document.text_ = std::move(text);
  document.source_ = std::move(source);
  document.first_line_ = first_line;
  if (document.text_.size() > kLongestText) {
    throw InputError(document.source_ + ":" + std::to_string(first_line) +
                     ":1: expected a value of less than 4 GiB (several go one a line), got a longer one");
  }
  JsonBuilder(document).Run();
  return document;
}

}  // namespace tact::input
