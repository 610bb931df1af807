#include "provers/report/sphere_region.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "algebra/contact/motion_dof.h"
#include "algebra/error.h"
#include "provers/report/sphere_drawing.h"
#include "tests/algebra/uniform.h"
#include "tests/provers/report/ten_regions.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::Vector3;

TEST(SphereRegion, TellsTheTenTranslationalKindsApart) {
  for (const RegionExample& example : TenRegions()) {
    EXPECT_EQ(LegalDirections(Normals(example.normals)), example.region) << example.name;
    EXPECT_EQ(NameOf(example.region), example.name);
  }
}

RC_GTEST_PROP(SphereRegion, TheKindIsThatOfTheTranslationDof, ()) {
  ContactRelation relation;
  const int size = Uniform(0, 7);
  for (int i = 0; i < size; ++i) {
    const Vector3 n = {Uniform(-1, 2), Uniform(-1, 2), Uniform(-1, 2)};
    if (!n.IsZero()) relation.contacts.push_back({{0, 0, 0}, {n}, ""});
  }
  const algebra::TranslationDof dof = ComputeMotionDof(relation).translation;
  const algebra::TranslationDof same =
      ComputeMotionDof(Normals(TenRegions().at(static_cast<size_t>(LegalDirections(relation))).normals))
          .translation;
  RC_ASSERT(dof.maintaining == same.maintaining);
  RC_ASSERT(dof.detaching == same.detaching);
  RC_ASSERT(dof.constraining == same.constraining);
}

TEST(SphereRegion, PiecesAreLegalAndOnTheSideTheySay) {
  const Vector3 toward = {3, -2, 1};
  View view = kSphereView;
  view.toward_viewer = {3, -2, 1};
  for (const RegionExample& example : TenRegions()) {
    const SphereSets sets = CutIntoPieces(Normals(example.normals), view);
    for (const SphereSet* set : {&sets.legal, &sets.maintaining}) {
      EXPECT_EQ(set->pieces.empty(), set->dimension == 0) << example.name;
      for (const SpherePiece& piece : set->pieces) {
        ASSERT_EQ(piece.corners.size(), piece.border.size());
        EXPECT_TRUE(set->dimension == 3 ? piece.corners.size() >= 3 : piece.corners.size() == set->dimension);
        for (const Vector3& corner : piece.corners) {
          EXPECT_TRUE(Dot(toward, corner).sign() * (piece.front ? 1 : -1) >= 0) << example.name;
          for (const Vector3& n : example.normals) {
            EXPECT_TRUE(set == &sets.legal ? Dot(n, corner).sign() >= 0 : Dot(n, corner).sign() == 0);
          }
        }
      }
    }
  }
}

TEST(SphereRegion, WhatIsNoNonSingularRelationIsRefused) {
  EXPECT_THROW(LegalDirections(Normals({{0, 0, 0}})), PreconditionError);
  EXPECT_THROW(LegalDirections({{{{0, 0, 0}, {}, ""}}}), PreconditionError);
  EXPECT_THROW(CutIntoPieces({{{{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}}, ""}}}, kSphereView), PreconditionError);
}

}  // namespace
}  // namespace tact::provers
