#include "cli/dof_table.h"

#include <fmt/format.h>

namespace tact::cli {
namespace {

// Types of detaching exist in rotation only.
std::string Row(const char* motion, int maintaining, int detaching, const std::string& type1,
                const std::string& type2, int constraining, int restricted) {
  return fmt::format("{:<12}{:>12}{:>11}{:>9}{:>9}{:>14}{:>12}\n", motion, maintaining, detaching, type1,
                     type2, constraining, restricted);
}

std::string PlainRow(const char* motion, const algebra::TranslationDof& dof) {
  return Row(motion, dof.maintaining, dof.detaching, "-", "-", dof.constraining, dof.restricted);
}

}  // namespace

std::string DofTable(const algebra::MotionDof& dof) {
  const algebra::RotationDof& r = dof.rotation;
  std::string table = fmt::format("{:<12}{:>12}{:>11}{:>9}{:>9}{:>14}{:>12}\n", "", "maintaining",
                                  "detaching", "type I", "type II", "constraining", "restricted");
  table += PlainRow("translation", dof.translation);
  table += Row("rotation", r.maintaining, r.detaching, std::to_string(r.detaching_type1),
               std::to_string(r.detaching_type2), r.constraining, r.restricted);
  table += PlainRow("all motion", dof.all);
  if (dof.singular) {
    table +=
        "The relation is singular: maintaining, detaching and constraining are the singular DOFs, of its "
        "contacts with one "
        "plane;\nrestricted counts every plane of every contact.\n";
  }
  return table;
}

}  // namespace tact::cli
