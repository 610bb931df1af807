#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "algebra/contact/scene.h"
#include "algebra/error.h"
#include "enumerators/neighbour_relations.h"
#include "provers/claims/census.h"
#include "provers/claims/trajectory_claims.h"
#include "provers/path_certificate.h"
#include "provers/report/scene_drawing.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::MotionDof;
using algebra::Rational;
using algebra::Vector3;
using Piece = std::vector<Vector3>;
using RankPair = std::pair<int, int>;

struct Example {
  ContactRelation before, after;
};

// Restricted DOFs over every relation of a world and the relations before it.
struct Steps {
  long long steps = 0, translational = 0, equal = 0, opposite = 0;
  std::map<RankPair, long long> pairs;  // of translation, in translational cases
  std::optional<Example> smallest_equal;
};

Steps CountSteps(const enumerators::ContactWorld& world) {
  Steps counted;
  algebra::MotionDofEngine engine;
  enumerators::ForEachRelation(world, [&](const ContactRelation& after) {
    for (size_t i = 1; i < after.contacts.size(); ++i) {
      if (after.contacts[i] == after.contacts[i - 1]) return;
    }
    const MotionDof e = engine.Compute(after);
    enumerators::ForEachRelationBefore(after, [&](const ContactRelation& before) {
      const MotionDof s = engine.Compute(before);
      ++counted.steps;
      const int shift = e.translation.restricted - s.translation.restricted,
                turn = e.rotation.restricted - s.rotation.restricted;
      if (shift * turn < 0 || shift < 0 || turn < 0) ++counted.opposite;
      if (turn != 0) return;
      ++counted.translational;
      ++counted.pairs[{s.translation.restricted, e.translation.restricted}];
      if (shift != 0) return;
      ++counted.equal;
      if (!counted.smallest_equal) counted.smallest_equal = Example{before, after};
    });
  });
  return counted;
}

// Points at a cube's corners, normals along the axes.
enumerators::ContactWorld World(Effort effort) {
  return enumerators::CubeWorld(effort == Effort::kQuick ? 3 : effort == Effort::kStandard ? 4 : 5);
}

std::string Bound(Effort effort) {
  return "all sets of up to " + std::to_string(World(effort).largest) +
         " contacts at a cube's corners, and every relation before them";
}

Claim RankGrowsClaim() {
  return {"thesis.A.3.2.rank-grows",
          "In a translational case Rank F_s < Rank F_e, so that Table A.1's six pairs are all.",
          "A.3.2, Table A.1", "exhaustive", [](Effort effort) {
            const Steps counted = CountSteps(World(effort));
            Outcome outcome;
            outcome.bound = Bound(effort);
            outcome.verdict = counted.equal > 0 ? Verdict::kRefuted : Verdict::kHoldsTo;
            outcome.numbers = {{"steps", counted.steps},
                               {"translational cases", counted.translational},
                               {"of them with equal ranks", counted.equal}};
            Table table{"Translational cases by rank", {"Rank F_s", "Rank F_e", "Steps"}, {}};
            for (const auto& [pair, count] : counted.pairs)
              table.rows.push_back(
                  {std::to_string(pair.first), std::to_string(pair.second), std::to_string(count)});
            outcome.tables = {table};
            outcome.evidence =
                "The six pairs are all those with Rank F_s < Rank F_e. But a step may leave both ranks as "
                "they are: a contact "
                "comes up that restricts nothing new, such as a fourth point of a face. ";
            if (counted.smallest_equal) {
              const Example& example = *counted.smallest_equal;
              outcome.evidence +=
                  "A smallest one: " + Describe(example.before) + "; then " + Describe(example.after) + ".";
              outcome.certificates = {
                  TransitionsCertificate("thesis.A.3.2.rank-grows.equal", "thesis.A.3.2.rank-grows",
                                         {{"before", example.before}, {"after", example.after}},
                                         {{0, {{"translation.restricted", 0}, {"rotation.restricted", 0}}}})};
            }
            outcome.evidence +=
                "\n\nNothing is lost: the case that Rank F_e names works with any Rank F_s. Moreover the "
                "line that follows a turn "
                "(A.6.3) meets equal ranks often; it is treated alike.";
            return outcome;
          }};
}

// Whether all contacts could be those of one edge with one face: one normal, points of a line.
bool IsLineContact(const ContactRelation& relation) {
  const auto& contacts = relation.contacts;
  std::optional<Vector3> along;
  for (const algebra::Contact& contact : contacts) {
    if (contact.planes.size() != 1 || !(contact.planes[0] == contacts[0].planes[0])) return false;
    const Vector3 to = contact.point - contacts[0].point;
    if (to.IsZero()) continue;
    if (along && !Parallel(*along, to)) return false;
    along = to;
  }
  return true;
}

