#include "robot/input/knot_text.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "algebra/knot/faces.h"
#include "robot/input/curve_text.h"
#include "robot/input/gauss_text.h"
#include "robot/input/json_stream.h"
#include "robot/input/knot_examples.h"
#include "robot/input/pd_text.h"
#include "robot/input/text_token.h"

namespace tact::input {
namespace {

constexpr int kLargestNumber = 1 << 25;
constexpr std::string_view kBlanks = " \t\r\n";

// Whether a fault's column is wrong in the second row, not in the third.
bool MateIsWrong(const std::vector<int>& sigma, int column) {
  const int n = static_cast<int>(sigma.size()), mate = sigma[static_cast<size_t>(column) - 1];
  return mate < 1 || mate > n || mate == column || sigma[static_cast<size_t>(mate) - 1] != column;
}

knot::PData ParseJson(const SourceText& text) {
  const JsonDocument document = JsonDocument::Parse(std::string(text.text), text.source, text.first_line);
  const JsonValue root = document.root();
  root.ExpectObject({"sigma", "attr", "name"});
  if (const auto name = root.Find("name")) name->ReadString("a name");
  const auto read = [](const JsonValue& row) {
    std::vector<int> numbers;
    for (const JsonValue number : row.Elements("an array of numbers"))
      numbers.push_back(static_cast<int>(number.ReadInteger(-kLargestNumber, kLargestNumber)));
    return numbers;
  };
  const JsonValue sigma_row = root.At("sigma"), attr_row = root.At("attr");
  const auto sigma = read(sigma_row), attr = read(attr_row);
  if (const auto fault = knot::PData::FindFault(sigma, attr)) {
    if (fault->column == 0) root.Fail(fault->what);
    const JsonValue& row = MateIsWrong(sigma, fault->column) ? sigma_row : attr_row;
    auto place = row.Elements("").begin();
    for (int i = 1; i < fault->column; ++i) ++place;
    (*place).Fail(fault->what);
  }
  return knot::PData(sigma, attr);
}

// The rows' words; rows end at a '/' or a line's end.
std::vector<std::vector<Word>> RowsOf(const SourceText& text) {
  std::vector<std::vector<Word>> rows;
  bool open = false, wanted = true;  // a row that may go on; a row that a '/' or the start demands
  for (const Word& word : WordsOf(text, "/\n", ",;")) {
    if (word.text == "\n") {
      open = false;
    } else if (word.text == "/") {
      if (wanted) text.Fail(word.offset, "expected a row of numbers, got \"/\"");
      open = false;
      wanted = true;
    } else {
      if (!open) rows.emplace_back();
      rows.back().push_back(word);
      open = true;
      wanted = false;
    }
  }
  if (wanted) text.Fail(text.text.size(), "expected a row of numbers, got the end of the text");
  return rows;
}

knot::PData ParseRows(const SourceText& text) {
  const auto rows = RowsOf(text);
  if (rows.size() == 1 || rows.size() > 3) {
    text.Fail(rows[rows.size() == 1 ? 0 : 3].front().offset,
              "expected two or three rows of numbers, or a Gauss code with its signs, got " +
                  (rows.size() == 1 ? std::string("one row") : "a fourth row"));
  }
  const auto read = [&](const std::vector<Word>& row) {
    std::vector<int> numbers;
    for (const Word& word : row)
      numbers.push_back(ReadWholeNumber(text, word, -kLargestNumber, kLargestNumber, "a whole number"));
    return numbers;
  };
  const std::vector<Word>& mates = rows[rows.size() - 2];
  const std::vector<Word>& attributes = rows.back();
  const auto sigma = read(mates), attr = read(attributes);
  if (rows.size() == 3) {
    for (size_t i = 0; i < rows[0].size(); ++i) {
      const int number = static_cast<int>(i) + 1;
      ReadWholeNumber(text, rows[0][i], number, number,
                      "column number " + std::to_string(number) + " in the first row");
    }
    if (rows[0].size() != sigma.size()) {
      text.Fail(mates.front().offset, "expected as many mates as columns, got " +
                                          std::to_string(sigma.size()) + " and " +
                                          std::to_string(rows[0].size()));
    }
  }
  if (const auto fault = knot::PData::FindFault(sigma, attr)) {
    const size_t index = static_cast<size_t>(std::max(fault->column, 1)) - 1;
    const bool in_mates = fault->column == 0 || MateIsWrong(sigma, fault->column);
    text.Fail((in_mates ? mates : attributes)[index].offset, fault->what);
  }
  return knot::PData(sigma, attr);
}

knot::PData ParseCurve(const SourceText& text) {
  const std::vector<CurveText> curves = ParseCurves(text);
  if (curves.size() > 1)
    text.Fail(curves[1].offsets[0], "expected one curve, got " + std::to_string(curves.size()));
  auto projection = knot::ProjectCurve(curves[0].points, knot::ViewFromAbove());
  if (const auto* fault = std::get_if<knot::CurveFault>(&projection))
    FailAtFault(text, curves[0], *fault, knot::ViewFromAbove());
  return std::get<knot::CurveProjection>(std::move(projection)).p;
}

// Whether an argument that names nothing was meant as P-data, with a mistake in it or not.
bool LooksLikeText(std::string_view argument) {
  const size_t start = argument.find_first_not_of(kBlanks);
  if (start == std::string_view::npos) return false;
  const std::string_view rest = argument.substr(start);
  const auto has_blank = rest.find_first_of(kBlanks) != std::string_view::npos;
  const auto is_in = [&](std::string_view set) { return set.find(rest[0]) != std::string_view::npos; };
  if (is_in("{[(") || rest.starts_with("PD[") || rest.starts_with("X[") || LooksLikeLetteredGauss(rest))
    return true;
  if (rest[0] == '/') return rest.size() == 1 || kBlanks.find(rest[1]) != std::string_view::npos;
  return is_in("+-0123456789") &&
         (has_blank || rest.find_first_not_of("+-0123456789,;/") == std::string_view::npos);
}

}  // namespace

knot::PData ParsePData(std::string_view text, const std::string& source, size_t first_line) {
  const SourceText whole{text, source, first_line};
  const size_t start = text.find_first_not_of(kBlanks);
  if (start == std::string_view::npos) whole.Fail(0, "expected P-data, got an empty text");
  if (LooksLikeCurve(whole)) return ParseCurve(whole);
  const std::string_view rest = text.substr(start);
  const size_t second = rest.find_first_not_of(kBlanks, 1);
  const bool braced_numbers = second != std::string_view::npos &&
                              std::string_view("+-0123456789").find(rest[second]) != std::string_view::npos;
  if (rest[0] == '{' && !braced_numbers) return ParseJson(whole);
  if (rest[0] == '/' && rest.find_first_not_of(kBlanks, 1) == std::string_view::npos) return {};
  if (LooksLikePd(rest)) return ParsePd(whole);
  if (LooksLikeLetteredGauss(rest)) return ParseLetteredGauss(whole);
  if (LooksLikeNumberedGauss(whole)) return ParseNumberedGauss(whole);
  return ParseRows(whole);
}

NamedText FindKnotText(const std::string& argument) {
  std::error_code ignored;
  const bool straight = argument == "/";  // a folder, too
  if (argument == "-" || (!straight && std::filesystem::exists(argument, ignored))) {
    InputFile file(argument);
    std::ostringstream text;
    text << file.stream().rdbuf();
    if (file.stream().bad()) throw InputError(file.name() + ": expected a readable file, got an error in it");
    return {text.str(), file.name()};
  }
  if (const auto example = FindKnotExample(argument)) return {std::string(example->text), example->source};
  if (!LooksLikeText(argument)) {
    throw InputError(Quote(argument) + ": expected a file, P-data or one of the examples (" +
                     KnotExampleNames() + "), got none of these");
  }
  return {argument, "<argument>"};
}

knot::PData ReadPData(const std::string& argument) {
  const NamedText found = FindKnotText(argument);
  return ParsePData(found.text, found.source);
}

std::optional<std::string> FindHandle(const knot::PData& p) {
  const int faces = knot::CountFaces(p), wanted = p.crossings() + 1;
  if (faces == wanted) return std::nullopt;
  return "expected a diagram on a sphere, where " + std::to_string(p.crossings()) + " intersections make " +
         std::to_string(wanted) + " faces, got " + std::to_string(faces) + (faces == 1 ? " face" : " faces") +
         ": genus " + std::to_string((wanted - faces) / 2);
}

knot::PData ReadPlanarPData(const std::string& argument) {
  const NamedText found = FindKnotText(argument);
  const knot::PData p = ParsePData(found.text, found.source);
  if (const auto handle = FindHandle(p)) throw InputError(found.source + ":1:1: " + *handle);
  return p;
}

}  // namespace tact::input
