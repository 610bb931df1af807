/// @file
/// The thesis' rules that read a move off two P-data, literally [thesis, 5.3.1-5.3.4]: on trial in provers/claims/, used nowhere
/// else. move.h has what detects moves soundly and completely.
/// Model   p_t is the P-data with more intersections (R_III: either), p_before the other one; both are read off from one end.
///         Each rule names the segments that it concludes a move of, and nothing else about it.
/// Where the text leaves something open each reading has a name.
#pragma once

#include <array>
#include <compare>
#include <optional>
#include <utility>
#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::knot::thesis {

/// R_I(P_t, i): columns i and i+1 removed, numbers from i+2 on less two. Precondition: sigma(i) = i+1.
PData RemoveR1(const PData& p_t, int i);
/// R_II(P_t, i, j): columns i, i+1, j+2, j+3 removed, numbers from i+2 to j+1 less two, from j+4 on less four.
/// Precondition: i <= j and (5.5) or (5.6).
PData RemoveR2(const PData& p_t, int i, int j);
/// C_s(P_t): columns 1 and i+1 = sigma(1) removed, numbers from 2 to i less one, from i+2 on less two.
PData RemoveCrossAtSelectiveEnd(const PData& p_t);
/// C_e(P_t): columns n and j = sigma(n) removed, numbers from j+1 to n-1 less one.
PData RemoveCrossAtOtherEnd(const PData& p_t);

/// Every i, 1 <= i <= n(P_{t-1}) + 1, with (5.2), (5.3) and R_I(P_t, i) = P_{t-1}.
std::vector<int> FindR1(const PData& p_before, const PData& p_t);

/// Which of the conditions (5.7) stands for, beside (5.4) and (5.5) or (5.6), are asked for.
struct R2Reading {
  bool same_height = true;
  bool signs_differ = true;
  bool equal_segments = false;  // i = j is tried too, against the printed range
};
/// Every i, j, 1 <= i < j <= n(P_{t-1}) + 1, with (5.4), (5.5) or (5.6), (5.7), and R_II(P_t, i, j) = P_{t-1}.
std::vector<std::pair<int, int>> FindR2(const PData& p_before, const PData& p_t,
                                        const R2Reading& reading = {});

/// The segment that the selective end is concluded to cross, if C_s(P_t) = P_{t-1}.
std::optional<int> FindCrossAtSelectiveEnd(const PData& p_before, const PData& p_t);
/// The segment that the other end is concluded to cross, if C_e(P_t) = P_{t-1}.
std::optional<int> FindCrossAtOtherEnd(const PData& p_before, const PData& p_t);

/// The type, 'A' to 'H', of segments i, j, k that meet pairwise in three intersections, of six
/// numbers; nullopt: they do not.
std::optional<char> TypeOf(const PData& p, const std::array<int, 3>& segments);
/// What the type becomes by an R_III [thesis, Proposition 13].
inline char PermittedType(char type) { return static_cast<char>('A' + 'H' - type); }

/// What "compose a triangle" asks for beyond intersections of each two of the segments, and whose heights name the segments.
enum class R3Triangle {
  kNamedBefore,  // A over both others and C under both at time t-1; heights at time t are not looked at
  kNamedTwice,   // at both times
  kFaces,        // at both times, and the three segments bound a face each time
};
struct R3Reading {
  R3Triangle triangle = R3Triangle::kNamedTwice;
  bool same_signs =
      false;  // the sign of each two segments' intersection is kept: the thesis does not ask for it
  bool last_segment = false;  // segment n is tried too, against the printed range 2..n-1
};
/// Whether the rule concludes an R_III among the segments A, B, C. Precondition: segments from 2 to n.
bool AcceptsR3(const PData& p_before, const PData& p_t, const std::array<int, 3>& segments,
               const R3Reading& reading = {});
struct R3Conclusion {
  std::array<int, 3> segments{};  // A, B, C
  char type_before = 'A';

  friend auto operator<=>(const R3Conclusion&, const R3Conclusion&) = default;
};
/// Every i, j, k, 2 <= i, j, k <= n(P_t) - 1, of one triangle before and after, with a permitted transition between their types
/// and R_III(P_t, i, j, k) = R_III(P_{t-1}, i, j, k), the six columns left out, not renumbered. In ascending order.
std::vector<R3Conclusion> FindR3(const PData& p_before, const PData& p_t, const R3Reading& reading = {});

}  // namespace tact::knot::thesis
