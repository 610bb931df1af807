#include "robot/correction/contact_problem.h"

#include <gtest/gtest.h>

#include "robot/correction/table_noise.h"

namespace tact::correction {
namespace {

using joint::Transform;
using Vector6 = Eigen::Matrix<double, 6, 1>;

double Volume(const ConvexPiece& piece) {
  // By the middle: a third of each face's distance times its area, the area by the fan of its corners in order.
  double volume = 0;
  for (const HalfSpace& h : piece.faces) {
    std::vector<Eigen::Vector3d> corners;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const auto& v : piece.vertices)
      if (std::abs(h.normal.dot(v) - h.offset) < 1e-9) corners.push_back(v), centre += v;
    centre /= static_cast<double>(corners.size());
    const Eigen::Vector3d x = h.normal.unitOrthogonal(), y = h.normal.cross(x);
    std::sort(corners.begin(), corners.end(), [&](const auto& a, const auto& b) {
      return std::atan2(y.dot(a - centre), x.dot(a - centre)) <
             std::atan2(y.dot(b - centre), x.dot(b - centre));
    });
    double area = 0;
    for (size_t i = 0; i < corners.size(); ++i)
      area += (corners[i] - centre).cross(corners[(i + 1) % corners.size()] - centre).norm() / 2;
    volume += area * (h.offset - h.normal.dot(piece.middle)) / 3;
  }
  return volume;
}

TEST(ConvexPieces, TheyFillTheSolid) {
  for (const std::string& name : TableRelationNames()) {
    const TableRelation table = TableRelationNamed(name);
    for (const algebra::Polyhedron* solid : {&table.moving, &table.fixed}) {
      double volume = 0;
      for (const ConvexPiece& piece : ConvexPiecesOf(*solid)) volume += Volume(piece);
      EXPECT_NEAR(6 * volume, algebra::ToDouble(SixfoldVolume(*solid)), 1e-6 * volume) << name;
    }
  }
}

// By hand: the block less its slot is two blocks and a floor; the peg is one.
TEST(ConvexPieces, ABlockWithASlotIsThree) {
  const TableRelation table = TableRelationNamed("C");
  EXPECT_EQ(ConvexPiecesOf(table.moving).size(), 1U);
  EXPECT_EQ(ConvexPiecesOf(table.fixed).size(), 3U);
}

// Values against recognition::GapOf, derivatives against differences.
TEST(ContactFunctions, JetsAgreeWithGapsAndDifferences) {
  perception::RandomNumbers random(3);
  for (const std::string& name : TableRelationNames()) {
    const TableCase c(name);
    const Eigen::Vector3d reference(3, -4, 5);
    for (const auto& contact : c.relation.contacts) {
      const Transform X = Noisy(*c.relation.realisation, random);
      std::vector<Feature> features = WithinFeatures(contact, c.models, X);
      features.push_back(GapFeature(contact, c.models));
      if (contact.kind != recognition::PointContactKind::kEdgeEdge)
        EXPECT_NEAR(ValueOf(features.back(), PosedAt(X, reference)),
                    GapOf(contact, c.models.moving.elements, c.models.fixed.elements, X).gap, 1e-10);
      for (const Feature& feature : features) {
        const Jet<6> jet = ValueOf(feature, JetAt(X, reference));
        Vector6 step;
        for (int i = 0; i < 6; ++i) step[i] = (i < 3 ? 1e-3 : 0.1) * random.Gaussian();
        const auto at = [&](double t) {
          return ValueOf(feature, PosedAt(Stepped(X, reference, t * step), reference));
        };
        const double slope = (at(1) - at(-1)) / 2, curvature = at(1) - 2 * at(0) + at(-1);
        EXPECT_NEAR(jet.value, at(0), 1e-9);
        EXPECT_NEAR(jet.gradient.dot(step), slope, 1e-4 * std::abs(slope) + 1e-5) << name;
        EXPECT_NEAR(step.dot(jet.hessian * step), curvature, 1e-2 * std::abs(curvature) + 1e-5) << name;
      }
    }
  }
}

TEST(ContactProblem, ARealisationIsJudgedCorrectAndFaultsAreNamed) {
  for (const std::string& name : TableRelationNames()) {
    const TableCase c(name);
    Transform X = *c.relation.realisation;
    EXPECT_EQ(Judge(c.models, c.relation.contacts, X), Outcome::kCorrected) << name;
    X.p.z() += 1;
    EXPECT_EQ(Judge(c.models, c.relation.contacts, X), Outcome::kGapRemains) << name;
    X = *c.relation.realisation;
    X.p.y() += 100;  // 80 deep each way, the peg 20: a corner is 40 beyond the block's front
    EXPECT_EQ(Judge(c.models, c.relation.contacts, X), Outcome::kElementsApart) << name;
  }
  // The peg's edge on the top, leaning the other way by a half turn about the edge's line: all of it inside the block.
  const TableCase a("A");
  Transform X = *a.relation.realisation;
  const Eigen::Vector3d edge = X * a.models.moving.elements.vertices[a.relation.contacts[0].moving];
  X = Transform{joint::RotationExp({0, M_PI, 0}), {0, 0, 0}} * Transform{Eigen::Matrix3d::Identity(), -edge} *
      X;
  X.p += edge;
  EXPECT_EQ(Judge(a.models, a.relation.contacts, X), Outcome::kPenetrates);
}

// The solids stand where they stood; only what is called the origin is another point.
TEST(TableRelations, WithTheOriginAtTheContactsTheContactsAreTheSame) {
  for (const std::string& name : TableRelationNames()) {
    const TableRelation table = TableRelationNamed(name), moved = WithOriginAtContacts(table);
    EXPECT_EQ(RelationOf(moved).contacts, RelationOf(table).contacts) << name;
    const auto at = [](const TableRelation& t, size_t v) {
      return t.realisation * t.moving.vertices[v].point;
    };
    for (size_t v = 0; v < table.moving.vertices.size(); ++v) EXPECT_EQ(at(moved, v), at(table, v)) << name;
    algebra::Vector3 sum;
    for (const auto& contact : table.found.relation.contacts)
      sum = sum + (contact.point - moved.realisation.translation);
    EXPECT_TRUE(sum.IsZero()) << name;
  }
}

}  // namespace
}  // namespace tact::correction
