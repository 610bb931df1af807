#include <fmt/format.h>

#include <cstddef>
#include <string_view>

#include "provers/report/html.h"
#include "provers/report/ledger_json.h"
#include "provers/report/page.h"
#include "provers/report/text.h"

namespace tact::provers {
namespace {

struct VerdictLook {
  const char* style;
  const char* sign;
};

VerdictLook LookOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kProved:
      return {"proved", "\u2713"};
    case Verdict::kHoldsTo:
      return {"holds", "\u2264"};
    case Verdict::kRefuted:
      return {"refuted", "\u2717"};
    case Verdict::kReproduced:
      return {"reproduced", "\u2248"};
    case Verdict::kNotReproduced:
      return {"not-reproduced", "\u2249"};
    case Verdict::kUndecided:
      break;
  }
  return {"undecided", "?"};
}

// Paragraphs are set apart by blank lines; one whose lines all start with a space keeps its lines as they
// are.
std::string Prose(std::string_view text) {
  std::string html;
  while (!text.empty()) {
    const size_t end = text.find("\n\n");
    const std::string_view paragraph = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    if (paragraph.find_first_not_of(" \n") == std::string_view::npos) continue;
    bool kept = paragraph[0] == ' ';
    for (size_t i = 1; kept && i < paragraph.size(); ++i)
      kept = paragraph[i - 1] != '\n' || paragraph[i] == ' ';
    html += fmt::format("<{0}>{1}</{0}>\n", kept ? "pre" : "p", Escape(paragraph));
  }
  return html;
}

std::string NumbersHtml(const Outcome& outcome) {
  if (outcome.numbers.empty()) return "";
  std::string html = "<table class=\"numbers\"><caption>Numbers</caption>\n<tbody>\n";
  for (const auto& [name, value] : outcome.numbers) {
    html += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td></tr>\n", Escape(name),
                        GroupedDigits(value));
  }
  return html + "</tbody></table>\n";
}

std::string CertificatesHtml(const Outcome& outcome) {
  if (outcome.certificates.empty()) {
    if (outcome.no_certificate.empty()) return "";
    return fmt::format("<p class=\"certificates\"><b>No certificate.</b> {}</p>\n",
                       Escape(outcome.no_certificate));
  }
  std::string links;
  for (const Certificate& certificate : outcome.certificates) {
    links += fmt::format("<li><a href=\"{0}\">{0}</a> <small>{1}</small></li>\n",
                         Escape(CertificatePath(certificate)), ReadableSize(certificate.json.size()));
  }
  const size_t count = outcome.certificates.size();
  constexpr size_t kShown = 6;
  if (count <= kShown) {
    return fmt::format("<div class=\"certificates\"><b>{}</b>\n<ul>\n{}</ul></div>\n",
                       count == 1 ? "Certificate" : "Certificates", links);
  }
  return fmt::format(
      "<details class=\"certificates\"><summary>{} certificates</summary>\n<ul>\n{}</ul></details>\n", count,
      links);
}

}  // namespace

std::string VerdictChip(Verdict verdict) {
  const VerdictLook look = LookOf(verdict);
  return fmt::format("<span class=\"chip {}\"><span aria-hidden=\"true\">{}</span> {}</span>", look.style,
                     look.sign, ToString(verdict));
}

std::string VerdictStyle(Verdict verdict) { return LookOf(verdict).style; }

std::string ClaimArticle(const LedgerEntry& entry, int heading_level) {
  const Claim& claim = entry.claim;
  const Outcome& outcome = entry.outcome;
  const std::string id = Escape(claim.id);
  std::string html = fmt::format(
      "<article class=\"claim {0}\" id=\"{1}\">\n<header>{2}<a class=\"id\" href=\"#{3}\">{4}</a></header>\n"
      "<h{5} class=\"statement\">{6}</h{5}>\n",
      VerdictStyle(outcome.verdict), id, VerdictChip(outcome.verdict), id, id, heading_level,
      Escape(claim.statement));
  html += "<dl>";
  const auto fact = [&](const char* name, const std::string& value) {
    if (!value.empty()) html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, Escape(value));
  };
  fact("Source", claim.source);
  fact("Method", claim.method);
  fact("Time", ReadableSeconds(entry.seconds));
  fact("Bound", outcome.bound);
  html += "</dl>\n" + Prose(outcome.evidence) + NumbersHtml(outcome);
  for (const Table& table : outcome.tables) html += TableHtml(table);
  if (!outcome.figures.empty()) html += "<div class=\"figures\">\n";
  for (size_t i = 0; i < outcome.figures.size(); ++i) {
    html += FigureHtml(outcome.figures[i], fmt::format("{}--figure-{}", id, i + 1));
  }
  if (!outcome.figures.empty()) html += "</div>\n";
  return html + CertificatesHtml(outcome) + "</article>\n";
}

}  // namespace tact::provers
