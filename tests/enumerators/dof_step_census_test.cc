#include "enumerators/dof_step_census.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "algebra/contact/contact_rows.h"
#include "algebra/contact/motion_dof.h"
#include "algebra/error.h"
#include "algebra/exact/linear_algebra.h"
#include "enumerators/dof_class.h"

namespace tact::enumerators {
namespace {

using algebra::ContactRelation;
using algebra::MotionDof;
using enum AdditionKind;

const MotionDof& Class(size_t number) {
  static const std::vector<MotionDof> classes = DofClasses();
  return classes.at(number);
}

// Maintaining, detaching, constraining in translation and in rotation.
using Six = std::array<int, 6>;
Six SixOf(size_t number) {
  const MotionDof& d = Class(number);
  return {d.translation.maintaining, d.translation.detaching, d.translation.constraining,
          d.rotation.maintaining,    d.rotation.detaching,    d.rotation.constraining};
}

using Counts = std::map<std::tuple<AdditionKind, Six, Six>, uint64_t>;
Counts CountsOf(const DofSteps& steps) {
  Counts counts;
  for (const DofStep& step : steps) counts[{step.kind, SixOf(step.before), SixOf(step.after)}] += step.count;
  return counts;
}

// By hand: floor and ceiling at one point, either first.
TEST(DofStepCensus, FloorAndCeiling) {
  const ContactWorld world{"", {{{0, 0, 0}, {{0, 0, 1}}, ""}, {{0, 0, 0}, {{0, 0, -1}}, ""}}, 2};
  const DofSteps steps = DofStepCensus(world).Count();
  EXPECT_EQ(CountsOf(steps), (Counts{{{kContact, {3, 0, 0, 3, 0, 0}, {2, 1, 0, 3, 0, 0}}, 2},
                                     {{kContact, {2, 1, 0, 3, 0, 0}, {2, 0, 1, 3, 0, 0}}, 2}}));
  ASSERT_EQ(steps.size(), 2U);  // the one with fewer maintaining DOFs before comes first
  EXPECT_EQ(steps[0].witness, (StepWitness{{0}, {1}}));
  EXPECT_EQ(steps[1].witness, (StepWitness{{}, {0}}));
}

// By hand: a box on a table, from nothing and from one corner. An edge more than the corner, or the rest of a triangle
// more than it, makes a face.
TEST(DofStepCensus, FourCornersOnATable) {
  ContactWorld world{"", {}, 2};
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
    world.contacts.push_back({{x, y, 0}, {{0, 0, 1}}, ""});
  const Six free = {3, 0, 0, 3, 0, 0}, corner = {2, 1, 0, 3, 0, 0}, edge = {2, 1, 0, 2, 1, 0},
            face = {2, 1, 0, 1, 2, 0};
  EXPECT_EQ(CountsOf(DofStepCensus(world).Count()), (Counts{{{kContact, free, corner}, 4},
                                                            {{kEdge, free, edge}, 6},
                                                            {{kFace, free, face}, 5},
                                                            {{kContact, corner, edge}, 4 * 3},
                                                            {{kEdge, corner, face}, 4 * 3},
                                                            {{kFace, corner, face}, 4}}));
}

// Twin: every relation by the other walk, every addition by what the cube's faces are, DOFs by another call.
TEST(DofStepCensus, AgreesWithASlowWalkOverACube) {
  const ContactWorld world = CubeWorld(3);
  Counts expected;
  std::vector<std::pair<AdditionKind, std::vector<size_t>>> additions;
  for (size_t mask = 1; mask < 16; ++mask) {
    for (size_t face = 0; face < 6; ++face) {  // four contacts with one normal follow on one another
      std::vector<size_t> contacts;
      for (size_t i = 0; i < 4; ++i) {
        if ((mask >> i) % 2 == 1) contacts.push_back(4 * face + i);
      }
      const size_t size = contacts.size();
      additions.emplace_back(size == 1 ? kContact : size == 2 ? kEdge : kFace, contacts);
    }
  }
  const auto six = [](const ContactRelation& relation) {
    const MotionDof d = ComputeMotionDof(relation);
    return Six{d.translation.maintaining, d.translation.detaching, d.translation.constraining,
               d.rotation.maintaining,    d.rotation.detaching,    d.rotation.constraining};
  };
  const auto has = [](const ContactRelation& relation, const algebra::Contact& contact) {
    return std::count(relation.contacts.begin(), relation.contacts.end(), contact);
  };
  ForEachRelation(CubeWorld(2), [&](const ContactRelation& relation) {
    for (const algebra::Contact& contact : relation.contacts) {
      if (has(relation, contact) > 1) return;
    }
    for (const auto& [kind, contacts] : additions) {
      ContactRelation after = relation;
      bool is_new = true;
      for (const size_t i : contacts) {
        is_new = is_new && has(relation, world.contacts[i]) == 0;
        after.contacts.push_back(world.contacts[i]);
      }
      if (is_new) ++expected[{kind, six(relation), six(after)}];
    }
  });
  EXPECT_EQ(CountsOf(DofStepCensus(world).Count()), expected);
}

// Theorem 1 of docs/dof-transitions.md, on the classes before and after every step of one contact.
TEST(DofStepCensus, OneContactObeysTheTheorem) {
  uint64_t steps = 0, in_translation = 0, in_rotation = 0;
  for (const DofStep& step : DofStepCensus(CornerWorld(4)).Count()) {
    if (step.kind != kContact) continue;
    steps += step.count;
    const Six a = SixOf(step.before), b = SixOf(step.after);
    const Six change = {b[0] - a[0], b[1] - a[1], b[2] - a[2], b[3] - a[3], b[4] - a[4], b[5] - a[5]};
    const int blocked_t = change[2], blocked_r = change[5];
    const MotionDof &before = Class(step.before), &after = Class(step.after);
    if (change[0] != 0) {
      EXPECT_EQ(change, (Six{-1, 1, 0, 0, 0, 0}));
      EXPECT_EQ(before.rotation, after.rotation);  // the types as well
      in_translation += step.count;
    } else if (change[3] != 0) {
      EXPECT_EQ(change, (Six{0, -blocked_t, blocked_t, -1, 1, 0}));
      EXPECT_GE(blocked_t, 0);
      in_rotation += step.count;
    } else {
      EXPECT_EQ(change, (Six{0, -blocked_t, blocked_t, 0, -blocked_r, blocked_r}));
      EXPECT_GE(blocked_t, 0);
      EXPECT_GE(blocked_r, 0);
    }
  }
  EXPECT_EQ(steps, 28U + 28 * 27 + 28 * 27 / 2 * 26 + 28 * 27 * 26 / 6 * 25);
  EXPECT_GT(in_translation, 0U);
  EXPECT_GT(in_rotation, 0U);
}

// The theorem's cases are told by ranks: of the normals, and of the rows.
TEST(DofStepCensus, TheCaseOfAContactIsToldByRanks) {
  const ContactWorld world = CornerWorld(3);
  const auto rank = [](const ContactRelation& relation, size_t columns) {
    algebra::IntegerMatrix rows(0, columns);
    for (const algebra::Contact& c : relation.contacts) {
      const std::vector<algebra::Integer> row = algebra::ContactRow(c.point, c.planes[0]);
      rows.AppendRow(std::span(row).last(columns));
    }
    return static_cast<int>(Rank(rows));
  };
  int cases[3] = {};
  ForEachRelation(CornerWorld(2), [&](const ContactRelation& relation) {
    for (const algebra::Contact& contact : world.contacts) {
      ContactRelation more = relation;
      more.contacts.push_back(contact);
      const MotionDof a = ComputeMotionDof(relation), b = ComputeMotionDof(more);
      const int new_normal = rank(more, 3) - rank(relation, 3), new_row = rank(more, 6) - rank(relation, 6);
      ++cases[new_normal == 1 ? 0 : new_row == 1 ? 1 : 2];
      EXPECT_EQ(a.translation.maintaining - b.translation.maintaining, new_normal);
      EXPECT_EQ(a.rotation.maintaining - b.rotation.maintaining, new_row - new_normal);
    }
  });
  for (const int met : cases) EXPECT_GT(met, 0);
}

TEST(DofStepCensus, PartsMergeInAnyOrder) {
  const DofStepCensus census(CornerWorld(4));
  const DofSteps whole = census.Count();
  std::vector<DofSteps> parts;
  for (uint64_t first = 0; first < census.relations(); first += 700)
    parts.push_back(census.CountRange(first, std::min(census.relations(), first + 700)));
  ASSERT_EQ(parts.size(), 6U);
  for (const std::vector<size_t>& order : {std::vector<size_t>{5, 4, 3, 2, 1, 0}, {2, 0, 5, 3, 1, 4}}) {
    DofSteps merged;
    for (const size_t part : order) DofStepCensus::Merge(merged, parts[part]);
    EXPECT_EQ(merged, whole);
  }
}

TEST(DofStepCensus, UnitsTileTheRelations) {
  for (const DofStepCensus& census : {DofStepCensus(CornerWorld(6)), DofStepCensus(AxisWorld(3))}) {
    EXPECT_GT(census.units(), 1U);
    EXPECT_GE(census.units() * census.relations_in_a_unit(), census.relations());
    EXPECT_LT((census.units() - 1) * census.relations_in_a_unit(), census.relations());
  }
  const DofStepCensus census(CornerWorld(5));
  const uint64_t size = census.relations_in_a_unit(), first = (census.units() - 1) * size;
  EXPECT_EQ(census.CountUnit(census.units() - 1), census.CountRange(first, census.relations()));
  EXPECT_THROW(census.CountUnit(census.units()), PreconditionError);
  EXPECT_THROW(census.CountRange(0, census.relations() + 1), PreconditionError);
  EXPECT_EQ(census.CountRange(7, 7), DofSteps{});
}

TEST(DofStepCensus, AWitnessIsTheFirstOfItsKind) {
  const DofStepCensus census(CornerWorld(3));
  std::set<std::tuple<AdditionKind, size_t, size_t>> met;
  const DofSteps whole = census.Count();
  for (uint64_t number = 0; number < census.relations(); ++number) {
    for (const DofStep& step : census.CountRange(number, number + 1)) {
      if (!met.emplace(step.kind, step.before, step.after).second) continue;
      const auto same = std::ranges::find_if(whole, [&](const DofStep& s) {
        return s.kind == step.kind && s.before == step.before && s.after == step.after;
      });
      ASSERT_NE(same, whole.end());
      EXPECT_EQ(same->witness, step.witness);
    }
  }
  EXPECT_EQ(met.size(), whole.size());
}

TEST(DofStepCensus, WorldsWithoutStepsAreRefused) {
  EXPECT_THROW(DofStepCensus(CornerWorld(0)), PreconditionError);
  EXPECT_THROW(DofStepCensus(SingularWorld(2)), PreconditionError);
  EXPECT_THROW(DofStepCensus(DiagonalWorld(60)), PreconditionError);
}

TEST(DofStepText, IsReadBackAsItWas) {
  const DofSteps steps = DofStepCensus(CornerWorld(3)).Count();
  ASSERT_GT(steps.size(), 50U);
  EXPECT_EQ(ParseDofSteps(ToText(steps)), steps);
  EXPECT_EQ(ParseDofSteps(ToText({})), DofSteps{});
}

TEST(DofStepText, AnythingElseIsRefusedWithThePlace) {
  const std::string text = ToText(DofStepCensus(CornerWorld(1)).Count());
  for (size_t i = 0; i < text.size(); ++i) EXPECT_THROW(ParseDofSteps(text.substr(0, i)), InputError) << i;
  EXPECT_THROW(ParseDofSteps(text + "\n"), InputError);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    return other;
  };
  const size_t line = text.find('\n', 2);
  for (const std::string& wrong :
       {changed("edge", "wedge"), changed("\"before\":", "\"before\":9"), changed(":28,", ":-28,"),
        text.substr(0, line) + text.substr(1, line - 1) + "]"}) {
    try {
      ParseDofSteps(wrong);
      ADD_FAILURE() << wrong;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("byte "), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace tact::enumerators
