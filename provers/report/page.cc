#include "provers/report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "provers/report/html.h"
#include "provers/report/text.h"
#include "provers/report/thesis_outline.h"

namespace tact::provers {
namespace {

constexpr std::array kVerdicts = {Verdict::kProved,     Verdict::kHoldsTo,       Verdict::kRefuted,
                                  Verdict::kReproduced, Verdict::kNotReproduced, Verdict::kUndecided};

struct Verdicts {
  std::array<size_t, kVerdicts.size()> counts{};
  double seconds = 0;
  size_t certificates = 0;
};

Verdicts Count(const std::vector<LedgerEntry>& entries) {
  Verdicts all;
  for (const LedgerEntry& entry : entries) {
    const auto kind =
        std::find(kVerdicts.begin(), kVerdicts.end(), entry.outcome.verdict) - kVerdicts.begin();
    ++all.counts.at(static_cast<size_t>(kind));
    all.seconds += entry.seconds;
    all.certificates += entry.outcome.certificates.size();
  }
  return all;
}

struct Section {
  std::string title;  // may be empty: claims on a whole chapter
  std::vector<const LedgerEntry*> entries;
};

struct Chapter {
  std::string title;
  std::vector<Section> sections;
};

std::vector<Chapter> InThesisOrder(const std::vector<LedgerEntry>& entries) {
  std::vector<std::pair<Place, const LedgerEntry*>> placed;
  for (const LedgerEntry& entry : entries) placed.emplace_back(PlaceOf(entry.claim), &entry);
  std::stable_sort(placed.begin(), placed.end(),
                   [](const auto& a, const auto& b) { return ComesBefore(a.first, b.first); });
  std::vector<Chapter> chapters;
  for (const auto& [place, entry] : placed) {
    const std::string chapter = ChapterTitle(place), section = SectionTitle(place);
    if (chapters.empty() || chapters.back().title != chapter) chapters.push_back({chapter, {}});
    std::vector<Section>& sections = chapters.back().sections;
    if (sections.empty() || sections.back().title != section) sections.push_back({section, {}});
    sections.back().entries.push_back(entry);
  }
  return chapters;
}

std::string Head(size_t claims, const Verdicts& verdicts) {
  std::string html = fmt::format(
      "<header class=\"top\">\n<h1>A thesis on trial</h1>\n"
      "<p class=\"lead\">The ledger of tact: {}, each stated before it was tried.</p>\n"
      "<p>The thesis <cite>Abstraction of Manipulation Tasks to Automatically Generate Robot Motion from "
      "Observation</cite> says how a robot can learn to assemble, to open and to tie by watching. "
      "Here its definitions run in exact arithmetic and its claims are enumerated, proved, refuted or "
      "measured. "
      "Every verdict comes with its evidence. Where that is a certificate, <code>tact-check</code>, a small "
      "program that shares no code with the engines, can check it again.</p>\n",
      Plural(claims, "claim"));
  html += "<ul class=\"counts\" aria-label=\"Verdicts\">\n";
  for (size_t i = 0; i < kVerdicts.size(); ++i) {
    if (verdicts.counts[i] == 0) continue;
    html += fmt::format("<li><b>{}</b> {}</li>\n", verdicts.counts[i], VerdictChip(kVerdicts[i]));
  }
  html += fmt::format("</ul>\n<p class=\"small\">{} \u00B7 {} of work</p>\n</header>\n",
                      Plural(verdicts.certificates, "certificate"), ReadableSeconds(verdicts.seconds));
  return html;
}

constexpr const char* kLegend =
    "<details class=\"legend\"><summary>What the verdicts mean</summary>\n<dl>\n"
    "<div><dt>{}</dt><dd>shown for every case, by a certificate or a finite check that covers "
    "everything</dd></div>\n"
    "<div><dt>{}</dt><dd>every case up to the stated bound was tried, and it held</dd></div>\n"
    "<div><dt>{}</dt><dd>false; the smallest counterexample is given</dd></div>\n"
    "<div><dt>{}</dt><dd>a printed number or table came out again</dd></div>\n"
    "<div><dt>{}</dt><dd>a printed number or table did not come out</dd></div>\n"
    "<div><dt>{}</dt><dd>neither shown nor refuted, and why</dd></div>\n"
    "</dl></details>\n";

std::string Legend() {
  return fmt::format(fmt::runtime(kLegend), VerdictChip(kVerdicts[0]), VerdictChip(kVerdicts[1]),
                     VerdictChip(kVerdicts[2]), VerdictChip(kVerdicts[3]), VerdictChip(kVerdicts[4]),
                     VerdictChip(kVerdicts[5]));
}

std::string Filter() {
  std::string html =
      "<form class=\"filter\" hidden=\"hidden\"><input type=\"search\" placeholder=\"Find in claims\" "
      "aria-label=\"Find in claims\"/>"
      "<select aria-label=\"Verdict\"><option value=\"\">every verdict</option>";
  for (const Verdict verdict : kVerdicts) {
    html += fmt::format("<option value=\"{}\">{}</option>", VerdictStyle(verdict), ToString(verdict));
  }
  return html + "</select><output class=\"small\"></output></form>\n";
}

std::string Contents(const std::vector<Chapter>& chapters) {
  std::string html =
      "<nav aria-labelledby=\"contents\">\n<h2 id=\"contents\">Contents</h2>\n" + Legend() + Filter();
  if (chapters.empty()) html += "<p>No claim was tried.</p>\n";
  for (const Chapter& chapter : chapters) {
    html += fmt::format("<section>\n<h3>{}</h3>\n", Escape(chapter.title));
    for (const Section& section : chapter.sections) {
      html += "<section>\n";
      if (!section.title.empty()) html += fmt::format("<h4>{}</h4>\n", Escape(section.title));
      html += "<ul>\n";
      for (const LedgerEntry* entry : section.entries) {
        html += fmt::format("<li>{}<a href=\"#{}\">{}</a></li>\n", VerdictChip(entry->outcome.verdict),
                            Escape(entry->claim.id), Escape(entry->claim.statement));
      }
      html += "</ul>\n</section>\n";
    }
    html += "</section>\n";
  }
  return html + "</nav>\n";
}

std::string Claims(const std::vector<Chapter>& chapters) {
  std::string html = "<main>\n";
  for (const Chapter& chapter : chapters) {
    html += fmt::format("<section>\n<h2>{}</h2>\n", Escape(chapter.title));
    for (const Section& section : chapter.sections) {
      html += "<section>\n";
      if (!section.title.empty()) html += fmt::format("<h3>{}</h3>\n", Escape(section.title));
      const int level = section.title.empty() ? 3 : 4;
      for (const LedgerEntry* entry : section.entries) html += ClaimArticle(*entry, level);
      html += "</section>\n";
    }
    html += "</section>\n";
  }
  return html + "</main>\n";
}

}  // namespace

std::string ReportPage(const std::vector<LedgerEntry>& entries) {
  const std::vector<Chapter> chapters = InThesisOrder(entries);
  return PageHtml("tact: a thesis on trial", Head(entries.size(), Count(entries)) + Contents(chapters) +
                                                 Claims(chapters) +
                                                 fmt::format("<script>\n{}</script>\n", kPageScript));
}

}  // namespace tact::provers
