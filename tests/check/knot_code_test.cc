#include "provers/check/knot_code.h"

#include <gtest/gtest.h>

#include <functional>

namespace tact::check {
namespace {

bool IsOnSphere(const std::string& text) { return OnSphere(ReadKnotCode(ParseJson(text))); }

TEST(KnotCode, TheThesisExamplesLieOnASphere) {
  EXPECT_TRUE(IsOnSphere(R"({"sigma":[4,5,6,1,2,3],"attr":[3,1,2,4,2,1]})"));  // [thesis, 5.1.2]
  EXPECT_TRUE(IsOnSphere(R"({"sigma":[4,5,6,1,2,3],"attr":[3,4,3,4,3,4]})"));  // [thesis, 5.4.1]
  EXPECT_TRUE(IsOnSphere(R"({"sigma":[],"attr":[]})"));
  EXPECT_FALSE(IsOnSphere(R"({"sigma":[3,4,1,2],"attr":[3,3,4,4]})"));
}

// All pairings of so many intersections with all attributes. Codes on a sphere: OEIS A373325.
TEST(KnotCode, AsManyLieOnASphereAsPublished) {
  for (const auto& [crossings, codes] : {std::pair{1, 2}, {2, 10}, {3, 66}}) {
    const int n = 2 * crossings;
    KnotCode code{std::vector<int>(static_cast<size_t>(n), 0), std::vector<int>(static_cast<size_t>(n), 0)};
    int on_sphere = 0;
    const std::function<void()> place = [&] {
      size_t first = 0;
      while (first < code.sigma.size() && code.sigma[first] != 0) ++first;
      if (first == code.sigma.size()) {
        on_sphere += OnSphere(code) ? 1 : 0;
        return;
      }
      for (size_t mate = first + 1; mate < code.sigma.size(); ++mate) {
        if (code.sigma[mate] != 0) continue;
        code.sigma[first] = static_cast<int>(mate) + 1;
        code.sigma[mate] = static_cast<int>(first) + 1;
        for (const int attr : {1, 3}) {  // the upper strand first: heights do not matter
          code.attr[first] = attr;
          code.attr[mate] = attr + 1;
          place();
        }
        code.sigma[first] = code.sigma[mate] = 0;
      }
    };
    place();
    EXPECT_EQ(on_sphere, codes);
  }
}

TEST(KnotCode, WhatIsNoneIsRefused) {
  for (const char* text :
       {R"({"sigma":[1,2],"attr":[1,2]})", R"({"sigma":[2,1],"attr":[1,1]})",
        R"({"sigma":[2,1],"attr":[1,4]})", R"({"sigma":[2],"attr":[1]})", R"({"sigma":[0,1],"attr":[1,2]})",
        R"({"sigma":[2,1],"attr":[0,2]})", R"({"sigma":[2,1],"attr":[1,2],"more":1})",
        R"({"sigma":[2,1,4,4],"attr":[1,2,1,2]})"}) {
    EXPECT_THROW(ReadKnotCode(ParseJson(text)), Refused) << text;
  }
}

}  // namespace
}  // namespace tact::check
