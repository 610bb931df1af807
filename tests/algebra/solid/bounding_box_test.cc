#include "algebra/solid/bounding_box.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

Rational Parsed(const char* text) { return *Rational::Parse(text); }

TEST(BoundingBox, AnEmptyBoxIsNearNothing) {
  EXPECT_FALSE(BoundingBox().Near(BoxOf({0, 0, 0}), 1e300));
  EXPECT_FALSE(BoxOf({0, 0, 0}).Near(BoundingBox(), 1e300));
}

TEST(BoundingBox, NearIsAlongEveryAxis) {
  const BoundingBox box = BoxOf({0, 0, 0});
  EXPECT_TRUE(box.Near(BoxOf({2, 2, -2}), 2));
  for (int i = 0; i < 3; ++i) {
    Vector3 far{1, 1, 1};
    far[i] = 3;
    EXPECT_FALSE(box.Near(BoxOf(far), 2));
    EXPECT_TRUE(box.Near(BoxOf(far), 3));
  }
}

// Numbers that no double has, huge ones and tiny ones among them, stay inside their boxes.
TEST(BoundingBox, HoldsWhatDoublesCannotSay) {
  for (const char* text :
       {"1/3", "-1/3", "1e-400", "-1e-400", "1e400", "-1e400", "123456789123456789123456789/7"}) {
    const Vector3 p{Parsed(text), 0, 0};
    const BoundingBox box = BoxOf(p);
    EXPECT_TRUE(box.Near(box, 0)) << text;
    EXPECT_TRUE(box.Near(BoxOf(p), 0)) << text;
    for (const double bound : {box.low[0], box.high[0]}) {
      if (std::isinf(bound)) continue;
      const bool below = bound == box.low[0];
      // 17 digits are not the bound itself, but nearer to it than the box's slack.
      EXPECT_TRUE(below ? Rational::FromShortestDecimal(bound) < p.x
                        : p.x < Rational::FromShortestDecimal(bound));
    }
  }
  EXPECT_TRUE(BoxOf({Parsed("1e400"), 0, 0}).Near(BoxOf({Parsed("2e400"), 0, 0}), 0));
  EXPECT_FALSE(BoxOf({Parsed("1e400"), 0, 0}).Near(BoxOf({1, 0, 0}), 1));
}

RC_GTEST_PROP(BoundingBoxLaw, HoldsEveryPointAdded, ()) {
  BoundingBox box;
  std::vector<Vector3> points;
  for (int i = 0; i < 5; ++i) {
    Vector3 p;
    for (int k = 0; k < 3; ++k) p[k] = Rational(Integer(Uniform(-1000, 1000)), Integer(Uniform(1, 1000)));
    points.push_back(p);
    box.Add(p);
  }
  for (const Vector3& p : points) RC_ASSERT(box.Near(BoxOf(p), 0));
}

}  // namespace
}  // namespace tact::algebra
