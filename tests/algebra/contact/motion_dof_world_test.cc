#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "algebra/contact/motion_dof.h"
#include "tests/algebra/contact/naive_motion_dof.h"

namespace tact::algebra {
namespace {

// Every relation of up to three contacts with points in {-1, 0, 1}^3 and normals along the axes. The
// naive method runs once for each set of rows; the engine gets every relation.
class MotionDofWorld : public testing::Test {
 protected:
  MotionDofWorld() {
    std::map<naive::Row, int> numbers;
    for (int code = 0; code < 27; ++code) {
      const Vector3 point{code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
      for (int direction = 0; direction < 6; ++direction) {
        Vector3 normal;
        normal[direction / 2] = direction % 2 == 0 ? 1 : -1;
        contacts_.push_back({point, {normal}, ""});
        const naive::Row row = naive::MotionRows({{contacts_.back()}}).front();
        rows_.push_back(numbers.emplace(row, static_cast<int>(numbers.size())).first->second);
      }
    }
  }

  // Calls visit(relation, sorted numbers of its rows) for contacts chosen in order, repetition allowed.
  template <typename Visit>
  void ForEach(size_t most, Visit visit) {
    ContactRelation relation;
    std::vector<int> rows;
    const auto extend = [&](const auto& self, size_t first) -> void {
      std::vector<int> sorted = rows;
      std::sort(sorted.begin(), sorted.end());
      visit(relation, sorted);
      for (size_t i = first; i < contacts_.size() && rows.size() < most; ++i) {
        relation.contacts.push_back(contacts_[i]);
        rows.push_back(rows_[i]);
        self(self, i);
        relation.contacts.pop_back();
        rows.pop_back();
      }
    };
    extend(extend, 0);
  }

  std::vector<Contact> contacts_;
  std::vector<int> rows_;  // equal numbers, equal rows
};

TEST_F(MotionDofWorld, EngineAgreesWithTheDefinitionsEverywhere) {
  std::map<std::vector<int>, MotionDof> expected;
  size_t relations = 0, differences = 0;
  ForEach(3, [&](const ContactRelation& relation, const std::vector<int>& rows) {
    const auto [entry, is_new] = expected.try_emplace(rows);
    if (is_new) entry->second = naive::ComputeMotionDof(relation);
    ++relations;
    if (ComputeMotionDof(relation) != entry->second && ++differences == 1) {
      for (const Contact& c : relation.contacts) {
        ADD_FAILURE() << ToString(c.point) << " " << ToString(c.planes[0]);
      }
    }
  });
  EXPECT_EQ(differences, 0u);
  // Multisets of up to three out of 27 points with 6 normals, and out of the 54 different rows.
  EXPECT_EQ(relations, 1u + 162 + 162 * 163 / 2 + 162 * 163 * 164 / 6);
  EXPECT_EQ(expected.size(), 1u + 54 + 54 * 55 / 2 + 54 * 55 * 56 / 6);
}

TEST_F(MotionDofWorld, TheSmallestTypeTwoIsAPairOfOpposedContactsOnTwoLines) {
  ForEach(2, [&](const ContactRelation& relation, const std::vector<int>&) {
    const std::vector<Contact>& c = relation.contacts;
    const bool opposed_on_two_lines = c.size() == 2 && c[0].planes[0] == -c[1].planes[0] &&
                                      !Cross(c[0].point - c[1].point, c[0].planes[0]).IsZero();
    EXPECT_EQ(ComputeMotionDof(relation).rotation.detaching_type2, opposed_on_two_lines ? 1 : 0);
  });
}

}  // namespace
}  // namespace tact::algebra
