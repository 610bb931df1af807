#include "provers/report/scene_article.h"

#include <fmt/format.h>

#include <algorithm>

#include "provers/report/html.h"
#include "provers/report/solid_drawing.h"
#include "provers/report/text.h"

namespace tact::provers {
namespace {

using algebra::DofIndex;
using algebra::DofTransition;
using algebra::Motion;

std::string Words(DofIndex index) {
  std::string words = ToString(index);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string Capital(std::string words) {
  words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

std::string Dofs(const algebra::MotionDof& dof) {
  const auto three = [](const auto& d) {
    return fmt::format("{}\u00A0{}\u00A0{}", d.maintaining, d.detaching, d.constraining);
  };
  return fmt::format("{}: translation {}, rotation {}.", dof.singular ? "singular" : "not singular",
                     three(dof.translation), three(dof.rotation));
}

std::string VectorText(const algebra::Vector3& v) {
  return fmt::format("({}, {}, {})", v.x.ToString(), v.y.ToString(), v.z.ToString());
}

std::string PathText(const algebra::MotionPath& path) {
  return path.kind == algebra::MotionPath::Kind::kLine
             ? "straight, by " + VectorText(path.vector)
             : fmt::format("a turn by the quaternion (1, s {}) about the axis through {}, s from 0 to 1",
                           VectorText(path.vector), VectorText(path.center));
}

// "in translation and in rotation"
std::string Motions(const std::vector<DofTransition>& list, const ShownScene& scene) {
  std::string text;
  for (const Motion motion : {Motion::kTranslation, Motion::kRotation}) {
    if (std::ranges::find(list, DofTransition{motion, scene.given.before, scene.given.after}) != list.end())
      text += (text.empty() ? "in " : " and in ") + ToString(motion);
  }
  return text.empty() ? "no" : text;
}

std::string Pairs(const std::vector<DofTransition>& list, Motion motion) {
  std::string text;
  for (const DofTransition& t : list) {
    if (t.motion == motion) text += (text.empty() ? "" : ", ") + Symbol(t.from) + " \u2192 " + Symbol(t.to);
  }
  return text.empty() ? "none" : text;
}

// Into a hole one looks over its low walls.
View ViewOf(const ShownScene& scene) {
  View view;
  view.width = 340;
  view.height = 320;
  const bool hole =
      scene.given.before == DofIndex::kConstraining && scene.given.after != DofIndex::kSingularMaintaining;
  if (hole) view.toward_viewer = {-0.75, -1, 0.8};
  return view;
}

// The moving solid at s, and its outline at the other end of the path.
std::string Draw(const ShownScene& scene, int s, const algebra::ContactRelation& relation) {
  const algebra::Scene& solids = scene.given.scene;
  const algebra::Polyhedron moving = algebra::UnionOfHulls(solids.moving_pieces);
  return DrawContactRelation({{algebra::UnionOfHulls(solids.fixed_pieces), Part::kFixed},
                              {Transform(moving, solids.path.At(1 - s)), Part::kOutline},
                              {Transform(moving, solids.path.At(s)), Part::kMoving}},
                             relation, ViewOf(scene));
}

}  // namespace

std::string SceneId(const ShownScene& scene) {
  return "scene-" + Symbol(scene.given.before) + "-" + Symbol(scene.given.after);
}

std::string SceneArticle(const ShownScene& scene) {
  const DofIndex before = scene.given.before, after = scene.given.after;
  const std::string id = SceneId(scene);
  std::string html = fmt::format(
      "<article class=\"claim\" id=\"{}\">\n<h3>{} \u2194 {}</h3>\n<p class=\"statement\">{}</p>\n<dl>", id,
      Capital(Words(before)), Words(after), Escape(scene.given.story));
  const auto fact = [&](const char* name, const std::string& value) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, Escape(value));
  };
  fact("Forwards", Words(before) + " \u2192 " + Words(after));
  fact("Backwards", Words(after) + " \u2192 " + Words(before));
  fact("Practical by Fig. 2.5", algebra::IsPractical({Motion::kTranslation, before, after}) ? "yes" : "no");
  fact("Shown", Motions(scene.by_direction, scene));
  fact("Forced by the counts", Motions(scene.forced, scene));
  fact("Motion", PathText(scene.given.scene.path));
  fact("All directions of translation", Pairs(scene.by_direction, Motion::kTranslation));
  fact("Of rotation", Pairs(scene.by_direction, Motion::kRotation));
  html += "</dl>\n<div class=\"figures\">\n";
  html +=
      FigureHtml({"Start (s = 0), " + Dofs(scene.dof_before), Draw(scene, 0, scene.before)}, id + "-start");
  html += FigureHtml({"End (s = 1), " + Dofs(scene.dof_after), Draw(scene, 1, scene.after)}, id + "-end");
  return html + "</div>\n</article>\n";
}

}  // namespace tact::provers
