// Moves from the traced faces (algebra/knot) against moves from classes of corners (provers/check), which share no code: the same
// moves, over whole worlds of P-data.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "provers/check/check.h"
#include "provers/check/knot_moves.h"
#include "provers/claims/knot_world.h"
#include "provers/knot_certificate.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::provers {
namespace {

using check::KnotCode;
using check::KnotMove;
using knot::Move;
using knot::MoveDirection;
using knot::MoveKind;
using knot::PData;
using knot::RopeEnd;

KnotCode CodeOf(const PData& p) { return {p.SigmaRow(), p.AttrRow()}; }

bool Leads(const KnotCode& before, const KnotMove& move, const KnotCode& after) {
  const check::Value nowhere{nullptr};
  try {
    check::ExpectMoveLeads(nowhere, before, move, after);
    return true;
  } catch (const check::Refused&) {
    return false;
  }
}

// Every removal that q admits by its corners, whatever the parameters, and where it leads.
std::vector<std::pair<Move, PData>> RemovalsByCorners(const PData& q) {
  std::vector<std::pair<Move, PData>> found;
  const KnotCode code = CodeOf(q);
  const int n = q.columns();
  const auto offer = [&](const Move& move, const std::string& kind, const std::vector<int>& columns) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const int mate = code.mate(columns[k]);
      if (std::find(columns.begin(), columns.end(), mate) == columns.end()) return;
    }
    const KnotCode rest = check::WithoutColumns(code, columns);
    const KnotMove written{kind,      "remove",      move.segments,
                           move.attr, move.opposite, move.end == RopeEnd::kSelective};
    if (Leads(code, written, rest)) found.emplace_back(move, PData(rest.sigma, rest.attr));
  };
  for (int attr = 1; attr <= 4; ++attr) {
    for (int i = 1; i < n; ++i) {
      offer({MoveKind::kR1, MoveDirection::kRemove, {i, 0, 0}, {}, attr}, "R1", {i, i + 1});
      const Move first{MoveKind::kCross, MoveDirection::kRemove, {i, 0, 0}, RopeEnd::kSelective, attr};
      offer(first, "Cross", {1, i + 1});
      const Move last{MoveKind::kCross, MoveDirection::kRemove, {i, 0, 0}, RopeEnd::kOther, attr};
      offer(last, "Cross", {i, n});
      for (int j = i; j + 3 <= n; ++j) {
        for (const bool opposite : {false, true})
          offer({MoveKind::kR2, MoveDirection::kRemove, {i, j, 0}, {}, attr, opposite}, "R2",
                {i, i + 1, j + 2, j + 3});
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::pair<Move, PData>> Led(const PData& p, MoveDirection direction, int most_crossings) {
  std::vector<std::pair<Move, PData>> led;
  for (const Move& move : AllMoves(p, most_crossings)) {
    if (move.direction == direction) led.emplace_back(move, Apply(p, move));
  }
  return led;
}

TEST(KnotMovesTwin, RemovalsAreThoseOfTheCorners) {
  for (int n = 0; n <= 4; ++n) {
    ForEachPlanarPData(n, [](const PData& q) {
      ASSERT_EQ(Led(q, MoveDirection::kRemove, q.crossings()), RemovalsByCorners(q)) << Show(q);
    });
  }
}

// From below, a face that two darts lie on; from above, every P-data that loses a kink, a lens or an end.
TEST(KnotMovesTwin, AdditionsAreTheInversesOfTheCornersRemovals) {
  std::map<PData, std::set<std::pair<Move, PData>>> from_above;
  for (int n = 1; n <= 4; ++n) {
    ForEachPlanarPData(n, [&](const PData& q) {
      for (const auto& [move, p] : RemovalsByCorners(q)) {
        if (p.crossings() <= 2) from_above[p].emplace(Inverse(move), q);
      }
    });
  }
  for (int n = 0; n <= 2; ++n) {
    ForEachPlanarPData(n, [&](const PData& p) {
      const auto led = Led(p, MoveDirection::kAdd, 4);
      const auto& above = from_above[p];
      ASSERT_TRUE(std::equal(led.begin(), led.end(), above.begin(), above.end())) << Show(p);
    });
  }
}

TEST(KnotMovesTwin, ShiftsAreThoseOfTheCorners) {
  int shifts = 0;
  for (int crossings = 3; crossings <= 4; ++crossings) {
    ForEachPlanarPData(crossings, [&](const PData& p) {
      const KnotCode code = CodeOf(p);
      std::set<std::array<int, 3>> by_faces, by_corners;
      for (const auto& [move, q] : Led(p, MoveDirection::kShift, crossings)) {
        by_faces.insert(move.segments);
        ASSERT_TRUE(Leads(code, {"R3", "shift", move.segments, 0, false, false}, CodeOf(q)));
        ASSERT_TRUE(check::AnyTriangleLeads(code, CodeOf(q)));
        ++shifts;
      }
      for (int a = 2; a <= p.columns(); ++a) {
        for (int b = 2; b <= p.columns(); ++b) {
          for (int c = 2; c <= p.columns(); ++c) {
            const bool heights =
                p.over(a - 1) && p.over(a) && p.over(b - 1) != p.over(b) && !p.over(c - 1) && !p.over(c);
            if (heights && check::BoundsTriangle(code, {a, b, c})) by_corners.insert({a, b, c});
          }
        }
      }
      ASSERT_EQ(by_faces, by_corners) << Show(p);
    });
  }
  EXPECT_GT(shifts, 1000);
}

// What an R3 must give, without saying how: another planar P-data with the same rest, in which the same strands cross with the same
// heights and signs, in exchanged order on each of the three segments.
TEST(KnotMovesTwin, AnR3GivesTheOnlyOtherPDataOfTheSameStrandsAndIntersections) {
  ForEachPlanarPData(3, [](const PData& p) {
    for (const auto& [move, q] : Led(p, MoveDirection::kShift, 3)) {
      int others = 0;
      knot::ForEachPData(3, [&](const PData& r) {
        if (r == p || !IsPlanar(r)) return;
        // The column of `segment` that lies on `other`; 0: none.
        const auto meet = [](const PData& at, int segment, int other) {
          for (const int c : {segment - 1, segment}) {
            if (at.sigma(c) == other - 1 || at.sigma(c) == other) return c;
          }
          return 0;
        };
        for (const int x : move.segments) {
          for (const int y : move.segments) {
            if (x == y) continue;
            const int before = meet(p, x, y), after = meet(r, x, y);
            if (after == 0 || after == before || r.attr(after) != p.attr(before)) return;
          }
        }
        ++others;
        ASSERT_EQ(r, q);
      });
      ASSERT_EQ(others, 1) << Show(p);
    }
  });
}

TEST(KnotMovesTwin, TheWorldHasAsManyPDataAsPublished) {
  // Codes: OEIS A373325; each intersection's heights double them.
  const long long codes[] = {1, 2, 10, 66, 498};
  for (int n = 0; n <= 4; ++n) {
    std::set<PData> seen;
    ForEachPlanarPData(n, [&](const PData& p) { ASSERT_TRUE(IsPlanar(p) && seen.insert(p).second); });
    EXPECT_EQ(static_cast<long long>(seen.size()), codes[n] << n);
  }
}

TEST(KnotMovesTwin, ACertificateOfAnotherMoveOrAnotherEndIsRefused) {
  for (int n = 0; n <= 2; ++n) {
    ForEachPlanarPData(n, [](const PData& p) {
      const auto moves = AllMoves(p, 3);
      const auto accepts = [&](const Move& move, const PData& q) {
        return check::CheckCertificate(KnotMoveCertificate("x", "x", p, move, q).json).accepted;
      };
      for (std::size_t k = 0; k < moves.size(); k += 3) {
        const PData q = Apply(p, moves[k]);
        ASSERT_TRUE(accepts(moves[k], q)) << Show(p);
        const Move& other = moves[(k + 1) % moves.size()];
        ASSERT_EQ(accepts(other, q), Apply(p, other) == q);
      }
    });
  }
}

}  // namespace
}  // namespace tact::provers
