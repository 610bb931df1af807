#include <cmath>
#include <fstream>

#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/dof_table.h"
#include "cli/json_text.h"
#include "cli/output.h"
#include "provers/report/solid_drawing.h"
#include "robot/recognition/posed_models.h"

namespace tact::cli {
namespace {

std::string ToList(const algebra::FoundContacts& found, const std::string& unit) {
  if (found.primitives.empty()) return "nothing touches\n";
  std::string text = std::to_string(found.primitives.size()) + " contact primitive" +
                     (found.primitives.size() == 1 ? "" : "s") +
                     ", moving on fixed; points in the fixed model's frame, " + unit +
                     "; normals to the legal side\n";
  for (const algebra::ContactPrimitive& primitive : found.primitives) {
    text += KindOf(primitive) + "  " + ToString(primitive.moving) + " on " + ToString(primitive.fixed) + "\n";
    for (const size_t i : primitive.contacts) {
      const algebra::Contact& contact = found.relation.contacts[i];
      text += "    at " + ToString(contact.point) + "  normal ";
      for (size_t j = 0; j < contact.planes.size(); ++j)
        text += (j == 0 ? "" : " or ") + ToString(contact.planes[j]);
      text += contact.singular() ? "  (singular)\n" : "\n";
    }
  }
  return text + "\n" + DofTable(ComputeMotionDof(found.relation));
}

void Draw(const recognition::ModelPair& models, const algebra::Pose& X_FM,
          const algebra::ContactRelation& relation, const std::string& path) {
  const std::vector<provers::DrawnSolid> solids = {{models.fixed, provers::Part::kFixed},
                                                   {Transform(models.moving, X_FM), provers::Part::kMoving}};
  WriteFile(path, provers::DrawContactRelation(solids, relation) + "\n");
}

}  // namespace

ExitStatus RunContacts(const ContactsOptions& options) {
  const auto unit = cad::ParseLengthUnit(options.unit);
  if (!unit) {
    throw InputError("--unit: expected mm, cm, m or in, the unit of both models and of the pose, got " +
                     (options.unit.empty() ? std::string("none; a mesh has no unit") : options.unit));
  }
  const auto tolerance = algebra::Rational::Parse(options.tolerance);
  if (!tolerance || tolerance->sign() < 0 || !std::isfinite(ToDouble(*tolerance))) {
    throw InputError(
        "--tolerance: expected a number of millimetres, not negative and in the range of a double, got " +
        options.tolerance);
  }
  const input::PoseInput pose = input::ParsePoseArgument(options.pose, "--pose");
  input::CadModels models{options.moving, options.fixed, *unit, *tolerance / cad::InMillimetres(*unit)};
  const recognition::ModelPair pair = recognition::LoadModels(models);
  for (const std::string& note : pair.notes) Note(note);
  if (!pose.exact) Note("--pose: the rotation was rounded to a rational one, so contacts need a tolerance");
  const algebra::FoundContacts found = recognition::ContactsInPose(pair, pose.pose, "--pose");
  if (!options.svg.empty()) Draw(pair, pose.pose, found.relation, options.svg);
  Output output;
  output << (options.json ? R"({"contacts":)" + ContactsToJson(found.relation) + "}\n"
                          : ToList(found, options.unit));
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
