#include "algebra/contact/relation_solids.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "algebra/cone/cone.h"
#include "algebra/contact/contact_finder.h"
#include "algebra/contact/contact_rows.h"
#include "algebra/contact/motion_dof.h"
#include "algebra/error.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

using Row = std::vector<Integer>;

std::set<Row> Rows(const ContactRelation& relation) {
  std::set<Row> rows;
  for (const Contact& contact : relation.contacts) {
    for (const Vector3& n : contact.planes) rows.insert(ContactRow(contact.point, n));
  }
  return rows;
}

ContactRelation Relation(const std::vector<std::pair<Vector3, Vector3>>& contacts) {
  ContactRelation relation;
  for (const auto& [p, n] : contacts) {
    relation.contacts.push_back({p, {n}, "c" + std::to_string(relation.contacts.size())});
  }
  return relation;
}

// All positive combinations of the rows: the wrenches that the contacts can apply.
GeneratorCone Wrenches(const ContactRelation& relation) {
  const std::set<Row> rows = Rows(relation);
  return Canonical({IntegerMatrix(0, 6), IntegerMatrix::FromRows({rows.begin(), rows.end()}, 6)});
}

// What the header promises, by the solids alone. Empty if it holds, else what does not.
std::string Fault(const ContactRelation& given) {
  const RelationSolids solids = RealizeRelation(given);
  const FoundContacts found = FindContacts(solids.moving, solids.fixed, 0);
  if (found.penetration) return "penetration";
  if (found.relation.singular()) return "singular contacts";
  if (found.relation.contacts.size() != solids.relation.contacts.size()) return "number of contacts";
  if (Rows(found.relation) != Rows(solids.relation)) return "contacts found";
  const std::set<Row> rows = Rows(given);
  if (!std::ranges::includes(rows, Rows(solids.relation))) return "contacts off their lines of action";
  if (Rows(solids.relation).size() != solids.relation.contacts.size()) return "one contact twice";
  if (Wrenches(found.relation) != Wrenches(given)) return "wrenches";
  if (ComputeMotionDof(found.relation) != ComputeMotionDof(given)) return "motion DOFs";
  const bool convex = std::ranges::all_of(
      solids.moving.edges, [](const Edge& edge) { return edge.convexity == Convexity::kConvex; });
  if (!convex || SixfoldVolume(solids.moving).sign() <= 0) return "the block";
  if (solids.fixed.shells != 2) return "the cage";
  return "";
}

std::vector<std::string> Names(const ContactRelation& relation) {
  std::vector<std::string> names;
  for (const Contact& contact : relation.contacts) names.push_back(contact.name);
  return names;
}

TEST(RelationSolids, AnEmptyRelationIsABlockThatHoversInABox) {
  EXPECT_EQ(Fault({}), "");
  const RelationSolids solids = RealizeRelation({});
  EXPECT_EQ(solids.moving.faces.size(), 6u);
  EXPECT_EQ(solids.fixed.faces.size(), 12u);
  EXPECT_TRUE(solids.relation.contacts.empty());
}

TEST(RelationSolids, EveryRelationOfUpToThreeContactsOfASmallWorldIsRealised) {
  const std::vector<Vector3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Vector3> normals = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, -1, 0}};
  std::vector<std::pair<Vector3, Vector3>> world;
  for (const Vector3& p : points) {
    for (const Vector3& n : normals) world.emplace_back(p, n);
  }
  const auto expect = [](const ContactRelation& relation) {
    const std::string fault = Fault(relation);
    EXPECT_EQ(fault, "") << "of " << relation.contacts.size() << " contacts, the last at "
                         << ToString(relation.contacts.back().point);
  };
  for (size_t i = 0; i < world.size(); ++i) {
    expect(Relation({world[i]}));
    for (size_t j = i + 1; j < world.size(); ++j) {
      expect(Relation({world[i], world[j]}));
      for (size_t k = j + 1; k < world.size(); ++k) expect(Relation({world[i], world[j], world[k]}));
    }
  }
}

TEST(RelationSolids, DiagonalNormalsAndNarrowAnglesAreRealised) {
  std::vector<std::pair<Vector3, Vector3>> all;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) all.push_back({{y, z, x}, {x, y, z}});
      }
    }
  }
  EXPECT_EQ(Fault(Relation(all)), "");  // 26 walls
  EXPECT_EQ(RealizeRelation(Relation(all)).relation.contacts.size(), 26u);
  EXPECT_EQ(Fault(Relation({{{0, 0, 0}, {100, 0, 1}}, {{1, 2, 3}, {100, 1, 0}}, {{3, 1, 4}, {-100, 1, 1}}})),
            "");
}

