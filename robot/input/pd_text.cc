#include "robot/input/pd_text.h"

#include "algebra/knot/pd_code.h"
#include "robot/input/json_value.h"

namespace tact::input {
namespace {

constexpr int kMostArcs = 1 << 25;

// One word after another.
class Reader {
 public:
  explicit Reader(const SourceText& text) : text_(text), words_(WordsOf(text, "[],;")) {}

  bool Takes(std::string_view word) {
    if (at_ == words_.size() || words_[at_].text != word) return false;
    ++at_;
    return true;
  }
  void Expect(std::string_view word) {
    if (!Takes(word)) Refuse(Quote(word));
  }
  int Number() {
    if (at_ == words_.size()) Refuse("an arc's number");
    return ReadWholeNumber(text_, words_[at_++], 0, kMostArcs, "an arc's number from 0");
  }
  [[noreturn]] void Refuse(const std::string& expected) const {
    if (at_ == words_.size())
      text_.Fail(text_.text.size(), "expected " + expected + ", got the end of the text");
    text_.Fail(words_[at_].offset, "expected " + expected + ", got " + Quote(words_[at_].text));
  }
  size_t offset() const { return at_ < words_.size() ? words_[at_].offset : text_.text.size(); }
  bool at_end() const { return at_ == words_.size(); }

 private:
  const SourceText& text_;
  std::vector<Word> words_;
  size_t at_ = 0;
};

}  // namespace

bool LooksLikePd(std::string_view text) {
  return text.starts_with("PD") || text.starts_with('X') || text.starts_with('[');
}

knot::PData ParsePd(const SourceText& text) {
  Reader words(text);
  knot::PdCode code;
  std::vector<size_t> places;
  words.Takes("PD");
  words.Expect("[");
  bool more = !words.Takes("]");
  while (more) {
    places.push_back(words.offset());
    words.Takes("X");
    words.Expect("[");
    std::array<int, 4> arcs{};
    for (size_t i = 0; i < 4; ++i) {
      if (i > 0) words.Expect(",");
      arcs[i] = words.Number();
    }
    words.Expect("]");
    code.crossings.push_back(arcs);
    more = words.Takes(",");
    if (!more) words.Expect("]");
  }
  words.Takes(";");
  if (!words.at_end()) words.Refuse("the end of the PD code");
  if (const auto fault = FindPdFault(code)) {
    text.Fail(fault->crossing == 0 ? 0 : places[static_cast<size_t>(fault->crossing) - 1], fault->what);
  }
  return PDataOf(code);
}

}  // namespace tact::input
