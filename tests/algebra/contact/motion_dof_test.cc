#include "algebra/contact/motion_dof.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "algebra/error.h"
#include "algebra/screw/pose.h"
#include "tests/algebra/contact/naive_motion_dof.h"

namespace tact::algebra {
namespace {

Contact At(const Vector3& point, const Vector3& normal) { return {point, {normal}, ""}; }

// Maintaining, detaching, constraining in translation / in rotation, where detaching is type I + type II.
std::string Brief(const MotionDof& dof) {
  const auto digit = [](int d) { return std::to_string(d); };
  const TranslationDof& t = dof.translation;
  const RotationDof& r = dof.rotation;
  EXPECT_EQ(r.detaching, r.detaching_type1 + r.detaching_type2);
  return digit(t.maintaining) + " " + digit(t.detaching) + " " + digit(t.constraining) + " / " +
         digit(r.maintaining) + " " + digit(r.detaching_type1) + "+" + digit(r.detaching_type2) + " " +
         digit(r.constraining);
}

std::string BriefOf(const ContactRelation& relation) { return Brief(ComputeMotionDof(relation)); }

const Vector3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

ContactRelation FaceOnTable() {
  return {{At({0, 0, 0}, kZ), At({1, 0, 0}, kZ), At({1, 1, 0}, kZ), At({0, 1, 0}, kZ)}};
}

// Expected values here are calculated by hand from [thesis, eq. (2.3), (2.4), Prop. 1-6].

TEST(MotionDof, WithoutContactEverythingIsKept) { EXPECT_EQ(BriefOf({}), "3 0 0 / 3 0+0 0"); }

TEST(MotionDof, VertexOnFaceTakesOneTranslation) {
  EXPECT_EQ(BriefOf({{At({1, 2, 3}, kZ)}}), "2 1 0 / 3 0+0 0");
}

TEST(MotionDof, EdgeOnFaceMakesOneRotationDetachBothWays) {
  EXPECT_EQ(BriefOf({{At({0, 0, 0}, kZ), At({1, 0, 0}, kZ)}}), "2 1 0 / 2 1+0 0");
}

TEST(MotionDof, FaceOnFaceKeepsThePlane) { EXPECT_EQ(BriefOf(FaceOnTable()), "2 1 0 / 1 2+0 0"); }

TEST(MotionDof, OpposedContactsOnOneLineFixIt) {
  const MotionDof dof = ComputeMotionDof({{At({0, 0, 0}, kZ), At({0, 0, 2}, -kZ)}});
  EXPECT_EQ(Brief(dof), "2 0 1 / 3 0+0 0");
  EXPECT_EQ(dof.all, (TranslationDof{5, 0, 1, 1}));
}

TEST(MotionDof, OpposedContactsOnTwoLinesLetTheObjectTurnOneWay) {
  const MotionDof dof = ComputeMotionDof({{At({0, 0, 0}, kZ), At({1, 0, 0}, -kZ)}});
  EXPECT_EQ(Brief(dof), "2 0 1 / 2 0+1 0");
  EXPECT_EQ(dof.all, (TranslationDof{4, 2, 0, 2}));
}

TEST(MotionDof, PegFlushWithBothWallsOfASlotSlidesInIt) {
  ContactRelation relation;
  for (const int side : {-1, 1}) {
    for (const int x : {0, 3}) {
      for (const int z : {0, 5}) relation.contacts.push_back(At({x, side, z}, {0, -side, 0}));
    }
  }
  EXPECT_EQ(BriefOf(relation), "2 0 1 / 1 0+0 2");
}

TEST(MotionDof, SixFacesOfABoxFixIt) {
  ContactRelation relation;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      for (const int u : {-1, 1}) {
        for (const int v : {-1, 1}) {
          Vector3 point{u, u, u}, normal;
          point[(axis + 1) % 3] = v;
          point[axis] = side;
          normal[axis] = -side;
          relation.contacts.push_back(At(point, normal));
        }
      }
    }
  }
  const MotionDof dof = ComputeMotionDof(relation);
  EXPECT_EQ(Brief(dof), "0 0 3 / 0 0+0 3");
  EXPECT_EQ(dof.all, (TranslationDof{0, 0, 6, 6}));
}

TEST(MotionDof, ThreeContactsAroundADiskLeaveItsTurningOneWayOrBothWays) {
  const auto relation = [](const Rational& offset) {
    return ContactRelation{{At({1, offset, 0}, -kX), At({0, 1, 0}, -kY), At({-1, -1, 0}, kX + kY)}};
  };
  EXPECT_EQ(BriefOf(relation(0)), "1 0 2 / 3 0+0 0");               // the lines of action meet
  EXPECT_EQ(BriefOf(relation(Rational(1, 7))), "1 0 2 / 2 0+1 0");  // they do not
}

