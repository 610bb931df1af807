#include "enumerators/dof_counts_text.h"

#include "enumerators/dof_class.h"
#include "enumerators/unit_text.h"

namespace tact::enumerators {
namespace {

using algebra::MotionDof;

// The indices that follow from the ten.
MotionDof FromValues(const std::vector<int>& v) {
  MotionDof dof;
  dof.translation = {v[0], v[1], v[2], 3 - v[0]};
  dof.rotation = {v[3], v[4] + v[5], v[4], v[5], v[6], 3 - v[3]};
  dof.all = {v[7], v[8], v[9], 6 - v[7]};
  return dof;
}

}  // namespace

std::string ToText(const DofCounts& counts) {
  std::string text = "[";
  for (const DofCount& c : counts) {
    text += text.size() > 1 ? ",\n" : "\n";
    text += "{\"values\":" + ListText(IndexValues(c.dof, DofDefinitions().back())) +
            ",\"count\":" + std::to_string(c.count) + ",\"witness\":" + ListText(c.witness) + "}";
  }
  return text + "]";
}

DofCounts ParseDofCounts(std::string_view text) {
  TextReader reader(text);
  DofCounts counts;
  reader.Expect("[");
  while (!reader.Take("]")) {
    reader.Expect(counts.empty() ? "\n{\"values\":" : ",\n{\"values\":");
    DofCount count;
    const std::vector<int> values = reader.Numbers<int>();
    if (values.size() != DofDefinitions().back().indices.size()) reader.Refuse("ten DOF indices");
    count.dof = FromValues(values);
    reader.Expect(",\"count\":");
    count.count = reader.Number<uint64_t>();
    reader.Expect(",\"witness\":");
    count.witness = reader.Numbers<size_t>();
    reader.Expect("}");
    if (!counts.empty() && !(counts.back().dof < count.dof)) reader.Refuse("classes by increasing DOFs");
    counts.push_back(std::move(count));
  }
  reader.ExpectEnd();
  return counts;
}

std::string DescribeCensus(const DofCensus& census, const std::string& world, const std::string& version) {
  return DescribeRun("dof-classes", version, world, census.world(), census.relations(), DofCensus::kUnitSize);
}

}  // namespace tact::enumerators
