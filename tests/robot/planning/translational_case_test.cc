#include "robot/planning/translational_case.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace tact::planning {
namespace {

using Eigen::Vector3d;

// Rows of given normals; only what TranslationalCase looks at.
MotionRows Rows(const Basis& translations) {
  MotionRows rows;
  rows.translations = translations;
  rows.ranks.translation = 3 - static_cast<int>(translations.size());
  return rows;
}

// By hand: the thesis' three cases along the axes.
TEST(TranslationalCase, TheThreeCasesTakeOutWhatIsRedundant) {
  const Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), from(1, 2, 3), to(5, 7, 9);
  const MotionRows free = Rows({x, y, z});
  const Straight one = TranslationalCase(from, to, free, Rows({})),
                 two = TranslationalCase(from, to, free, Rows({x})),
                 three = TranslationalCase(from, to, free, Rows({x, y}));
  EXPECT_EQ(one.number, 1);
  EXPECT_EQ(one.displacement, Vector3d(4, 5, 6));
  EXPECT_EQ(two.number, 2);
  EXPECT_EQ(two.displacement, Vector3d(0, 5, 6));
  EXPECT_EQ(three.number, 3);
  EXPECT_EQ(three.displacement, Vector3d(0, 0, 6));
  EXPECT_EQ(TranslationalCase(from, to, free, free).displacement, Vector3d(0, 0, 0));
}

TEST(TranslationalCase, ALineThatLeavesTheStartsContactsIsMeasured) {
  const Vector3d x(1, 0, 0), y(0, 1, 0);
  const Straight line = TranslationalCase({0, 0, 0}, {3, 0, 4}, Rows({x, y}), Rows({}));
  EXPECT_NEAR(line.off_start, 0.8, 1e-15);
}

// Brute: no location of t_e + T_e is nearer.
RC_GTEST_PROP(TranslationalCase, NoLineIsShorter, ()) {
  const auto any = [] { return static_cast<double>(*rc::gen::inRange(-5, 6)); };
  const Vector3d from(any(), any(), any()), to(any(), any(), any()), a(any(), any(), 1 + std::abs(any()));
  const Vector3d n = a.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
  const Basis all = {n, u, v};
  for (int free = 0; free <= 2; ++free) {
    const Basis T(all.begin(), all.begin() + free);
    const Straight line = TranslationalCase(from, to, Rows(all), Rows(T));
    const Vector3d end = from + line.displacement;
    RC_ASSERT(PartOutside(T, end - to).norm() < 1e-12);
    for (const Vector3d& l : T) {
      for (const double step : {-0.5, 0.5})
        RC_ASSERT((line.displacement + step * l).norm() >= line.displacement.norm());
    }
  }
}

}  // namespace
}  // namespace tact::planning
