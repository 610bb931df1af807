#include "robot/input/knot_examples.h"

#include <algorithm>

namespace tact::input {

std::optional<KnotExample> FindKnotExample(std::string_view name) {
  const auto& all = KnotExamples();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const KnotExample& example) { return example.name == name; });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

std::string KnotExampleNames() {
  std::string names;
  for (const KnotExample& example : KnotExamples()) names += (names.empty() ? "" : ", ") + example.name;
  return names;
}

}  // namespace tact::input
