#include "robot/input/gauss_text.h"

#include <algorithm>
#include <cstdlib>

#include "algebra/knot/gauss_code.h"
#include "robot/input/json_value.h"

namespace tact::input {
namespace {

constexpr std::string_view kSkipped = ",;(){}[]";
constexpr int kMostCrossings = 1 << 24;

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsSign(char c) { return c == '+' || c == '-'; }
bool IsHeight(char c) { return c == 'O' || c == 'U' || c == 'o' || c == 'u'; }
bool IsSigns(const Word& word) { return std::all_of(word.text.begin(), word.text.end(), IsSign); }

knot::PData Checked(const SourceText& text, const knot::GaussCode& code, const std::vector<Word>& places) {
  if (const auto fault = FindGaussFault(code)) {
    text.Fail(fault->pass == 0 ? 0 : places[static_cast<size_t>(fault->pass) - 1].offset, fault->what);
  }
  return PDataOf(code);
}

}  // namespace

bool LooksLikeLetteredGauss(std::string_view text) {
  return text.size() >= 2 && IsHeight(text[0]) && IsDigit(text[1]);
}

bool LooksLikeNumberedGauss(const SourceText& text) {
  const auto words = WordsOf(text, "/", kSkipped);
  return std::any_of(words.begin(), words.end(), IsSigns);
}

knot::PData ParseLetteredGauss(const SourceText& text) {
  knot::GaussCode code;
  std::vector<Word> places;
  std::vector<int> signs;
  for (const Word& word : WordsOf(text, "", ",;")) {
    for (size_t at = 0; at < word.text.size();) {
      size_t end = at + 1;
      while (end < word.text.size() && IsDigit(word.text[end])) ++end;
      const Word pass{word.text.substr(at, end + 1 - at), word.offset + at};
      if (!IsHeight(word.text[at]) || end == at + 1 || end >= word.text.size() || !IsSign(word.text[end])) {
        text.Fail(pass.offset, "expected a pass like O1+ or U2-, got " + Quote(word.text.substr(at)));
      }
      const Word digits{pass.text.substr(1, end - at - 1), pass.offset + 1};
      const int number = ReadWholeNumber(text, digits, 1, kMostCrossings, "an intersection's number from 1");
      const bool over = pass.text[0] == 'O' || pass.text[0] == 'o';
      code.passes.push_back(over ? number : -number);
      signs.push_back(pass.text.back() == '+' ? 1 : -1);
      places.push_back(pass);
      at = end + 1;
    }
  }
  code.signs.assign(code.passes.size() / 2, 0);
  if (code.passes.size() % 2 != 0) {
    text.Fail(text.text.size(), "expected two passes for each intersection, got " +
                                    std::to_string(code.passes.size()) + " passes");
  }
  for (size_t i = 0; i < signs.size(); ++i) {
    const size_t index = static_cast<size_t>(std::abs(code.passes[i])) - 1;
    if (index >= code.signs.size()) continue;  // refused with the whole code
    if (code.signs[index] == -signs[i]) {
      text.Fail(places[i].offset, "expected one sign at intersection " + std::to_string(index + 1) +
                                      ", got both: " + Quote(places[i].text));
    }
    code.signs[index] = signs[i];
  }
  // An intersection that is never met leaves its sign open; some other one is met too often.
  std::replace(code.signs.begin(), code.signs.end(), 0, 1);
  return Checked(text, code, places);
}

knot::PData ParseNumberedGauss(const SourceText& text) {
  knot::GaussCode code;
  std::vector<Word> places;
  bool in_signs = false;
  for (const Word& word : WordsOf(text, "/", kSkipped)) {
    if (word.text == "/" && !in_signs) {
      in_signs = true;
    } else if (IsSigns(word)) {
      in_signs = true;
      for (const char c : word.text) code.signs.push_back(c == '+' ? 1 : -1);
    } else if (in_signs) {
      const bool complete = places.size() == 2 * code.signs.size();
      text.Fail(word.offset,
                std::string("expected ") +
                    (complete ? "the end of the Gauss code, since no face of P-data is the outer one"
                              : "signs + and - to the end of the Gauss code") +
                    ", got " + Quote(word.text));
    } else {
      code.passes.push_back(ReadWholeNumber(text, word, -kMostCrossings, kMostCrossings,
                                            "an intersection's number, negative for a pass under"));
      places.push_back(word);
    }
  }
  return Checked(text, code, places);
}

}  // namespace tact::input