Claim RankOneClaim() {
  return {"thesis.A.6.1.rank-one",
          "A restricted DOF in rotation is one only where the contact relation is one edge-face or one "
          "face-edge contact.",
          "A.6.1", "exhaustive", [](Effort effort) {
            const std::string id = "thesis.A.6.1.rank-one";
            long long one = 0, line = 0;
            std::optional<ContactRelation> smallest;
            std::map<int, std::array<long long, 2>> by_translation;
            algebra::MotionDofEngine engine;
            enumerators::ForEachRelation(World(effort), [&](const ContactRelation& relation) {
              for (size_t i = 1; i < relation.contacts.size(); ++i) {
                if (relation.contacts[i] == relation.contacts[i - 1]) return;
              }
              const MotionDof dof = engine.Compute(relation);
              if (dof.rotation.restricted != 1) return;
              const bool is_line = IsLineContact(relation);
              ++one;
              line += is_line ? 1 : 0;
              ++by_translation[dof.translation.restricted][is_line ? 0 : 1];
              // A line contact restricts one DOF in translation.
              if (!is_line && dof.translation.restricted > 1 && !smallest) smallest = relation;
            });
            Outcome outcome;
            outcome.bound = "all sets of up to " + std::to_string(World(effort).largest) +
                            " contacts at a cube's corners";
            outcome.verdict = smallest ? Verdict::kRefuted : Verdict::kHoldsTo;
            outcome.numbers = {{"sets with a restricted DOF of one in rotation", one},
                               {"of them one normal along one line", line}};
            Table table{"Sets whose restricted DOF in rotation is one",
                        {"Restricted in translation", "Edge-face or face-edge", "Others"},
                        {}};
            for (const auto& [translation, counts] : by_translation)
              table.rows.push_back(
                  {std::to_string(translation), std::to_string(counts[0]), std::to_string(counts[1])});
            outcome.tables = {table};
            outcome.evidence =
                "The thesis calls this an adequate assumption, for such relations are usually either of the "
                "two. In the enumeration they "
                "are the exception: an edge on the floor whose end also touches a wall restricts two DOFs in "
                "translation and one in rotation.";
            if (smallest) {
              outcome.evidence += "\n\nA smallest other one: " + Describe(*smallest) + ".";
              outcome.certificates = {
                  MotionDofCertificate(id + ".other", id, *smallest,
                                       {{{{"rotation.restricted", 2}, {"all.restricted", -1}}, "negative"}})};
            }
            outcome.evidence +=
                "\n\nFor such a relation tact plan applies A.4.2 as it is; where its first-order axes are "
                "too many, the location has no "
                "solution (A.23), and that is the failure it names.";
            return outcome;
          }};
}

Piece Box(const Vector3& low, const Vector3& high) {
  Piece corners;
  for (const Rational& x : {low.x, high.x}) {
    for (const Rational& y : {low.y, high.y}) {
      for (const Rational& z : {low.z, high.z}) corners.push_back({x, y, z});
    }
  }
  return corners;
}

// A body of a foot, a neck and a plate comes down about the foot's edge; under the plate, on the edge's line, stands the
// tip of a spike. So the plate turns about the tip.
algebra::Scene PlateOnSpike() {
  const Rational half(1, 2), quarter(1, 4);
  const algebra::MotionPath path = algebra::MotionPath::Rotation({0, 0, 0}, {0, Rational(1, 5), 0});
  const algebra::Pose back = path.At(1).Inverse();
  algebra::Scene scene{
      {Box({0, -3, 0}, {2, -2, 1}), Box({0, -2, half}, {2, 0, 1}), Box({-2, 0, 0}, {2, 2, 1})},
      {Box({-1, Rational(-7, 2), -1}, {3, Rational(-3, 2), 0}),
       {{0, 1, 0},
        {-quarter, 1 - quarter, -3},
        {quarter, 1 - quarter, -3},
        {-quarter, 1 + quarter, -3},
        {quarter, 1 + quarter, -3}}},
      path};
  for (Piece& piece : scene.moving_pieces) {
    for (Vector3& corner : piece) corner = back * corner;
  }
  return scene;
}

Claim OppositeWaysClaim() {
  return {"thesis.A.2.opposite-ways",
          "In a valid transition the restricted DOFs in translation and in rotation never go opposite ways.",
          "A.2", "exhaustive", [](Effort effort) {
            const std::string id = "thesis.A.2.opposite-ways";
            const Steps counted = CountSteps(World(effort));
            const algebra::Scene scene = PlateOnSpike();
            const algebra::PathContacts path = FollowScene(scene);
            if (path.event) throw InvariantError("the plate is stopped: " + path.event->what);
            const ContactRelation &s = path.middle.relation, &e = path.end.relation;
            const MotionDof before = ComputeMotionDof(s), after = ComputeMotionDof(e);
            Outcome outcome;
            outcome.bound = Bound(effort) + ", where they are; one motion of solids";
            outcome.verdict = (after.translation.restricted - before.translation.restricted) *
                                          (after.rotation.restricted - before.rotation.restricted) <
                                      0
                                  ? Verdict::kRefuted
                                  : Verdict::kHoldsTo;
            outcome.numbers = {{"steps in one configuration", counted.steps},
                               {"of them with a restricted DOF that falls", counted.opposite},
                               {"plate: in translation before", before.translation.restricted},
                               {"plate: in translation after", after.translation.restricted},
                               {"plate: in rotation before", before.rotation.restricted},
                               {"plate: in rotation after", after.rotation.restricted}};
            outcome.evidence =
                "Where contacts are added and nothing moves, neither falls: rank F grows with its rows, and "
                "rank G is three less the dimension "
                "of the angular parts of a null space that shrinks. But between two configurations normals "
                "turn. A plate comes down about an edge of its "
                "foot and turns about the tip of a spike that stands on the edge's line. Tilted, floor and "
                "plate have different normals: rank F "
                "is 2. When it lies flat, all normals are one: rank F is 1, though contacts were only "
                "gained, and the rank of G "
                "has grown to 2. All of what touched before still touches, so the transition is valid by "
                "Donald's condition (2.7.4).\n\n"
                "tact plan lets rotation decide the direction in which it plans, and says so in a note.";
            View view;
            view.width = 420;
            outcome.figures = {{"Tilted: the foot's edge on the floor, the plate on the tip",
                                DrawScene(scene, 0, path.start.relation, view)},
                               {"Flat", DrawScene(scene, 1, e, view)}};
            outcome.certificates = {PathCertificate(id + ".plate", id, scene)};
            return outcome;
          }};
}

}  // namespace

std::vector<Claim> TrajectoryRankClaims() { return {OppositeWaysClaim(), RankGrowsClaim(), RankOneClaim()}; }

}  // namespace tact::provers
