#include "provers/report/dof_transition_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "algebra/contact/relation_solids.h"
#include "provers/report/html.h"
#include "provers/report/relation_drawing.h"
#include "provers/report/scene_article.h"
#include "provers/report/step_matrix.h"
#include "provers/report/text.h"

namespace tact::provers {
namespace {

using algebra::DofIndex;
using algebra::Motion;
using enumerators::AdditionKind;
using enumerators::DirectBlocks;
using enumerators::DofStepList;
using enumerators::FoundStep;
using enumerators::StepDefinition;
using enumerators::TranslationKind;

using Values = std::vector<int>;

// A step's colour by the least that makes it.
constexpr std::array<const char*, enumerators::kAdditionKinds> kColours = {"#2563a8", "#d9822b", "#3f9a5b"};

std::string Grouped(uint64_t value) { return GroupedDigits(static_cast<long long>(value)); }

std::string Head(const DofTransitionFindings& findings) {
  const auto shown =
      std::ranges::count_if(findings.shown, [](const ShownTransition& s) { return s.scene.has_value(); });
  const std::string of_thirty =
      static_cast<size_t>(shown) == findings.shown.size()
          ? "all, in translation and in rotation"
          : fmt::format("{} of {}, those of translation and of rotation counted apart", shown,
                        findings.shown.size());
  return fmt::format(
      "<header class=\"top\">\n<h1>From contact to contact</h1>\n"
      "<p class=\"lead\">The steps between contact relations, and the DOF-transitions that solids show.</p>\n"
      "<p>A motion of a solid past another is maintaining if it keeps every contact and so does its "
      "opposite, "
      "detaching if a contact opens one way, constraining if it is blocked both ways. How many independent "
      "motions there are of each kind changes when something more touches, and changes back when it parts: "
      "read every step below backwards as well. Three questions are answered: which steps there are between "
      "the ten kinds in translation; which between the finer classes, when a contact, an edge or a face is "
      "added; and which of the thirty DOF-transitions real solids show ({}).</p>\n"
      "<p>Steps between classes were tried from {} relations of at most {} contacts, with {} contacts, edges "
      "and faces to add. The world: {}.</p>\n</header>\n",
      of_thirty, Grouped(findings.census.relations()), findings.census.world().largest - 1,
      findings.census.additions().size(), Escape(findings.census.world().sentence));
}

// ---- In translation

std::string KindText(const TranslationKind& kind) {
  return fmt::format("{} {} {}", kind[0], kind[1], kind[2]);
}

// The darker, the more.
std::string CountColour(uint64_t count) {
  size_t digits = 0;
  for (; count > 0; count /= 10) ++digits;
  static constexpr std::array<const char*, 6> kShades = {"#f1efe9", "#e3edf7", "#d0e2f2",
                                                         "#b7d2ea", "#9bbfe0", "#7fadd6"};
  return kShades[std::min(digits, kShades.size() - 1)];
}

// The definition by which there are thirteen steps, if it is the only one.
const StepDefinition* Thirteen(const DofTransitionFindings& findings) {
  const auto is_it = [](const StepDefinition& d) { return d.steps.size() == 13; };
  return std::ranges::count_if(findings.translation, is_it) == 1
             ? &*std::ranges::find_if(findings.translation, is_it)
             : nullptr;
}

std::string TranslationMatrix(const DofTransitionFindings& findings) {
  const enumerators::KindSteps& single = findings.translation.front().steps;
  const StepDefinition* thirteen = Thirteen(findings);
  const std::vector<TranslationKind> kinds = enumerators::TranslationKinds();
  std::vector<std::string> labels;
  std::vector<std::vector<MatrixCell>> cells;
  for (const TranslationKind& from : kinds) {
    labels.push_back(KindText(from));
    std::vector<MatrixCell>& row = cells.emplace_back();
    for (const TranslationKind& to : kinds) {
      MatrixCell& cell = row.emplace_back();
      const bool by_one = single.contains({from, to});
      cell.ring = thirteen != nullptr && thirteen->steps.contains({from, to});
      if (!by_one && !cell.ring) continue;
      const uint64_t count = findings.lists.front().Count({from.begin(), from.end()}, {to.begin(), to.end()});
      cell.fill = by_one ? CountColour(count) : "#ffffff";
      cell.text = by_one ? Grouped(count) : "slot";
      cell.title =
          fmt::format("{} to {}: {}{}", KindText(from), KindText(to),
                      by_one ? Grouped(count) + " steps by one contact" : "by the two walls of a slot",
                      cell.ring ? "; one of the thirteen" : "");
    }
  }
  return DrawMatrix(labels, cells, 62, "Steps between the ten kinds in translation");
}

std::string Translation(const DofTransitionFindings& findings) {
  Table counts{"Ordered pairs of kinds, by what counts as a step", {"pairs", "what counts as a step"}, {}};
  for (const StepDefinition& d : findings.translation) {
    counts.rows.push_back(
        {std::to_string(d.steps.size()), d.name + (&d == Thirteen(findings) ? " \u2013 the thirteen" : "")});
  }
  const StepDefinition* thirteen = Thirteen(findings);
  return "<h2>Between the ten kinds in translation</h2>\n"
         "<p>In translation there are ten kinds of relations, told apart by how many maintaining, detaching "
         "and "
         "constraining DOFs they have. How many steps lead from one to another depends on what a step is." +
         (thirteen == nullptr
              ? ""
              : " Thirteen, the number that the literature names, comes out for one definition: " +
                    Escape(thirteen->name) + ".") +
         "</p>\n" + TableHtml(counts) +
         FigureHtml(
             {"One contact is added: from the kind of the row to the kind of the column (maintaining, "
              "detaching, constraining), with the number of such steps in the world that was searched; "
              "0: the step takes other normals. Framed in purple: the thirteen.",
              TranslationMatrix(findings)},
             "translation-matrix");
}

// ---- Between classes

std::string ClassText(const Values& v) {
  return fmt::format("translation {} {} {}, rotation {} {}+{} {}, all {} {} {}", v[0], v[1], v[2], v[3], v[4],
                     v[5], v[6], v[7], v[8], v[9]);
}

std::string Article(AdditionKind kind) {
  return (kind == AdditionKind::kEdge ? "an " : "a ") + ToString(kind);
}

struct DotCounts {
  std::array<uint64_t, enumerators::kAdditionKinds> steps{};
};

std::string DotMatrix(const DofTransitionFindings& findings) {
  const enumerators::DofDefinition& finest = enumerators::DofDefinitions().back();
  std::vector<Values> classes;
  for (const algebra::MotionDof& dof : enumerators::DofClasses()) classes.push_back(IndexValues(dof, finest));
  std::ranges::sort(classes, std::greater<>());
  std::map<Values, size_t> places;
  std::vector<MatrixGroup> groups;
  for (const Values& v : classes) {
    places.emplace(v, places.size());
    const std::string label = fmt::format("{} {} {}", v[0], v[1], v[2]);
    if (groups.empty() || groups.back().label != label) groups.push_back({label, 0});
    ++groups.back().classes;
  }
  std::map<std::pair<Values, Values>, DotCounts> pairs;
  for (const DofStepList& list : findings.lists) {
    if (list.definition != &finest) continue;
    for (const FoundStep& found : list.found)
      pairs[{found.from, found.to}].steps[static_cast<size_t>(list.kind)] = found.count;
  }
  std::vector<MatrixDot> dots;
  for (const auto& [pair, counts] : pairs) {
    size_t least = counts.steps.size();
    std::string how;
    for (size_t kind = 0; kind < counts.steps.size(); ++kind) {
      if (counts.steps[kind] == 0) continue;
      least = std::min(least, kind);
      how += fmt::format("{} {} by {}", how.empty() ? "" : ",", Grouped(counts.steps[kind]),
                         Article(static_cast<AdditionKind>(kind)));
    }
    dots.push_back({places.at(pair.first), places.at(pair.second), kColours[least],
                    ClassText(pair.first) + " \u2192 " + ClassText(pair.second) + ":" + how});
  }
  return DrawDotMatrix(groups, dots, "Steps between DOF classes");
}

std::string Classes(const DofTransitionFindings& findings) {
  const auto& definitions = enumerators::DofDefinitions();
  Table table{"Ordered pairs of classes that an addition connects, by the indices that tell classes apart",
              {"indices", "contact", "edge", "face", "any of them"},
              {}};
  for (size_t i = 0; i < definitions.size(); ++i) {
    std::vector<std::string> row = {definitions[i].name};
    for (const DofStepList& list : findings.lists) {
      if (list.definition == &definitions[i]) row.push_back(Grouped(list.found.size()));
    }
    row.push_back(Grouped(CountPairs(findings.lists, i)));
    table.rows.push_back(std::move(row));
  }
  return "<h2>Between the DOF classes</h2>\n"
         "<p>Rotation and all motion tell more classes apart. A step adds one contact; or, as solids do, one "
         "contact primitive at once: an edge on a face is two contacts with one normal, a face on a face "
         "three or four.</p>\n" +
         TableHtml(table) +
         FigureHtml({fmt::format("The {} classes of the last line, before (down) and after (across), grouped "
                                 "by translation: a dot "
                                 "for each pair that some step connects - blue if one contact does it, "
                                 "orange if it takes an edge, "
                                 "green if it takes a face. Pointing at a dot tells the classes and counts.",
                                 enumerators::DofClasses().size()),
                     DotMatrix(findings)},
                    "class-matrix");
}

// ---- What one contact cannot do

std::string Vectors(const algebra::ContactRelation& relation) {
  const auto vector = [](const algebra::Vector3& v) {
    return fmt::format("({}, {}, {})", v.x.ToString(), v.y.ToString(), v.z.ToString());
  };
  std::string text;
  for (const algebra::Contact& contact : relation.contacts)
    text += (text.empty() ? "" : "; ") + vector(contact.point) + " \u2192 " + vector(contact.planes[0]);
  return text.empty() ? "nothing" : text;
}

std::string BlockFigures(const DofTransitionFindings& findings, const DirectBlocks& blocks) {
  std::vector<size_t> all = blocks.smallest->relation;
  all.insert(all.end(), blocks.smallest->added.begin(), blocks.smallest->added.end());
  const algebra::ContactRelation before = findings.census.Relation(blocks.smallest->relation),
                                 after = findings.census.Relation(all);
  const std::string id = fmt::format("direct-{}", ToString(blocks.kind));
  const auto dofs = [](const algebra::ContactRelation& relation) {
    const algebra::RotationDof d = ComputeMotionDof(relation).rotation;
    return fmt::format("{} maintaining, {} detaching, {} constraining in rotation", d.maintaining,
                       d.detaching, d.constraining);
  };
  const View view{.width = 340, .height = 280};
  return fmt::format("<h3>The smallest step of that kind, by {}</h3>\n<div class=\"figures\">\n",
                     Article(blocks.kind)) +
         FigureHtml({"Before: " + dofs(before) + ". Point \u2192 normal: " + Vectors(before) + ".",
                     DrawRelationSolids(RealizeRelation(before), view)},
                    id + "-before") +
         FigureHtml({"After: " + dofs(after) +
                         ". Added: " + Vectors(findings.census.Relation(blocks.smallest->added)) + ".",
                     DrawRelationSolids(RealizeRelation(after), view)},
                    id + "-after") +
         "</div>\n";
}

std::string Blocks(const DofTransitionFindings& findings) {
  Table table{"Steps after which a motion has fewer maintaining and more constraining DOFs",
              {"added", "in translation", "in rotation"},
              {}};
  std::string figures;
  for (const DirectBlocks& blocks : findings.direct_blocks) {
    if (blocks.motion == Motion::kTranslation) table.rows.push_back({ToString(blocks.kind)});
    table.rows.back().push_back(Grouped(blocks.steps));
    if (blocks.smallest && figures.empty()) figures = BlockFigures(findings, blocks);
  }
  return "<h2>From maintaining straight to constraining</h2>\n"
         "<p>One contact never takes a motion from maintaining to constraining: either its row is new, and "
         "then "
         "one maintaining DOF becomes detaching, or it is not, and then no maintaining DOF changes. Several "
         "contacts at once can.</p>\n" +
         TableHtml(table) + figures;
}

// ---- The thirty

std::string ShownMatrix(const DofTransitionFindings& findings, Motion motion) {
  std::vector<std::string> labels;
  std::vector<std::vector<MatrixCell>> cells(algebra::kDofIndices,
                                             std::vector<MatrixCell>(algebra::kDofIndices));
  for (int i = 0; i < algebra::kDofIndices; ++i) labels.push_back(Symbol(static_cast<DofIndex>(i)));
  for (const ShownTransition& shown : findings.shown) {
    const algebra::DofTransition& t = shown.transition;
    if (t.motion != motion || !shown.scene) continue;
    MatrixCell& cell = cells[static_cast<size_t>(t.from)][static_cast<size_t>(t.to)];
    cell.fill = IsPractical(t) ? "#cfe6d4" : "#f6d9c9";
    cell.text = shown.backwards ? "\u2190" : "\u2192";
    if (!shown.forced) cell.text += "*";
    const ShownScene& scene = findings.scenes[*shown.scene];
    cell.title = fmt::format("{} to {}: {}{}", Symbol(t.from), Symbol(t.to), scene.given.story,
                             shown.backwards ? " Backwards." : "");
    cell.link = "#" + SceneId(scene);
  }
  return DrawMatrix(labels, cells, 40, "DOF-transitions in " + ToString(motion));
}

std::string Thirty(const DofTransitionFindings& findings) {
  std::string html =
      "<h2>The thirty DOF-transitions</h2>\n"
      "<p>With the singular twins of the three kinds (of relations where some contact leaves a choice of "
      "planes) there are thirty ways for a DOF to change. Each is shown by two solids and an exact motion, a "
      "line or a turn about a fixed axis, along which the same elements touch until the last moment. The "
      "motions run forwards (\u2192) or backwards (\u2190). M, D, C stand for maintaining, detaching and "
      "constraining, S for singular; three numbers are such DOFs in this order.</p>\n"
      "<p>In the drawings the moving solid is solid, and dotted where it stands at the other end of its "
      "motion. "
      "Blue dots are contacts with one separate plane, magenta diamonds singular ones, hollow marks lie "
      "behind; "
      "arrows point to the legal side.</p>\n<div class=\"figures\">\n";
  for (const Motion motion : {Motion::kTranslation, Motion::kRotation}) {
    html += FigureHtml({"In " + ToString(motion) +
                            ", from the row's index to the column's. Green: practical by Fig. 2.5 of the "
                            "thesis; red: not. *: shown by a direction of motion; the counts of DOFs do not "
                            "force it.",
                        ShownMatrix(findings, motion)},
                       "shown-" + ToString(motion));
  }
  html += "</div>\n";
  for (const ShownScene& scene : findings.scenes) html += SceneArticle(scene);
  return html;
}

}  // namespace

std::string DofTransitionPage(const DofTransitionFindings& findings) {
  return PageHtml("tact: from contact to contact", Head(findings) + "<main>\n" + Translation(findings) +
                                                       Classes(findings) + Blocks(findings) +
                                                       Thirty(findings) + "</main>\n");
}

}  // namespace tact::provers
