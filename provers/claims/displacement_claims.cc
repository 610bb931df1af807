#include <array>
#include <utility>

#include "algebra/contact/singular_edge.h"
#include "algebra/screw/vector3.h"
#include "provers/certificate_writer.h"
#include "provers/claims/claims.h"

namespace tact::provers {
namespace {

using algebra::Integer;
using algebra::Rational;
using algebra::Vector3;

// n . (S1 + S0 x P) - (n . S1 + (P x n) . S0) is linear in each of its twelve variables, so it is zero
// everywhere if it is zero on {0, 1}^12.
Outcome TryScrewForm(Effort) {
  Outcome outcome;
  outcome.bound = "all values: a polynomial linear in each of twelve variables that vanishes on {0, 1}^12";
  long long corners = 0, failures = 0;
  for (int bits = 0; bits < 1 << 12; ++bits) {
    std::array<Vector3, 4> v;
    for (int i = 0; i < 12; ++i) v[i / 3][i % 3] = Rational(bits >> i & 1);
    const auto& [n, p, s0, s1] = v;
    ++corners;
    failures += Dot(n, s1 + Cross(s0, p)) == Dot(n, s1) + Dot(Cross(p, n), s0) ? 0 : 1;
  }
  outcome.verdict = failures == 0 ? Verdict::kProved : Verdict::kRefuted;
  outcome.evidence =
      "The velocity of the contacting point P under the screw [S0, S1] is S1 + S0 x P. Its component along a "
      "normal F "
      "equals F . S1 + (P x F) . S0: both sides are linear in each coordinate of F, P, S0 and S1, and they "
      "agree at all "
      "corners of the unit cube, hence everywhere.";
  outcome.no_certificate =
      "An identity, checked at all corners of a cube; no numbers to re-check beyond that.";
  outcome.numbers = {{"corners", corners}, {"failures", failures}};
  return outcome;
}

// The parallel edges lie along y; the fixed one is the rim of a block, its planes are z (the top) and x (the side).
Outcome TrySingularEdges(Effort) {
  const std::string id = "thesis.2.1.singular-edges";
  IllReducedEdge edge;
  edge.first = {0, -1, 0};
  edge.second = {0, 1, 0};
  edge.planes = {{0, 0, 1}, {1, 0, 0}};
  edge.motion = {Integer(-2), Integer(0), Integer(-2), Integer(-1), Integer(0), Integer(-1)};
  Outcome outcome;
  outcome.verdict = Verdict::kRefuted;
  outcome.bound = "one contact primitive, the fewest there can be";
  outcome.certificates = {IllReducedEdgeCertificate(id + ".counterexample", id, edge)};
  outcome.evidence =
      "Two parallel convex edges touch along y from (0, -1, 0) to (0, 1, 0). The separate planes at every "
      "point of the "
      "contact are z and x, and either suffices. The screw S0 = (-2, 0, -2), S1 = (-1, 0, -1) moves the end "
      "at y = -1 by "
      "(-3, 0, 1), out over the plane z, and the end at y = 1 by (1, 0, -3), out over the plane x: legal at "
      "both ends. The "
      "middle moves by (-1, 0, -1), into the block. A union of half-spaces is not convex, so what holds at "
      "both ends need "
      "not hold between them.\n\n"
      "Corrected: the edge may move if one plane through the fixed edge has the whole moving edge on its "
      "legal side, that is, if "
      "n . v >= 0 at both ends for one and the same n between the two separate planes. With a, b the "
      "products of the two "
      "planes with the first end's velocity and c, d with the second's: a, c >= 0, or b, d >= 0, or a d >= b "
      "c where a, d > 0 > b, c, "
      "or b c >= a d where b, c > 0 > a, d: a quadratic condition, which no finite union of linear systems "
      "such as "
      "Equation (2.2) states.\n\n"
      "Where every contacting point has one plane the reduction is right: n is the same all over a face or "
      "edge "
      "contact, n . v(P) is linear in P, and what holds at the corners of the contact region holds between "
      "them. Motion DOFs are not "
      "touched: they leave singular contacts out (2.2.2) or count their planes' ranks (2.6).";
  return outcome;
}

// Whether some point between the ends, at a share s of the way, has both products negative: s must be where the
// first is negative and where the second is, two open half-lines.
bool EntersTheWedge(int a, int b, int c, int d) {
  Rational low(0), high(1);
  bool low_open = false, high_open = false;
  for (const auto& [start, end] : {std::pair{a, c}, std::pair{b, d}}) {
    // start + s (end - start) < 0
    const int slope = end - start;
    if (slope == 0) {
      if (start >= 0) return false;
      continue;
    }
    const Rational root(Integer(-start), Integer(slope));
    if (slope > 0 && root <= high) {
      high = root;
      high_open = true;
    }
    if (slope < 0 && root >= low) {
      low = root;
      low_open = true;
    }
  }
  return low < high || (low == high && !low_open && !high_open);
}

Outcome TryCorrectedSingularEdges(Effort effort) {
  const int largest = effort == Effort::kQuick ? 4 : (effort == Effort::kStandard ? 7 : 12);
  Outcome outcome;
  outcome.bound = "all products of the two planes with the two ends' velocities in -" +
                  std::to_string(largest) + " ... " + std::to_string(largest);
  long long cases = 0, failures = 0, both_ends_legal = 0;
  for (int a = -largest; a <= largest; ++a) {
    for (int b = -largest; b <= largest; ++b) {
      for (int c = -largest; c <= largest; ++c) {
        for (int d = -largest; d <= largest; ++d) {
          ++cases;
          const bool permitted = algebra::PermitsEdgeMotion({a, b, c, d});
          failures += permitted == !EntersTheWedge(a, b, c, d) ? 0 : 1;
          both_ends_legal += !permitted && (a >= 0 || b >= 0) && (c >= 0 || d >= 0) ? 1 : 0;
        }
      }
    }
  }
  outcome.verdict = failures == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  outcome.no_certificate = "The counterexample would be four numbers; see the evidence.";
  outcome.numbers = {
      {"cases", cases}, {"failures", failures}, {"legal at both ends, not between", both_ends_legal}};
  outcome.evidence =
      "The rule is held against its meaning: the points between the ends where the first product is negative "
      "form an interval, so "
      "do those of the second, and the edge is stopped just if the two intervals meet.";
  return outcome;
}

}  // namespace

std::vector<Claim> DisplacementClaims() {
  return {{"thesis.2.1.screw-form",
           "The legal infinitesimal displacement (2.1) reads F . S1 + (P x F) . S0 >= 0 in the screw "
           "representation (2.2).",
           "2.1, Equations (2.1) and (2.2)", "symbolic", TryScrewForm},
          {"thesis.2.1.singular-edges",
           "A parallel edge-edge contact is represented by its end points, each with the union of its "
           "separate planes.",
           "2.1, Equation (2.2), as Hirukawa's reduction to contacting points is read", "symbolic",
           TrySingularEdges},
          {"thesis.2.1.singular-edges-corrected",
           "A parallel edge-edge contact permits a motion just if one plane serves both ends, or each end "
           "has its own and "
           "the products a, b at one end and c, d at the other satisfy a d >= b c.",
           "2.1, Equation (2.2), corrected", "exhaustive", TryCorrectedSingularEdges}};
}

}  // namespace tact::provers
