#include "provers/report/thesis_outline.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>

namespace tact::provers {
namespace {

const std::map<std::string, std::string, std::less<>>& Titles() {
  static const std::map<std::string, std::string, std::less<>> titles = {
      {"1", "Introduction"},
      {"2", "Recognizing assembly tasks with two rigid polyhedral objects"},
      {"2.1", "Formulating legal infinitesimal displacement"},
      {"2.2", "Indexing infinitesimal displacement"},
      {"2.3", "Transitions of contact relations"},
      {"2.4", "Sub-skills"},
      {"2.5", "Critical transitions"},
      {"2.6", "From DOF-transitions to sub-skills and critical transitions"},
      {"2.7", "Extracting assembly task information from observation"},
      {"2.8", "Experiment"},
      {"3", "Constrained motion to second order"},
      {"3.1", "Preliminaries"},
      {"3.2", "Formulating the second order approximation"},
      {"3.3", "Maintaining and legal displacement to second order"},
      {"3.4", "Examples"},
      {"4", "Estimating parameters of joints from observation"},
      {"4.1", "Preliminary"},
      {"4.2", "Prismatic joint"},
      {"4.3", "Revolute joint"},
      {"4.4", "Screw joint"},
      {"4.5", "Implementation and experiment"},
      {"4.6", "Other types of joints"},
      {"5", "Recognizing knot-tying tasks with one rope"},
      {"5.1", "Knot-state representation"},
      {"5.2", "Movement primitives"},
      {"5.3", "Movement primitives from P-data transitions"},
      {"5.4", "Examples"},
      {"6", "Conclusions and future directions"},
      {"A", "Sub-skill implementation"},
      {"A.1", "Preliminaries"},
      {"A.2", "Calculating optimal trajectories"},
      {"A.3", "Translational case"},
      {"A.4", "Rotational case"},
      {"A.5", "Example of optimal trajectories I"},
      {"A.6", "Problem of the calculation and its solution"},
      {"A.7", "Implementation on the test-bed"},
      {"A.8", "Experiment"},
      {"A.9", "Discussion"},
      {"B", "Legal displacement to second order"},
      {"B.1", "Singular object primitives"},
      {"B.2", "Formulating legal displacement"},
      {"B.3", "Summary of formulation"},
      {"C", "From second order screws to object configurations"},
  };
  return titles;
}

std::string TitleOf(const std::string& number) {
  const auto found = Titles().find(number);
  return found == Titles().end() ? std::string() : found->second;
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// The number at the start of the text: a chapter 1 to 6 or A to C, then dots with numbers; empty if there is
// none.
Place LeadingPlace(std::string_view text) {
  if (text.empty() || !TitleOf(std::string(1, text[0])).size()) return {};
  Place place = {std::string(1, text[0])};
  size_t i = 1;
  while (i + 1 < text.size() && text[i] == '.' && IsDigit(text[i + 1])) {
    const size_t end = std::min(text.find_first_not_of("0123456789", i + 1), text.size());
    place.emplace_back(text.substr(i + 1, end - i - 1));
    i = end;
  }
  const bool ends_here = i == text.size() || !std::isalnum(static_cast<unsigned char>(text[i]));
  return ends_here ? place : Place();
}

int CompareNumbers(const std::string& a, const std::string& b) {
  const bool a_digits = IsDigit(a[0]), b_digits = IsDigit(b[0]);
  if (a_digits != b_digits) return a_digits ? -1 : 1;
  if (a_digits && a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  return a.compare(b);
}

}  // namespace

Place PlaceOf(const Claim& claim) {
  std::string_view source = claim.source;
  for (const std::string_view word :
       {"Chapter ", "Appendix ", "Section ", "Sections ", "chapter ", "section "}) {
    if (source.starts_with(word)) source.remove_prefix(word.size());
  }
  Place place = LeadingPlace(source);
  constexpr std::string_view kPrefix = "thesis.";
  if (place.empty() && claim.id.starts_with(kPrefix)) {
    place = LeadingPlace(std::string_view(claim.id).substr(kPrefix.size()));
  }
  return place;
}

bool ComesBefore(const Place& a, const Place& b) {
  if (a.empty() || b.empty()) return !a.empty() && b.empty();
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (const int order = CompareNumbers(a[i], b[i]); order != 0) return order < 0;
  }
  return a.size() < b.size();
}

std::string ChapterTitle(const Place& place) {
  if (place.empty()) return "Beyond the thesis";
  const std::string word = IsDigit(place[0][0]) ? "Chapter " : "Appendix ";
  return word + place[0] + ": " + TitleOf(place[0]);
}

std::string SectionTitle(const Place& place) {
  if (place.size() < 2) return "";
  const std::string number = place[0] + "." + place[1];
  const std::string title = TitleOf(number);
  return title.empty() ? number : number + " " + title;
}

}  // namespace tact::provers
