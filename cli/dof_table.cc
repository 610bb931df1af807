#include "cli/dof_table.h"

#include <array>
#include <cstdio>
#include <tuple>

namespace tact::cli {
namespace {

template <typename... Values>
std::string Format(const char* format, Values... values) {
  std::array<char, 256> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

}  // namespace

std::string DofTable(const algebra::MotionDof& dof) {
  const auto row = [](const char* motion, int maintaining, int detaching, const std::string& type1,
                      const std::string& type2, int constraining, int restricted) {
    return Format("%-12s%12d%11d%9s%9s%14d%12d\n", motion, maintaining, detaching, type1.c_str(),
                  type2.c_str(), constraining, restricted);
  };
  const auto& [t, r, a] = std::tie(dof.translation, dof.rotation, dof.all);
  std::string table = Format("%-12s%12s%11s%9s%9s%14s%12s\n", "", "maintaining", "detaching", "type I",
                             "type II", "constraining", "restricted");
  table += row("translation", t.maintaining, t.detaching, "-", "-", t.constraining, t.restricted);
  table += row("rotation", r.maintaining, r.detaching, std::to_string(r.detaching_type1),
               std::to_string(r.detaching_type2), r.constraining, r.restricted);
  table += row("all motion", a.maintaining, a.detaching, "-", "-", a.constraining, a.restricted);
  if (dof.singular) {
    table +=
        "The relation is singular: maintaining, detaching and constraining are the singular DOFs, of its "
        "contacts with one plane;\nrestricted counts every plane of every contact.\n";
  }
  return table;
}

}  // namespace tact::cli
