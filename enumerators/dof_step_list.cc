#include "enumerators/dof_step_list.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tact::enumerators {
namespace {

DofStepList ListOf(const DofSteps& steps, AdditionKind kind, const DofDefinition& definition) {
  std::vector<std::vector<int>> values;
  for (const algebra::MotionDof& dof : DofClasses()) values.push_back(IndexValues(dof, definition));
  DofStepList list{kind, &definition, {}, 0};
  std::map<std::pair<std::vector<int>, std::vector<int>>, FoundStep> pairs;
  for (const DofStep& step : steps) {
    if (step.kind != kind) continue;
    const std::vector<int>&from = values[step.before], &to = values[step.after];
    if (from == to) {
      list.within += step.count;
      continue;
    }
    FoundStep& found = pairs.try_emplace({from, to}, FoundStep{from, to, 0, step.witness}).first->second;
    found.count += step.count;
    if (ComesBefore(step.witness, found.witness)) found.witness = step.witness;
  }
  for (auto& [pair, found] : pairs) list.found.push_back(std::move(found));
  return list;
}

}  // namespace

uint64_t DofStepList::steps() const {
  uint64_t steps = within;
  for (const FoundStep& step : found) steps += step.count;
  return steps;
}

uint64_t DofStepList::Count(const std::vector<int>& from, const std::vector<int>& to) const {
  const auto at =
      std::ranges::find_if(found, [&](const FoundStep& s) { return s.from == from && s.to == to; });
  return at == found.end() ? 0 : at->count;
}

std::vector<DofStepList> ListDofSteps(const DofSteps& steps) {
  std::vector<DofStepList> lists;
  for (size_t kind = 0; kind < kAdditionKinds; ++kind) {
    for (const DofDefinition& definition : DofDefinitions())
      lists.push_back(ListOf(steps, static_cast<AdditionKind>(kind), definition));
  }
  return lists;
}

std::vector<DirectBlocks> CountDirectBlocks(const DofSteps& steps) {
  const std::vector<algebra::MotionDof> classes = DofClasses();
  std::vector<DirectBlocks> blocks;
  for (size_t kind = 0; kind < kAdditionKinds; ++kind) {
    for (const algebra::Motion motion : {algebra::Motion::kTranslation, algebra::Motion::kRotation}) {
      blocks.push_back({static_cast<AdditionKind>(kind), motion, 0, std::nullopt});
      DirectBlocks& block = blocks.back();
      for (const DofStep& step : steps) {
        const auto before = Indices(classes[step.before], motion),
                   after = Indices(classes[step.after], motion);
        constexpr auto kM = static_cast<size_t>(algebra::DofIndex::kMaintaining);
        constexpr auto kC = static_cast<size_t>(algebra::DofIndex::kConstraining);
        if (step.kind != block.kind || before[kM] <= after[kM] || before[kC] >= after[kC]) continue;
        block.steps += step.count;
        if (!block.smallest || ComesBefore(step.witness, *block.smallest)) block.smallest = step.witness;
      }
    }
  }
  return blocks;
}

size_t CountPairs(const std::vector<DofStepList>& lists, size_t definition) {
  std::set<std::pair<std::vector<int>, std::vector<int>>> pairs;
  for (const DofStepList& list : lists) {
    if (list.definition != &DofDefinitions().at(definition)) continue;
    for (const FoundStep& found : list.found) pairs.insert({found.from, found.to});
  }
  return pairs.size();
}

}  // namespace tact::enumerators