// [thesis, 2.6, Fig. 2.17]: singular maintaining in translation is three although two directions are
// restricted; [thesis, 2.7, transition (2)]: from edge on face both restricted DOFs rise by one, to two.
TEST(MotionDof, ParallelEdgesAreSingularAndRestrictTwoAndTwo) {
  const Contact end{{0, 0, 0}, {kY, kZ}, ""}, other_end{{1, 0, 0}, {kY, kZ}, ""};
  const MotionDof dof = ComputeMotionDof({{end, other_end}});
  EXPECT_TRUE(dof.singular);
  EXPECT_EQ(Brief(dof), "3 0 0 / 3 0+0 0");
  EXPECT_EQ(dof.translation.restricted, 2);
  EXPECT_EQ(dof.rotation.restricted, 2);
  EXPECT_EQ(dof.all.restricted, 4);
}

TEST(MotionDof, SingularContactsAreLeftOutOfTheThreeKindsOnly) {  // [thesis, eq. (2.8)]
  ContactRelation relation = FaceOnTable();
  relation.contacts.push_back({{5, 5, 5}, {kX, kY}, ""});
  const MotionDof dof = ComputeMotionDof(relation);
  EXPECT_TRUE(dof.singular);
  EXPECT_EQ(Brief(dof), "2 1 0 / 1 2+0 0");
  EXPECT_EQ(dof.translation.restricted, 3);
  EXPECT_EQ(dof.rotation.restricted, 2);  // five rows, [ p x n | n ] all independent
}

TEST(MotionDof, ZeroNormalsAndContactsWithoutPlanesAreRefused) {
  EXPECT_THROW(ComputeMotionDof({{At({1, 2, 3}, {0, 0, 0})}}), PreconditionError);
  EXPECT_THROW(ComputeMotionDof({{Contact{{1, 2, 3}, {}, ""}}}), PreconditionError);
  EXPECT_THROW(ComputeMotionDof({{Contact{{1, 2, 3}, {kX, {0, 0, 0}}, ""}}}), PreconditionError);
}

rc::Gen<Rational> Small(int largest) {
  return rc::gen::map(
      rc::gen::pair(rc::gen::inRange(-largest, largest + 1), rc::gen::inRange(1, 4)),
      [](const std::pair<int, int>& pq) { return Rational(Integer(pq.first), Integer(pq.second)); });
}

rc::Gen<Vector3> Vector(const rc::Gen<Rational>& entry) {
  return rc::gen::map(rc::gen::tuple(entry, entry, entry),
                      [](const std::tuple<Rational, Rational, Rational>& v) {
                        return Vector3{std::get<0>(v), std::get<1>(v), std::get<2>(v)};
                      });
}

// Whole entries from -1 to 1 make parallel, opposed and coplanar normals and lines that meet common.
rc::Gen<ContactRelation> Relation(size_t most) {
  const auto entry = rc::gen::map(rc::gen::inRange(-1, 2), [](int i) { return Rational(i); });
  const auto normal = rc::gen::suchThat(Vector(entry), [](const Vector3& n) { return !n.IsZero(); });
  const auto point = rc::gen::oneOf(Vector(entry), Vector(Small(3)));
  const auto planes = rc::gen::oneOf(rc::gen::container<std::vector<Vector3>>(1, normal),
                                     rc::gen::container<std::vector<Vector3>>(1, normal),
                                     rc::gen::container<std::vector<Vector3>>(1, normal),
                                     rc::gen::container<std::vector<Vector3>>(2, normal));
  const auto contact =
      rc::gen::map(rc::gen::pair(point, planes), [](const std::pair<Vector3, std::vector<Vector3>>& c) {
        return Contact{c.first, c.second, ""};
      });
  return rc::gen::mapcat(rc::gen::inRange<size_t>(0, most + 1), [contact](size_t size) {
    return rc::gen::map(rc::gen::container<std::vector<Contact>>(size, contact),
                        [](const std::vector<Contact>& c) { return ContactRelation{c}; });
  });
}

ContactRelation Moved(const ContactRelation& relation, const Pose& pose) {
  ContactRelation result = relation;
  for (Contact& contact : result.contacts) {
    contact.point = pose * contact.point;
    for (Vector3& n : contact.planes) n = pose.rotation * n;
  }
  return result;
}

// A law on twenty relations a run, of full size from the first run on: a run costs microseconds.
template <typename Law>
void ForSomeRelations(size_t most, Law law) {
  for (int i = 0; i < 20; ++i) law(*rc::gen::resize(rc::kNominalSize, Relation(most)));
}

RC_GTEST_PROP(MotionDofLaw, EngineAgreesWithTheDefinitions, ()) {
  ForSomeRelations(4, [](const ContactRelation& relation) {
    RC_ASSERT(ComputeMotionDof(relation) == naive::ComputeMotionDof(relation));
  });
}

