#include <fmt/format.h>

#include <fstream>

#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/json_text.h"
#include "cli/output.h"
#include "cli/text_pieces.h"
#include "provers/report/part_drawing.h"
#include "robot/perception/part_joint.h"
#include "robot/perception/point_file.h"

namespace tact::cli {
namespace {

using perception::Division;
using perception::Part;
using perception::PartAxis;
using perception::Vector3d;
using Scans = std::vector<std::vector<Vector3d>>;

constexpr double kDegree = 180 / M_PI;

std::string ToJson(const Vector3d& v) { return fmt::format("[{:.9g},{:.9g},{:.9g}]", v.x(), v.y(), v.z()); }

std::string ToJson(const joint::Transform& X) {
  const Eigen::Quaterniond q(X.R);
  return fmt::format(R"({{"t":{},"q":[{:.9g},{:.9g},{:.9g},{:.9g}]}})", ToJson(X.p), q.w(), q.x(), q.y(),
                     q.z());
}

std::string ToJsonLine(const PartsOptions& options, const Division& division, const PartAxis& axis) {
  std::string text = fmt::format(
      R"({{"type":"revolute","axis":{{"point":{},"direction":{}}},"errors":{{"direction":{:.3g},"point":{:.3g}}},"scans":[)",
      ToJson(axis.point), ToJson(axis.direction), axis.direction_error, axis.point_error);
  for (std::size_t i = 0; i < division.scans.size(); ++i) {
    const perception::DividedScan& scan = division.scans[i];
    std::string parts;
    for (const Part part : scan.parts) parts += "12?"[static_cast<std::size_t>(part)];
    text += fmt::format(R"({}{{"file":{},"angle":{:.9g},"motions":[{},{}],"parts":"{}"}})", i == 0 ? "" : ",",
                        JsonString(options.scans[i]), axis.angles[i], ToJson(scan.X_S0[0]),
                        ToJson(scan.X_S0[1]), parts);
  }
  return text + "]}\n";
}

constexpr const char* kRow = "{:>4} {:>8} {:>8} {:>8} {:>10} {:>9}  {}\n";

std::string ToTable(const PartsOptions& options, const Division& division, const PartAxis& axis) {
  const auto vector = [](const Vector3d& v) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z());
  };
  std::string text = fmt::format(
      "two parts that turn about an axis, in the frame of scan 1, lengths in the scans' unit\n"
      "axis      through {} along {}\n"
      "errors    {:.2g} across at that point, {:.2g} degrees in direction (standard deviations)\n\n",
      vector(axis.point), vector(axis.direction), axis.point_error, kDegree * axis.direction_error);
  text += fmt::format(kRow, "scan", "points", "part 1", "part 2", "undecided", "turned", "file");
  for (std::size_t i = 0; i < division.scans.size(); ++i) {
    const std::vector<Part>& parts = division.scans[i].parts;
    text += fmt::format(kRow, i + 1, parts.size(), CountOf(Part::kFirst, parts),
                        CountOf(Part::kSecond, parts), CountOf(Part::kUndecided, parts),
                        fmt::format("{:.2f} deg", kDegree * axis.angles[i]), options.scans[i]);
  }
  return text;
}

}  // namespace

ExitStatus RunParts(const PartsOptions& options) {
  if (options.scans.size() < 2)
    throw InputError("expected two scans or more, of the object in different states, got " +
                     std::to_string(options.scans.size()));
  Scans scans;
  for (const std::string& path : options.scans) scans.push_back(perception::ReadPointFile(path));
  const Division division = perception::DivideTwoParts(scans);
  Output output;
  if (!division.cannot_tell.empty()) {
    output << (options.json ? R"({"type":"undetermined","why":)" + JsonString(division.cannot_tell) + "}\n"
                            : "cannot tell: " + division.cannot_tell + "\n");
    output.Flush();
    return kUndecided;
  }
  const PartAxis axis = perception::AxisOf(division, scans[0]);
  if (!options.svg.empty())
    WriteFile(options.svg, provers::DrawParts(scans[0], division.scans[0].parts, &axis) + "\n");
  output << (options.json ? ToJsonLine(options, division, axis) : ToTable(options, division, axis));
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
