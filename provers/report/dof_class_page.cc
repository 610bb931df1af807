#include "provers/report/dof_class_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "algebra/contact/relation_solids.h"
#include "provers/report/html.h"
#include "provers/report/relation_drawing.h"
#include "provers/report/sphere_drawing.h"
#include "provers/report/text.h"

namespace tact::provers {
namespace {

using enumerators::DofCensus;
using enumerators::DofClassList;
using enumerators::FoundClass;

std::string Grouped(uint64_t value) { return GroupedDigits(static_cast<long long>(value)); }

// "2 maintaining, 1 detaching, 0 constraining" from three of a class' values.
std::string Kinds(int maintaining, const std::string& detaching, int constraining) {
  return fmt::format("{} maintaining, {}, {} constraining", maintaining, detaching, constraining);
}

std::string Kinds(const int* values) {
  return Kinds(values[0], fmt::format("{} detaching", values[1]), values[2]);
}

std::string Head(const DofCensus& census, const std::vector<DofClassList>& lists) {
  const bool complete = std::ranges::all_of(lists, &DofClassList::complete);
  Table counts{"Classes by the indices that tell two relations apart", {"indices", "found", "at most"}, {}};
  for (const DofClassList& list : lists) {
    counts.rows.push_back(
        {list.definition->name, std::to_string(list.found.size()), std::to_string(list.upper_bound)});
  }
  const DofClassList& finest = lists.back();
  const std::string boxes =
      enumerators::IsBoxWorld(census.world())
          ? fmt::format("; solids whose faces are all parallel to coordinate planes have {} at most",
                        enumerators::BoxClasses().size())
          : "";
  return fmt::format(
             "<header class=\"top\">\n<h1>What contacts allow</h1>\n<p class=\"lead\">{} of motion degrees "
             "of freedom, "
             "each with a smallest witness.</p>\n"
             "<p>Two solids that touch may still move. A motion is maintaining if it keeps every contact and "
             "so does its "
             "opposite, detaching if it opens one, constraining if it is blocked both ways; how "
             "many "
             "independent motions there are of each kind, in translation, in rotation (with the two types of "
             "detaching) "
             "and in all motion, sorts contact relations into classes. Below is {}</p>\n"
             "<p>{} relations were tried, sets of contacts without repetition: {}.</p>\n</header>\n",
             finest.found.size() == 1 ? "1 class" : std::to_string(finest.found.size()) + " classes",
             complete
                 ? "the complete list: what is not in it is excluded by a lemma, what is in it has a witness."
                 : fmt::format(
                       "what was found: {} of the {} classes that the lemmas allow. The world that was "
                       "searched has no more{}.",
                       finest.found.size(), finest.upper_bound, boxes),
             Grouped(census.relations()), Escape(census.world().sentence)) +
         TableHtml(counts);
}

std::string Lemmas() {
  const auto& lemmas = enumerators::DofLemmas();
  std::vector<size_t> first(lemmas.size(), 0);
  const auto candidates = enumerators::DofCandidates();
  for (const algebra::MotionDof& candidate : candidates) {
    if (const auto lemma = enumerators::ExcludingLemma(candidate)) ++first[*lemma];
  }
  Table table{
      "Candidates that a lemma excludes and none before it does", {"lemma", "statement", "excludes"}, {}};
  for (size_t i = 0; i < lemmas.size(); ++i)
    table.rows.push_back({lemmas[i].id, lemmas[i].statement, std::to_string(first[i])});
  return fmt::format(
      "<h2>What cannot occur</h2>\n<p>The definitions alone leave {} candidates, the lemmas {} of them. m, "
      "d, c, r: "
      "maintaining, detaching, constraining, restricted; t, r, a: translation, rotation, all motion; d_r1 "
      "and d_r2 are "
      "the detaching rotations of Types I and II.</p>\n{}",
      candidates.size(), enumerators::DofClasses().size(), TableHtml(table));
}

std::string Translations(const DofCensus& census, const DofClassList& translations,
                         const std::map<std::vector<int>, size_t>& finer) {
  std::string html =
      "<h2>In translation</h2>\n<p>The directions in which a relation of each class lets the moving solid "
      "go, on the "
      "sphere of all directions: legal ones green, maintaining ones red.</p>\n<div class=\"figures\">\n";
  for (auto found = translations.found.rbegin(); found != translations.found.rend(); ++found) {
    const std::string caption = fmt::format("{}: {}, {} in the finest list", Kinds(found->values.data()),
                                            Plural(found->count, "relation"), finer.at(found->values));
    html += FigureHtml({caption, DrawLegalDirections(census.Relation(found->witness))},
                       fmt::format("translation-{}", fmt::join(found->values, "-")));
  }
  return html + "</div>\n";
}

std::string Witness(const algebra::ContactRelation& relation) {
  if (relation.contacts.empty()) return "nothing touches";
  std::string text;
  const auto vector = [](const algebra::Vector3& v) {
    return fmt::format("({}, {}, {})", v.x.ToString(), v.y.ToString(), v.z.ToString());
  };
  for (const algebra::Contact& contact : relation.contacts) {
    text += (text.empty() ? "" : "; ") + vector(contact.point) + " \u2192 " + vector(contact.planes[0]);
  }
  return text;
}

std::string Article(const DofCensus& census, const FoundClass& found) {
  const std::vector<int>& v = found.values;
  const std::string id = fmt::format("class-{}", fmt::join(v, "-"));
  const algebra::ContactRelation relation = census.Relation(found.witness);
  std::string html = fmt::format("<article class=\"claim\" id=\"{0}\">\n<dl>", id);
  const auto fact = [&](const char* name, const std::string& value) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, Escape(value));
  };
  fact("Rotation", Kinds(v[3], fmt::format("{} + {} detaching (Types I + II)", v[4], v[5]), v[6]));
  fact("All motion", Kinds(&v[7]));
  fact("Relations", Grouped(found.count));
  html += fmt::format("</dl>\n<p class=\"small\">Smallest witness, points \u2192 normals: {}</p>\n",
                      Escape(Witness(relation)));
  html += "<details><summary>Two solids that touch so</summary>\n";
  const Figure figure{
      "A block in a cage; the contacts have slid along their lines of action, which changes no motion.",
      DrawRelationSolids(algebra::RealizeRelation(relation))};
  return html + FigureHtml(figure, id + "--figure") + "</details>\n</article>\n";
}

// Whatever the finest definition tells apart begins with the three indices of translation.
std::vector<int> TranslationOf(const FoundClass& found) {
  return {found.values.begin(), found.values.begin() + 3};
}

std::string Classes(const DofCensus& census, const DofClassList& finest) {
  std::string html = "<h2>All classes</h2>\n";
  std::vector<int> translation;
  for (auto found = finest.found.rbegin(); found != finest.found.rend(); ++found) {
    if (TranslationOf(*found) != translation) {
      translation = TranslationOf(*found);
      html += fmt::format("<h3>Translation: {}</h3>\n", Kinds(translation.data()));
    }
    html += Article(census, *found);
  }
  return html;
}

}  // namespace

std::string DofClassPage(const DofCensus& census, const std::vector<DofClassList>& lists) {
  std::map<std::vector<int>, size_t> finer;
  for (const FoundClass& found : lists.back().found) ++finer[TranslationOf(found)];
  return PageHtml("tact: what contacts allow", Head(census, lists) + "<main>\n" +
                                                   Translations(census, lists.front(), finer) + Lemmas() +
                                                   Classes(census, lists.back()) + "</main>\n");
}

}  // namespace tact::provers
