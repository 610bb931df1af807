#include <array>
#include <cstdio>

#include "algebra/contact/motion_dof.h"
#include "cli/commands.h"
#include "cli/each_relation.h"

namespace tact::cli {
namespace {

using algebra::MotionDof;

template <typename... Values>
std::string Format(const char* format, Values... values) {
  std::array<char, 512> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string ToJson(const algebra::TranslationDof& dof) {
  return Format(R"({"maintaining":%d,"detaching":%d,"constraining":%d,"restricted":%d})", dof.maintaining,
                dof.detaching, dof.constraining, dof.restricted);
}

std::string ToJson(const algebra::RotationDof& dof) {
  return Format(R"({"maintaining":%d,"detaching":%d,"detaching_type1":%d,"detaching_type2":%d,)"
                R"("constraining":%d,"restricted":%d})",
                dof.maintaining, dof.detaching, dof.detaching_type1, dof.detaching_type2, dof.constraining,
                dof.restricted);
}

std::string ToJson(const MotionDof& dof) {
  return std::string(R"({"singular":)") + (dof.singular ? "true" : "false") + R"(,"translation":)" +
         ToJson(dof.translation) + R"(,"rotation":)" + ToJson(dof.rotation) + R"(,"all":)" + ToJson(dof.all) +
         "}\n";
}

std::string ToTable(const MotionDof& dof) {
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

}  // namespace

ExitStatus RunDof(const FileOptions& options) {
  AnswerEachRelation(options, [&](const algebra::ContactRelation& relation) {
    const MotionDof dof = ComputeMotionDof(relation);
    return options.json ? ToJson(dof) : ToTable(dof);
  });
  return kAnswered;
}

}  // namespace tact::cli
