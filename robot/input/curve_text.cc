#include "robot/input/curve_text.h"

#include <algorithm>

#include "algebra/error.h"
#include "robot/input/json_value.h"

namespace tact::input {
namespace {

using algebra::Rational;
using algebra::Vector3;

constexpr std::string_view kSeparators = ",;";

struct Line {
  std::vector<Word> words;  // up to a comment
  size_t end = 0;           // offset
};

std::vector<Line> LinesOf(const SourceText& text) {
  std::vector<Line> lines;
  bool comment = false;
  lines.emplace_back();
  for (const Word& word : WordsOf(text, "\n#", kSeparators)) {
    if (word.text == "\n") {
      lines.back().end = word.offset;
      lines.emplace_back();
      comment = false;
    } else if (word.text == "#" || comment) {
      comment = true;
    } else {
      lines.back().words.push_back(word);
    }
  }
  lines.back().end = text.text.size();
  return lines;
}

bool EndsCurve(const Line& line) {
  return line.words.size() == 1 && line.words[0].text.size() >= 3 &&
         line.words[0].text.find_first_not_of('-') == std::string_view::npos;
}

bool LooksLikeNumber(std::string_view word) {
  return word.find_first_not_of("+-.0123456789eE/") == std::string_view::npos
             ? word.find_first_of("0123456789") != std::string_view::npos
             : word.find_first_not_of("+-naifNAIFtyTY") == std::string_view::npos;
}

Rational ReadNumber(const SourceText& text, const Word& word) {
  const auto number = Rational::Parse(word.text);
  if (!number)
    text.Fail(word.offset, "expected a number, finite, as a decimal or p/q, got " + Quote(word.text));
  return *number;
}

}  // namespace

bool LooksLikeCurve(const SourceText& text) {
  if (text.source.ends_with(".xyz")) return true;
  for (const Line& line : LinesOf(text)) {
    if (line.words.empty()) continue;
    return line.words.size() == 3 && std::all_of(line.words.begin(), line.words.end(),
                                                 [](const Word& word) { return LooksLikeNumber(word.text); });
  }
  return false;
}

std::vector<CurveText> ParseCurves(const SourceText& text) {
  std::vector<CurveText> curves(1);
  for (const Line& line : LinesOf(text)) {
    if (line.words.empty()) continue;
    if (EndsCurve(line)) {
      if (curves.back().points.empty())
        text.Fail(line.words[0].offset,
                  "expected a point of the curve, x y z, got " + Quote(line.words[0].text));
      curves.emplace_back();
      continue;
    }
    Vector3 point;
    for (size_t i = 0; i < std::min<size_t>(3, line.words.size()); ++i)
      point[static_cast<int>(i)] = ReadNumber(text, line.words[i]);
    if (line.words.size() < 3) {
      text.Fail(line.end,
                "expected three numbers, x y z, got " + std::string(line.words.size() == 1 ? "one" : "two"));
    }
    if (line.words.size() > 3) {
      text.Fail(line.words[3].offset,
                "expected the end of the line after x y z, got " + Quote(line.words[3].text));
    }
    curves.back().points.push_back(point);
    curves.back().offsets.push_back(line.words[0].offset);
  }
  if (curves.back().points.empty())
    text.Fail(text.text.size(), "expected a point of the curve, x y z, got the end of the text");
  return curves;
}

CurveView ParseView(const std::string& text, const std::string& what) {
  if (text == "auto") return std::nullopt;
  const SourceText source{text, what, 1};
  const auto words = WordsOf(source, ",");
  Vector3 view;
  bool good = words.size() == 5;
  for (size_t i = 0; good && i < words.size(); ++i) {
    if (i % 2 == 1) {
      good = words[i].text == ",";
    } else {
      const auto number = Rational::Parse(words[i].text);
      good = number.has_value();
      if (good) view[static_cast<int>(i / 2)] = *number;
    }
  }
  if (!good) throw InputError(what + ": expected X,Y,Z or auto, got " + Quote(text));
  if (view.IsZero()) throw InputError(what + ": expected a direction that is not zero, got " + Quote(text));
  return view;
}

void FailAtFault(const SourceText& text, const CurveText& curve, const knot::CurveFault& fault,
                 const CurveView& view) {
  const size_t point = fault.points.empty() ? 1 : static_cast<size_t>(fault.points.back());
  std::string message = fault.what();
  if (fault.of_view()) {
    message += view ? "; so it is seen from " + ToString(*view) + ", --view auto tries others"
                    : "; so it is seen from above, and no other view that was tried is without a fault";
  }
  text.Fail(curve.offsets[point - 1], message);
}

}  // namespace tact::input
