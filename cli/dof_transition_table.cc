#include <fmt/format.h>

#include <array>

#include "cli/dof_transition_text.h"
#include "cli/text_pieces.h"

namespace tact::cli {
namespace {

using algebra::DofIndex;
using algebra::DofTransition;
using algebra::Motion;
using enumerators::DofStepList;
using enumerators::ShownScene;
using enumerators::ShownTransition;
using enumerators::StepDefinition;
using enumerators::Symbol;
using enumerators::TranslationKind;
using provers::DofTransitionFindings;

std::string KindText(const TranslationKind& kind) {
  return fmt::format("{} {} {}", kind[0], kind[1], kind[2]);
}

std::string TranslationTable(const DofTransitionFindings& findings) {
  std::string table =
      "Steps between the ten kinds of contact relations in translation\n  pairs  what counts as a step\n";
  for (const StepDefinition& definition : findings.translation)
    table += fmt::format("{:>7}  {}\n", definition.steps.size(), definition.name);
  return table;
}

std::string TranslationMatrix(const DofTransitionFindings& findings) {
  const enumerators::KindSteps& possible = findings.translation.front().steps;
  const DofStepList& contacts = findings.lists.front();
  const std::vector<TranslationKind> kinds = enumerators::TranslationKinds();
  std::string table =
      "One contact is added: from the kind on the left (maintaining, detaching, constraining) to the kind "
      "above\n     ";
  for (const TranslationKind& to : kinds) table += fmt::format("{:>9}", KindText(to));
  for (const TranslationKind& from : kinds) {
    table += "\n" + KindText(from);
    for (const TranslationKind& to : kinds) {
      const uint64_t count = contacts.Count({from.begin(), from.end()}, {to.begin(), to.end()});
      table += fmt::format("{:>9}", count > 0                       ? std::to_string(count)
                                    : possible.contains({from, to}) ? "0"
                                                                    : ".");
    }
  }
  return table + "\n(steps in this world; 0: other normals make the step; dot: none do)\n";
}

std::string ClassTable(const DofTransitionFindings& findings) {
  const auto& definitions = enumerators::DofDefinitions();
  std::string table = fmt::format(
      "Ordered pairs of DOF classes that a contact, an edge (two contacts with one normal) or a face (three "
      "or four) connects\n"
      "{:>7}  {:>7}  {:>7}  {:>7}  {}\n",
      "contact", "edge", "face", "any", "indices that tell two relations apart");
  for (size_t i = 0; i < definitions.size(); ++i) {
    for (const DofStepList& list : findings.lists) {
      if (list.definition == &definitions[i]) table += fmt::format("{:>7}  ", list.found.size());
    }
    table += fmt::format("{:>7}  {}\n", CountPairs(findings.lists, i), definitions[i].name);
  }
  const enumerators::ContactWorld& world = findings.census.world();
  return table + fmt::format(
                     "Found from {} relations of at most {} contacts and every contact, edge and face more, "
                     "in this world:\n{}.\nMore contacts may connect more pairs.\n",
                     findings.census.relations(), world.largest - 1, world.sentence);
}

std::string BlockTable(const DofTransitionFindings& findings) {
  std::string table =
      "Steps after which a motion has fewer maintaining and more constraining DOFs\n"
      "         translation    rotation\n";
  for (const enumerators::DirectBlocks& blocks : findings.direct_blocks) {
    const bool first = blocks.motion == Motion::kTranslation;
    table += first ? fmt::format("{:<8}{:>12}", enumerators::ToString(blocks.kind), blocks.steps)
                   : fmt::format("{:>12}\n", blocks.steps);
  }
  return table;
}

std::string ShownCell(const ShownTransition& shown) {
  const std::string mark = !shown.scene ? "." : shown.forced ? "f" : "d";
  return IsPractical(shown.transition) ? mark : "(" + mark + ")";
}

std::string ShownMatrices(const DofTransitionFindings& findings) {
  std::string rows[1 + algebra::kDofIndices];
  for (const Motion motion : {Motion::kTranslation, Motion::kRotation}) {
    for (std::string& row : rows) row.resize(motion == Motion::kTranslation ? 0 : 48, ' ');
    rows[0] += fmt::format("{:<11}", ToString(motion));
    for (int i = 0; i < algebra::kDofIndices; ++i) {
      const std::string name = Symbol(static_cast<DofIndex>(i));
      rows[0] += fmt::format("{:^5}", name);
      rows[1 + i] += fmt::format("{:>10} ", name);
      for (int j = 0; j < algebra::kDofIndices; ++j) {
        std::string cell;
        for (const ShownTransition& shown : findings.shown) {
          const DofTransition& t = shown.transition;
          if (t == DofTransition{motion, static_cast<DofIndex>(i), static_cast<DofIndex>(j)})
            cell = ShownCell(shown);
        }
        rows[1 + i] += fmt::format("{:^5}", cell);
      }
    }
  }
  std::string table =
      "DOF-transitions that solids show, from the left to above: M, D, C maintaining, detaching, "
      "constraining, S singular\n";
  for (std::string& row : rows) table += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
  return table +
         "(f: the counts of DOFs force it; d: a direction of motion goes so; in brackets: not practical by "
         "Fig. 2.5)\n";
}

std::string Stories(const DofTransitionFindings& findings) {
  std::string list = "The motions, each shown forwards and backwards\n";
  for (const ShownScene& scene : findings.scenes) {
    list += fmt::format("{:>4} - {:<2}  {}\n", Symbol(scene.given.before), Symbol(scene.given.after),
                        scene.given.story);
  }
  return list;
}

}  // namespace

std::string ToTable(const DofTransitionFindings& findings) {
  return Join(std::array{TranslationTable(findings), TranslationMatrix(findings), ClassTable(findings),
                         BlockTable(findings), ShownMatrices(findings), Stories(findings)},
              "\n", [](const std::string& part) { return part; }) +
         "\nRemoving contacts is adding them read backwards.\n";
}

}  // namespace tact::cli