RC_GTEST_PROP(MotionDofLaw, NormalsCountUpToAPositiveFactor, ()) {
  ForSomeRelations(8, [](const ContactRelation& relation) {
    ContactRelation scaled = relation;
    for (Contact& contact : scaled.contacts) {
      for (Vector3& n : contact.planes)
        n = Rational(Integer(*rc::gen::inRange(1, 9)), Integer(*rc::gen::inRange(1, 9))) * n;
    }
    RC_ASSERT(ComputeMotionDof(scaled) == ComputeMotionDof(relation));
  });
}

RC_GTEST_PROP(MotionDofLaw, AnyFrameGivesTheSameDofs, ()) {
  ForSomeRelations(8, [](const ContactRelation& relation) {
    const Pose pose{Rotation::FromQuaternion(1, *Small(5), *Small(5), *Small(5)), *Vector(Small(9))};
    RC_ASSERT(ComputeMotionDof(Moved(relation, pose)) == ComputeMotionDof(relation));
  });
}

RC_GTEST_PROP(MotionDofLaw, OrderAndRepetitionOfContactsDoNotMatter, ()) {
  ForSomeRelations(8, [](const ContactRelation& relation) {
    ContactRelation shuffled = relation;
    for (size_t i = 0; i < relation.contacts.size(); ++i) {
      if (*rc::gen::arbitrary<bool>()) shuffled.contacts.push_back(relation.contacts[i]);
    }
    for (size_t i = shuffled.contacts.size(); i > 1; --i) {
      std::swap(shuffled.contacts[i - 1], shuffled.contacts[*rc::gen::inRange<size_t>(0, i)]);
    }
    RC_ASSERT(ComputeMotionDof(shuffled) == ComputeMotionDof(relation));
  });
}

RC_GTEST_PROP(MotionDofLaw, PointsSlideAlongTheirLinesOfAction, ()) {
  ForSomeRelations(8, [](const ContactRelation& any) {
    const ContactRelation relation = any.WithoutSingular();
    ContactRelation slid = relation;
    for (Contact& contact : slid.contacts) contact.point = contact.point + *Small(9) * contact.planes[0];
    RC_ASSERT(ComputeMotionDof(slid) == ComputeMotionDof(relation));
  });
}

// 2^40 + 15 and its like: rows leave 64 bits, the answers stay.
RC_GTEST_PROP(MotionDofLaw, HugeCoordinatesAndDenominatorsGiveTheDofsOfTheSmallRelation, ()) {
  ForSomeRelations(8, [](const ContactRelation& relation) {
    const Rational huge(Integer(1099511627791L));
    const Rational near_huge(Integer(1099511627689L));
    const Pose far{Rotation::FromQuaternion(huge, near_huge, 3, *Small(9)),
                   {huge, -near_huge, huge / near_huge}};
    ContactRelation large = Moved(relation, far);
    for (Contact& contact : large.contacts) {
      contact.point = huge * contact.point;
      contact.planes[0] = Rational(1) / near_huge * contact.planes[0];
    }
    MotionDofEngine engine;
    RC_ASSERT(engine.Compute(large) == engine.Compute(relation));
    RC_ASSERT(engine.overflows() == (relation.contacts.empty() ? 0u : 1u));
  });
}

// Some of these rows fit in 64 bits, some overflow while they are formed, some in the middle of a run.
RC_GTEST_PROP(MotionDofLaw, NothingChangesAcrossTheBorderOf64Bits, ()) {
  ForSomeRelations(8, [](const ContactRelation& relation) {
    const auto large = [] {
      const int bits = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(1, 45));
      return Rational(Integer((int64_t{1} << bits) + *rc::gen::inRange(-1, 2)));
    };
    ContactRelation grown =
        Moved(relation, {Rotation::FromQuaternion(1, 2, *Small(5), *Small(5)), {large(), large(), large()}});
    const Rational scale = large();
    for (Contact& contact : grown.contacts) contact.point = scale * contact.point;
    RC_ASSERT(ComputeMotionDof(grown) == ComputeMotionDof(relation));
  });
}

TEST(MotionDof, CoordinatesNearTwoToTheFortyOverflowOnTheWayAndStayRight) {
  const Rational s(Integer(1099511627776L - 87));
  ContactRelation small{{At({1, 0, 0}, -kX + kY), At({0, 1, 0}, -kY + kZ), At({-1, -1, 1}, kX + kY),
                         At({2, 0, 1}, -kZ), At({0, 3, -1}, kX - kY), At({1, 1, 1}, kY + kZ),
                         At({0, 0, 2}, -kX - kZ)}};
  ContactRelation large = small;
  for (Contact& contact : large.contacts) contact.point = s * contact.point;
  MotionDofEngine engine;
  EXPECT_EQ(engine.Compute(large), engine.Compute(small));
  EXPECT_EQ(engine.overflows(), 1u);
}

}  // namespace
}  // namespace tact::algebra
