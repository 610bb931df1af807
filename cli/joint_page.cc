#include "cli/joint_page.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <numbers>

#include "cli/joint_text.h"
#include "cli/output.h"
#include "provers/report/html.h"
#include "provers/report/joint_drawing.h"
#include "provers/report/plot.h"
#include "provers/report/text.h"

namespace tact::cli {
namespace {

using provers::Plot;
using provers::PlotMark;
using provers::PlotSeries;

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr size_t kMostPoints = 4000;  // of a plot
constexpr std::array<const char*, 3> kColours = {"#1d4ed8", "#15803d", "#c2410c"};

std::string Paragraph(const std::string& text) { return "<p>" + provers::Escape(text) + "</p>\n"; }

std::string PlusMinus(std::string text) {
  if (text.starts_with("+-")) text.replace(0, 2, "\u00B1");
  return text;
}

std::string Capital(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

// Plots over time, or over the number of the pose.
class Plots {
 public:
  Plots(const JointAnswer& answer, cad::LengthUnit unit)
      : answer_(answer), unit_(unit), scale_(ToDouble(Ratio(cad::LengthUnit::kMetre, unit))) {
    const auto& times = answer.series.times;
    for (size_t i = 0; i < answer.series.poses.size(); ++i)
      at_.push_back(times.empty() ? static_cast<double>(i + 1) : times[i] - times[0]);
  }

  std::string Coordinate(size_t k) const {
    const CoordinateName name = CoordinateNames(*answer_.type)[k];
    const double scale = name.angle ? kDegrees : scale_;
    Plot plot = Empty(std::string(name.name), name.angle ? "deg" : std::string(ToString(unit_)));
    plot.series = {Filled({"", kColours[0], PlotMark::kDots, {}}, [&](size_t i) {
      return scale * answer_.fit.fit.coordinates[i][static_cast<Eigen::Index>(k)];
    })};
    return DrawPlot(plot);
  }

  // Of orientation or of location, the components in B.
  std::string Residual(bool rotation) const {
    const cad::LengthUnit small = SmallUnit(unit_);
    const double scale = rotation ? kDegrees : ToDouble(Ratio(cad::LengthUnit::kMetre, small));
    const joint::NoiseScale& noise = answer_.fit.fit.noise;
    const double band = 2 * scale * (rotation ? noise.rotation : noise.translation);
    Plot plot = Empty(rotation ? "orientation off the joint" : "location off the joint",
                      rotation ? "deg" : std::string(ToString(small)));
    plot.bands = {{-band, band}};
    for (int axis = 0; axis < 3; ++axis) {
      const auto value = [&](size_t i) {
        const joint::Residual& residual = answer_.residuals[i];
        return scale * (rotation ? residual.rotation : residual.translation)[axis];
      };
      plot.series.push_back(
          Filled({std::string(1, "xyz"[axis]), kColours[axis], PlotMark::kDots, {}}, value));
    }
    return DrawPlot(plot);
  }

 private:
  Plot Empty(const std::string& what, const std::string& unit) const {
    Plot plot;
    plot.title = what;
    plot.y_label = what + " [" + unit + "]";
    plot.x_label = answer_.series.times.empty() ? "number of the pose" : "time [s]";
    return plot;
  }

  // The poses that count; those that do not are left out: they would hide the others by their size.
  template <typename Value>
  PlotSeries Filled(PlotSeries series, const Value& value) const {
    const auto& outliers = answer_.fit.outliers;
    const size_t step = at_.size() / kMostPoints + 1;
    for (size_t i = 0; i < at_.size(); i += step) {
      if (!std::binary_search(outliers.begin(), outliers.end(), i))
        series.points.emplace_back(at_[i], value(i));
    }
    return series;
  }

  const JointAnswer& answer_;
  cad::LengthUnit unit_;
  double scale_;
  std::vector<double> at_;
};

// What is red in the drawings.
std::string DrawnJoint(joint::JointType type) {
  using joint::JointType;
  const std::string sure = " with two standard deviations to either side";
  if (type == JointType::kRigid) return "";
  if (type == JointType::kSpherical) return "; the centre (red)" + sure;
  if (type == JointType::kPlanar) return "; the plane's normal (red)" + sure;
  if (type == JointType::kTwoAxis)
    return "; the first axis (red)" + sure + ", the second (violet) where A carries it halfway";
  return "; the axis (red)" + sure;
}

std::string Figures(const JointAnswer& answer, cad::LengthUnit unit) {
  const provers::JointPicture picture{answer.fit.fit, answer.parameters, answer.series.poses,
                                      answer.fit.outliers};
  int number = 0;
  const auto figure = [&number](const std::string& caption, const std::string& svg) {
    return provers::FigureHtml({caption, svg}, "figure-" + std::to_string(++number));
  };
  const auto row = [](const std::string& figures) {
    return "<div class=\"figures\">\n" + figures + "</div>\n";
  };
  const bool axis = *answer.type != joint::JointType::kRigid && *answer.type != joint::JointType::kSpherical;
  const std::string side = figure(
      "The poses of A in B: its origin as observed (grey, wrong ones orange) and as the joint has it "
      "(black), some of its frames" +
          DrawnJoint(*answer.type) + ".",
      DrawJoint(picture, provers::JointView::kFromTheSide));
  std::string html = row(side + figure(axis ? "The same along the axis." : "The same against B's z.",
                                       DrawJoint(picture, provers::JointView::kAlongTheAxis)));
  html += "<h2>Over time</h2>\n";
  const Plots plots(answer, unit);
  for (size_t k = 0; k < CoordinateNames(*answer.type).size(); ++k) {
    html += row(figure(k == 0 ? "How far the joint has moved since the first pose." : "One more coordinate.",
                       plots.Coordinate(k)));
  }
  html += row(figure(
      "What the orientation lies off the joint's, as a rotation vector in B; shaded: two standard deviations "
      "of the noise. Waves that stay tell of a joint of another type or of a tracker that bends what it "
      "sees.",
      plots.Residual(true)));
  return html + row(figure("What A's origin lies off the joint's, in B.", plots.Residual(false)));
}

std::string Body(const JointAnswer& answer, cad::LengthUnit unit) {
  std::string html = "<h1>" + provers::Escape(Capital(JointTitle(answer))) + "</h1>\n<p class=\"lead\">" +
                     provers::Escape(Capital(answer.reason)) + ".</p>\n";
  for (const std::string& log : answer.read) html += "<p class=\"small\">" + provers::Escape(log) + "</p>\n";
  for (const std::string& note : answer.notes) html += Paragraph("Note: " + note + ".");
  if (answer.type) {
    provers::Table table;
    table.caption = "Parameters; errors are root mean squares of the error's length";
    table.header = {"Parameter", "Frame", "Value", "Error"};
    for (const JointRow& row : ParameterRows(answer, unit))
      table.rows.push_back({row.name, row.frame, row.value, PlusMinus(row.error)});
    html += TableHtml(table);
    for (const std::string& range : CoordinateRanges(answer, unit))
      html += Paragraph("Moved through: " + range + ".");
    html += Paragraph("Noise: " + NoiseText(answer, unit) + ".");
    if (!answer.fit.outliers.empty())
      html += Paragraph("Wrong poses set aside: " + OutlierLines(answer) + ".");
    if (answer.held_back) html += Paragraph("Poses held back: " + HeldBackText(answer, unit) + ".");
    html += Figures(answer, unit);
  }
  if (answer.scores.empty()) return html;
  provers::Table scores;
  scores.caption = "Types of joint: the lower the BIC the better";
  scores.header = {"Type", "Parameters", "BIC", "Above the best", ""};
  scores.rows = ScoreRows(answer);
  return html + "<h2>How the type was decided</h2>\n" + TableHtml(scores);
}

}  // namespace

void WriteJointPage(const JointAnswer& answer, cad::LengthUnit unit, const std::string& path) {
  WriteFile(path, provers::PageHtml(JointTitle(answer), Body(answer, unit)));
}

}  // namespace tact::cli