TEST(RelationSolids, NormalsApartByLessThanDoublesCanTellAreRealised) {
  const Rational large = *Rational::Parse("1e18");
  EXPECT_EQ(Fault(Relation({{{0, 0, 0}, {large, 1, 0}}, {{1, 2, 3}, {large, 0, 1}}, {{0, 5, 1}, {1, 0, 0}}})),
            "");
}

TEST(RelationSolids, AContactStaysOnItsLineOfActionAndKeepsItsName) {
  const ContactRelation given =
      Relation({{{3, 1, 0}, {0, 0, 2}}, {{0, 7, 1}, {1, 0, 0}}, {{0, 0, 5}, {0, -3, 1}}});
  const RelationSolids solids = RealizeRelation(given);
  ASSERT_EQ(Names(solids.relation), Names(given));
  for (size_t i = 0; i < 3; ++i) {
    const Contact &before = given.contacts[i], &after = solids.relation.contacts[i];
    EXPECT_EQ(after.planes.front(), Primitive(before.planes.front()));
    EXPECT_TRUE(Parallel(after.point - before.point, before.planes.front()));
    EXPECT_EQ(Locate(solids.moving, after.point), Side::kOnBoundary);
    EXPECT_EQ(Locate(solids.fixed, after.point), Side::kOnBoundary);
  }
}

TEST(RelationSolids, ContactsBetweenOthersOfTheirNormalAndRepeatedOnesAreLeftOut) {
  const Vector3 up = {0, 0, 1};
  const ContactRelation square = Relation({{{0, 0, 0}, up},
                                           {{2, 0, 5}, up},  // slid
                                           {{2, 2, 0}, up},
                                           {{0, 2, -1}, up},
                                           {{1, 1, 0}, up},   // in the middle
                                           {{1, 0, 2}, up},   // on an edge
                                           {{2, 2, 9}, up},   // the third again
                                           {{1, 1, 0}, -up},  // not between others of its normal
                                           {{0, 0, 0}, {0, 0, 7}}});
  EXPECT_EQ(Fault(square), "");
  EXPECT_EQ(Names(RealizeRelation(square).relation),
            (std::vector<std::string>{"c0", "c1", "c2", "c3", "c7"}));
}

TEST(RelationSolids, AnyUnitOfLengthWillDo) {
  const std::vector<std::pair<Vector3, Vector3>> contacts = {
      {{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 1, 1}}, {{0, 1, 0}, {-1, 0, 1}}};
  for (const char* unit : {"1e-9", "0.001", "1/3", "1000", "1e12"}) {
    std::vector<std::pair<Vector3, Vector3>> scaled;
    for (const auto& [p, n] : contacts) scaled.emplace_back(*Rational::Parse(unit) * p, n);
    EXPECT_EQ(Fault(Relation(scaled)), "") << unit;
  }
}

TEST(RelationSolids, SingularContactsAndZeroNormalsAreRefused) {
  EXPECT_THROW(RealizeRelation({{{{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}}, ""}}}), PreconditionError);
  EXPECT_THROW(RealizeRelation({{{{0, 0, 0}, {}, ""}}}), PreconditionError);
  EXPECT_THROW(RealizeRelation(Relation({{{0, 0, 0}, {0, 0, 0}}})), PreconditionError);
}

RC_GTEST_PROP(RelationSolids, RandomRelationsAreRealised, ()) {
  const int size = Uniform(0, 10), range = Uniform(1, 4);
  std::vector<std::pair<Vector3, Vector3>> contacts;
  for (int i = 0; i < size; ++i) {
    const auto vector = [&] {
      return Vector3{Uniform(-range, range + 1), Uniform(-range, range + 1), Uniform(-range, range + 1)};
    };
    const Vector3 point = Rational(1) / Rational(Uniform(1, 3)) * vector(), normal = vector();
    if (!normal.IsZero()) contacts.emplace_back(point, normal);
  }
  RC_ASSERT(Fault(Relation(contacts)) == "");
}

}  // namespace
}  // namespace tact::algebra
