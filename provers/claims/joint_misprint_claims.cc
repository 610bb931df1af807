#include <array>

#include "algebra/screw/vector3.h"
#include "provers/claims/joint_claims.h"
#include "provers/identity_certificate.h"

namespace tact::provers {
namespace {

using algebra::Rational;
using algebra::Vector3;
using Matrix = std::array<Vector3, 3>;

// Refuted by the certificate if the two sides, worked out here, differ.
Outcome Refute(const std::string& id, const std::string& bound, const Rational& left, const Rational& right,
               const NoIdentity& refutation, const std::string& evidence) {
  Outcome outcome;
  outcome.verdict = left == right ? Verdict::kUndecided : Verdict::kRefuted;
  outcome.bound = bound;
  outcome.evidence = evidence;
  if (left == right) return outcome;
  outcome.certificates = {NoIdentityCertificate(id + ".counterexample", id, refutation)};
  return outcome;
}

// A drawer pulled out and pushed back: locations 0, 1, 0 along one axis.
Outcome TryDirection(Effort) {
  const Rational first(0), second(1), third(0);
  const auto unit = [](const Rational& difference) { return difference / Abs(difference); };
  return Refute("thesis.4.2.1.direction", "three poses, the fewest with two steps", unit(second - first),
                unit(third - second),
                {{{"t1", 0}, {"t2", 1}, {"t3", 0}, {"d1", 1}, {"d2", 1}},
                 {"d1^2 - (t2-t1)^2", "d2^2 - (t3-t2)^2"},
                 "(t2-t1)*d2",
                 "(t3-t2)*d1"},
                "A drawer is pulled out by 1 and pushed back. (4.2), asked of both steps, gives l_B = 1 and "
                "l_B = -1.\n\nCorrected: each step is "
                "parallel to l_B, (t_(i+1) - t_i) x l_B = 0. The estimation by principal components (4.7) "
                "needs no more.");
}

// Turns about one axis by 0, 0 and 90 degrees: the slope of (4.6) at the angle 0, where the sum of the angles is least.
Outcome TryLeastAngles(Effort) {
  const std::array<std::array<int, 2>, 3> cos_sin = {{{1, 0}, {1, 0}, {0, 1}}};
  Rational slope = 0;
  for (const auto& [c, s] : cos_sin) slope += s;
  return Refute("thesis.4.2.2.least-angles",
                "three orientations; for two the sum of the angles is least all the way between", slope, 0,
                {{{"s1", 0}, {"s2", 0}, {"s3", 1}, {"c1", 1}, {"c2", 1}, {"c3", 0}},
                 {"s1^2+c1^2-1", "s2^2+c2^2-1", "s3^2+c3^2-1"},
                 "s1+s2+s3",
                 "0"},
                "Of one pose, 1 - cos theta is least when |theta| is, as the text says; of a sum it need not "
                "be. Three orientations: twice the same, once turned by 90 "
                "degrees. The sum of the angles is least at the orientation that occurs twice: any other has "
                "at least 90 degrees in all from one of the two to the third, "
                "and the other's angle besides. There (4.6) falls at the rate sin 0 + sin 0 + sin 90 = 1 "
                "when turned towards the third: its least is at "
                "26.6 degrees (tangent 1/2), the least sum of squared angles at 30.\n\nWhat (4.6) is "
                "instead: thesis.4.2.2.least-angles-corrected.");
}

// Two locations 0 and 2 on a line, mean 1.
Outcome TryCovariance(Effort) {
  const std::array<Rational, 2> t = {0, 2};
  const Rational mean = (t[0] + t[1]) / 2;
  Rational sum = 0, squares = 0;
  for (const Rational& x : t) {
    sum += x - mean;
    squares += (x - mean) * (x - mean);
  }
  return Refute("thesis.4.2.2.covariance", "two locations on a line, the fewest that differ", sum * sum,
                squares,
                {{{"t1", 0}, {"t2", 2}, {"m", 1}}, {"2*m-t1-t2"}, "((t1-m)+(t2-m))^2", "(t1-m)^2+(t2-m)^2"},
                "As printed, (4.7) is (sum of t_i - mean)^T (sum of t_i - mean): with columns t_i a number, "
                "no matrix, and if the sum takes in the mean, it is zero whatever "
                "the data. Locations 0 and 2: zero, where the sum of squares is 2.\n\nCorrected: the sum of "
                "(t_i - mean)(t_i - mean)^T.");
}

// l = x, l_B = z.
Outcome TryTraces(Effort) {
  const Vector3 l{1, 0, 0}, b{0, 0, 1};
  return Refute("thesis.4.3.2.traces", "the axes of one frame", Dot(b, Cross(l, b)),
                Dot(b, l) * Dot(b, l) - 1,
                {{{"l1", 1}, {"l2", 0}, {"l3", 0}, {"b1", 0}, {"b2", 0}, {"b3", 1}},
                 {"l1^2+l2^2+l3^2 - 1", "b1^2+b2^2+b3^2 - 1", "l1*b1+l2*b2+l3*b3"},
                 "b1*(l2*b3-l3*b2) + b2*(l3*b1-l1*b3) + b3*(l1*b2-l2*b1)",
                 "(l1*b1+l2*b2+l3*b3)^2 - 1"},
                "The third of the three lines before (4.15) repeats the left side of the second: Tr([l]x l_B "
                "l_B^T), there zero, is to be -1. With l = x and l_B = z it is "
                "zero.\n\nCorrected: the third line is about [l]x^2 (thesis.4.3.2.traces-corrected); (4.15) "
                "uses it so.");
}

// A quarter turn back, cosine 0 and sine -1: the size of the angle is that of a quarter turn, sine 1.
Outcome TryAngleNorm(Effort) {
  const Rational sine = -1, printed = 1;  // both with cosine 0; an angle in [0, 180] degrees has a sine >= 0
  return Refute("thesis.4.4.1.angle-norm", "four poses, a quarter turn apart", printed, sine,
                {{{"c", 0}, {"s", -1}, {"p", 1}}, {"c^2+s^2-1", "c^2+p^2-1"}, "p", "s"},
                "A screw is turned by 90 degrees a step. The size of the angle, || || in (4.21), is 0, 90, "
                "180 and then 90 again; with multiples of 360 degrees added, the "
                "value nearest to 180 is 90. So by (4.21) and continuity the screw turns back; in truth it "
                "is at 270.\n\nCorrected: theta_i is the angle about the z axis with its sign, "
                "atan2 of the sine and the cosine that Theta_LB^T R_i Theta_LA has in its first column; "
                "continuity settles multiples of 360 degrees. Table 4.4, "
                "over a whole turn, comes out just so.");
}

Matrix Multiply(const Matrix& a, const Matrix& b) {
  Matrix product;
  for (size_t i = 0; i < 3; ++i) product[i] = a[i].x * b[0] + a[i].y * b[1] + a[i].z * b[2];
  return product;
}

struct Angles {
  Rational ca, sa, cb, sb, cg, sg;
};

Matrix Product(const Angles& x) {
  const Matrix z{{{x.ca, -x.sa, 0}, {x.sa, x.ca, 0}, {0, 0, 1}}},
      y{{{x.cb, 0, x.sb}, {0, 1, 0}, {-x.sb, 0, x.cb}}},
      turn_x{{{1, 0, 0}, {0, x.cg, -x.sg}, {0, x.sg, x.cg}}};
  return Multiply(Multiply(z, y), turn_x);
}

Matrix Printed(const Angles& x) {
  return {{{x.ca * x.cb, x.ca * x.sb * x.sg - x.sa * x.cg, x.ca * x.sb * x.cg + x.sa * x.sg},
           {x.sa * x.cb, x.sa * x.sb * x.sg + x.ca * x.cg, x.sa * x.sb * x.cg - x.ca * x.sg},
           {-x.sa, x.cb * x.sg, x.ca * x.cg}}};
}

Matrix Corrected(const Angles& x) {
  Matrix matrix = Printed(x);
  matrix[2] = {-x.sb, x.cb * x.sg, x.cb * x.cg};
  return matrix;
}

Outcome TryRollPitchYaw(Effort) {
  const Angles quarter{0, 1, 1, 0, 1, 0};
  const Matrix printed = Printed(quarter);
  return Refute("thesis.4.5.1.roll-pitch-yaw", "one turn by 90 degrees", Dot(printed[1], printed[2]), 0,
                {{{"ca", 0}, {"sa", 1}, {"cb", 1}, {"sb", 0}, {"cg", 1}, {"sg", 0}},
                 {"ca^2+sa^2-1", "cb^2+sb^2-1", "cg^2+sg^2-1"},
                 "sa*cb*(-sa) + (sa*sb*sg+ca*cg)*cb*sg + (sa*sb*cg-ca*sg)*ca*cg",
                 "0"},
                "The last row is printed as (-sin a, cos b sin c, cos a cos c). At a = 90 degrees, b = c = 0 "
                "the second row is (1, 0, 0) and the last (-1, 0, 0): not "
                "perpendicular, so no rotation.\n\nCorrected: (-sin b, cos b sin c, cos b cos c), "
                "thesis.4.5.1.roll-pitch-yaw-corrected.");
}

// Each entry is linear in each of six variables, so equal everywhere if equal on {0, 1}^6.
Outcome TryRollPitchYawCorrected(Effort) {
  long long corners = 0, failures = 0, printed_failures = 0;
  for (int bits = 0; bits < 64; ++bits) {
    const auto bit = [&](int i) { return Rational(bits >> i & 1); };
    const Angles x{bit(0), bit(1), bit(2), bit(3), bit(4), bit(5)};
    ++corners;
    failures += Product(x) == Corrected(x) ? 0 : 1;
    printed_failures += Product(x) == Printed(x) ? 0 : 1;
  }
  const std::string id = "thesis.4.5.1.roll-pitch-yaw-corrected";
  Outcome outcome;
  outcome.verdict = failures == 0 ? Verdict::kProved : Verdict::kUndecided;
  outcome.bound = "all angles: entries linear in six variables that agree on {0, 1}^6";
  outcome.numbers = {
      {"corners", corners}, {"failures", failures}, {"failures of the printed matrix", printed_failures}};
  outcome.evidence =
      "Rz(a) Ry(b) Rx(c), multiplied out in sines and cosines as free variables, is the printed matrix with "
      "the last row corrected.";
  // Rz times (Ry Rx), entry by entry.
  outcome.certificates = {IdentityCertificate(id + ".identity", id,
                                              {{},
                                               {{"ca*cb - sa*0", "ca*cb", {}},
                                                {"ca*(sb*sg) - sa*cg", "ca*sb*sg - sa*cg", {}},
                                                {"ca*(sb*cg) - sa*(-sg)", "ca*sb*cg + sa*sg", {}},
                                                {"sa*cb + ca*0", "sa*cb", {}},
                                                {"sa*(sb*sg) + ca*cg", "sa*sb*sg + ca*cg", {}},
                                                {"sa*(sb*cg) + ca*(-sg)", "sa*sb*cg - ca*sg", {}},
                                                {"0*cb + 0*0 + 1*(-sb)", "-sb", {}},
                                                {"0*(sb*sg) + 0*cg + 1*(cb*sg)", "cb*sg", {}},
                                                {"0*(sb*cg) + 0*(-sg) + 1*(cb*cg)", "cb*cg", {}}}})};
  return outcome;
}

}  // namespace

std::vector<Claim> JointMisprintClaims() {
  return {{"thesis.4.2.1.direction", "A prismatic joint's direction is every step's, over its length.",
           "4.2.1, Equation (4.2)", "symbolic", TryDirection},
          {"thesis.4.2.2.least-angles",
           "The sum of 1 - cos of the angles (4.6) is least where the sum of the angles is.",
           "4.2.2, before Equation (4.6)", "symbolic", TryLeastAngles},
          {"thesis.4.2.2.covariance", "(4.7) is the covariance matrix of the locations.",
           "4.2.2, Equation (4.7)", "symbolic", TryCovariance},
          {"thesis.4.3.2.traces", "The three traces before (4.15) are as printed.",
           "4.3.2, before Equation (4.15)", "symbolic", TryTraces},
          {"thesis.4.4.1.angle-norm",
           "A screw's angles are the sizes (4.21) of its turns, up to multiples of a turn that continuity "
           "settles.",
           "4.4.1, Equation (4.21)", "symbolic", TryAngleNorm},
          {"thesis.4.5.1.roll-pitch-yaw", "(4.26) is the rotation of roll, pitch and yaw.",
           "4.5.1, Equation (4.26)", "symbolic", TryRollPitchYaw},
          {"thesis.4.5.1.roll-pitch-yaw-corrected",
           "(4.26) with the last row (-sin b, cos b sin c, cos b cos c) is Rz(a) Ry(b) Rx(c).",
           "4.5.1, Equation (4.26), corrected", "symbolic", TryRollPitchYawCorrected}};
}

}  // namespace tact::provers
