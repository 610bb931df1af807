#include <filesystem>

#include "cli/output.h"
#include "cli/plan_answer.h"
#include "provers/report/html.h"
#include "provers/report/text.h"
#include "provers/report/trajectory_drawing.h"

namespace tact::cli {
namespace {

std::string Paragraph(const std::string& text) { return "<p>" + provers::Escape(text) + "</p>\n"; }

std::string Section(const PlanAnswer& answer, const PlanAnswer::Step& step, size_t number) {
  const planning::Trajectory& t = step.planned.trajectory;
  const std::vector<std::string> cells = PlanCells(answer, step);
  std::string html = "<h2>" + provers::Escape(cells[0]) + "</h2>\n" + Paragraph("Case: " + cells[1] + ".");
  if (!step.planned.failure().empty()) html += Paragraph("It fails: " + step.planned.failure() + ".");
  for (const std::string& note : t.notes) html += Paragraph("Note: " + note + ".");
  const provers::Figure figure{
      "The moving solid on its way (dotted) and at its end; contacts there are marked.",
      provers::DrawTrajectory(answer.demonstration.solids, t.samples)};
  return html + "<div class=\"figures\">\n" + FigureHtml(figure, "figure-" + std::to_string(number)) +
         "</div>\n";
}

std::string Body(const PlanAnswer& answer) {
  std::string html = "<h1>Trajectories</h1>\n";
  for (const std::string& note : answer.demonstration.notes) html += Paragraph("Note: " + note + ".");
  provers::Table closed{"In closed form; axes in the fixed model's frame", PlanHeader(answer), {}};
  provers::Table ipopt{
      "By Ipopt: rotation first, then translation; least of all, and by the thesis' definition (A.10), "
      "(A.19)",
      IpoptHeader(answer),
      {}};
  std::string sections;
  for (size_t i = 0; i < answer.steps.size(); ++i) {
    closed.rows.push_back(PlanCells(answer, answer.steps[i]));
    for (size_t k = 0; k < answer.steps[i].ipopt.size(); ++k)
      ipopt.rows.push_back(IpoptCells(answer, answer.steps[i], k));
    sections += Section(answer, answer.steps[i], i + 1);
  }
  html += TableHtml(closed);
  if (!ipopt.rows.empty()) html += TableHtml(ipopt);
  return html + sections;
}

}  // namespace

void WritePlanPage(const PlanAnswer& answer, const std::string& path) {
  WriteFile(path, provers::PageHtml("Trajectories", Body(answer)));
}

}  // namespace tact::cli
