#include "algebra/exact/linear_algebra.h"
#include "provers/claims/identity_trial.h"
#include "provers/claims/joint_claims.h"

namespace tact::provers {
namespace {

using algebra::Rational;
using algebra::Rotation;
using algebra::Vector3;

std::vector<Vector3> Vectors() {
  std::vector<Vector3> all;
  for (int i = 0; i < 27; ++i) all.push_back({i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1});
  return all;
}

const char* kLengthB = "(b1^2+b2^2+b3^2)";
const char* kAlong = "(l1*b1+l2*b2+l3*b3)";
const std::vector<std::string> kUnitAndAcross = {"l1^2+l2^2+l3^2 - 1", "b1^2+b2^2+b3^2 - 1",
                                                 "l1*b1+l2*b2+l3*b3"};
// b . (l x (l x b)), written out.
const char* kTwice =
    "(b1*(l2*(l1*b2-l2*b1)-l3*(l3*b1-l1*b3)) + b2*(l3*(l2*b3-l3*b2)-l1*(l1*b2-l2*b1)) + "
    "b3*(l1*(l3*b1-l1*b3)-l2*(l2*b3-l3*b2)))";

IdentityTrial TracesCorrectedTrial() {
  const std::string B = kLengthB, p = kAlong;
  return {"thesis.4.3.2.traces-corrected",
          "Tr(l_B l_B^T) = 1, Tr([l]x l_B l_B^T) = 0 and Tr([l]x^2 l_B l_B^T) = (l_B . l)^2 - 1 = -1.",
          "4.3.2, before Equation (4.15), corrected",
          "The trace of M b b^T is b . M b. The square that the third line lost in print is there.",
          [] {
            Tried tried;
            for (const Quaternion& q : Quaternions(2)) {
              const Rotation frame = q.Turn().Transpose();
              const Vector3 &l = frame.rows[0], &b = frame.rows[2];
              tried.Add(Dot(b, b) == 1 && Dot(b, Cross(l, b)) == 0 && Dot(b, Cross(l, Cross(l, b))) == -1);
            }
            return tried;
          },
          {kUnitAndAcross,
           {{B, "1", {"0", "1", "0"}},
            {"b1*(l2*b3-l3*b2) + b2*(l3*b1-l1*b3) + b3*(l1*b2-l2*b1)", "0", {"0", "0", "0"}},
            {kTwice, p + "^2 - 1", {"-" + B, "-1", "0"}},
            {p + "^2 - 1", "-1", {"0", "0", p}}}}};
}

IdentityTrial CosineTrial() {
  const std::string B = kLengthB, p = kAlong;
  return {"thesis.4.3.2.cosine",
          "Tr(R(-l, theta) l_B l_B^T) = cos theta for l perpendicular to l_B: (4.16) is the sum of 1 - l_B . "
          "R_i l_A.",
          "4.3.2, Equations (4.13), (4.15) and (4.16)",
          "By (4.14) and the traces, 1 - 0 + (1 - cos theta)(-1). With (4.13) the sum is N - l_B . (sum of "
          "R_i) l_A: largest where l_A and l_B are the first "
          "singular vectors of the sum of the orientations, so this too needs no iteration.",
          [] {
            Tried tried;
            for (const Quaternion& frame : Quaternions(1)) {
              const Rotation axes = frame.Turn().Transpose();
              for (int c = -1; c <= 1; ++c) {
                for (int s = -1; s <= 1; ++s) {
                  const Quaternion turn{c, Rational(s) * axes.rows[0]};
                  if (turn.Norm().sign() == 0) continue;
                  tried.Add(Dot(axes.rows[2], turn.Turn().Transpose() * axes.rows[2]) == turn.Cosine());
                }
              }
            }
            return tried;
          },
          {kUnitAndAcross,
           {{B + " - s*(b1*(l2*b3-l3*b2) + b2*(l3*b1-l1*b3) + b3*(l1*b2-l2*b1)) + (1-c)*" + kTwice,
             "c",
             {"-(1-c)*" + B, "c", "(1-c)*" + p}}}}};
}

IdentityTrial PairTrial() {
  std::vector<std::string> given;  // R l = b, S l = b, R^T R = I
  std::vector<Equation> equations;
  const auto entry = [](const char* name, int i, int k) { return name + std::to_string(10 * i + k); };
  for (const char* name : {"R", "S"}) {
    for (int i = 1; i <= 3; ++i) {
      std::string sum;
      for (int k = 1; k <= 3; ++k) sum += (k > 1 ? " + " : "") + entry(name, i, k) + "*l" + std::to_string(k);
      given.push_back(sum + " - b" + std::to_string(i));
    }
  }
  for (int i = 1; i <= 3; ++i) {
    for (int k = 1; k <= 3; ++k) {
      std::string sum;
      for (int m = 1; m <= 3; ++m) sum += (m > 1 ? " + " : "") + entry("R", m, i) + "*" + entry("R", m, k);
      given.push_back(sum + (i == k ? " - 1" : ""));
    }
  }
  for (int i = 1; i <= 3; ++i) {
    Equation equation{"", "l" + std::to_string(i), std::vector<std::string>(given.size(), "0")};
    for (int m = 1; m <= 3; ++m) {
      std::string image;
      for (int k = 1; k <= 3; ++k)
        image += (k > 1 ? " + " : "") + entry("S", m, k) + "*l" + std::to_string(k);
      equation.left += (m > 1 ? " + " : "") + entry("R", m, i) + "*(" + image + ")";
      equation.cofactors[static_cast<size_t>(m - 1)] = "-" + entry("R", m, i);
      equation.cofactors[static_cast<size_t>(2 + m)] = entry("R", m, i);
      equation.cofactors[static_cast<size_t>(5 + 3 * (i - 1) + m)] = "l" + std::to_string(m);
    }
    equations.push_back(std::move(equation));
  }
  return {
      "thesis.4.5.1.axis-between-two",
      "Without noise, the turn from one orientation of a revolute joint to another leaves l_A where it is.",
      "4.5.1, Equation (4.27)",
      "R_i^T R_j l_A = R_i^T l_B = l_A, for both turn l_A into l_B.",
      [] {
        Tried tried;
        const Vector3 z{0, 0, 1};
        for (const Quaternion& A : Quaternions(1)) {
          for (const Quaternion& B :
               {Quaternion{1, {0, 0, 0}}, Quaternion{1, {2, 0, -1}}, Quaternion{0, {1, 1, 3}}}) {
            const Rotation i = Turned(B, A, 1, 1), j = Turned(B, A, 1, -2);
            const Vector3 l = A.Turn() * z;
            tried.Add(i.Transpose() * (j * l) == l);
          }
        }
        return tried;
      },
      {given, equations}};
}

IdentityTrial RankTrial() {
  std::vector<std::string> given;
  std::vector<Equation> equations;
  for (int i = 1; i <= 3; ++i) {
    std::string image;
    for (int k = 1; k <= 3; ++k)
      image += (k > 1 ? " + " : "") + ("R" + std::to_string(10 * i + k)) + "*l" + std::to_string(k);
    const std::string b = "b" + std::to_string(i);
    given.push_back(image + " - " + b);
    Equation equation{"-(" + image + ") + " + b, "0", {"0", "0", "0"}};
    equation.cofactors[static_cast<size_t>(i - 1)] = "-1";
    equations.push_back(std::move(equation));
  }
  return {"thesis.4.3.2.rank",
          "The matrix of (4.18) is never of full rank: (l_A, l_B) is in its kernel; its rank is 5 if two "
          "corrected orientations differ, else 3.",
          "4.3.2, on Equation (4.18)",
          "The thesis has \"may not be full-rank\". A_i (l_A, l_B) = l_B - R_i l_A = 0 for every pose, so a "
          "centre can always be moved along the axis. "
          "Nothing else is in the kernel of two different turns: (a, b) in it has b = R_i a = R_j a, so "
          "R_i^T R_j leaves a where it is. The rank is worked out "
          "exactly at the points.",
          [] {
            Tried tried;
            const auto rank = [](const std::vector<Rotation>& turns) {
              std::vector<std::vector<Rational>> rows;
              for (const Rotation& R : turns) {
                for (size_t k = 0; k < 3; ++k) {
                  const Vector3& r = R.rows[k];
                  rows.push_back({-r.x, -r.y, -r.z, k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0});
                }
              }
              return Rank(algebra::IntegerMatrix::FromRationalRows(rows, 6));
            };
            const Quaternion B{1, {2, 0, -1}};
            for (const Quaternion& A : Quaternions(1)) {
              const Rotation i = Turned(B, A, 1, 0), j = Turned(B, A, 3, 1), k = Turned(B, A, 1, 1);
              tried.Add(rank({i}) == 3 && rank({i, i}) == 3 && rank({i, j}) == 5 && rank({i, j, k}) == 5);
            }
            return tried;
          },
          {given, equations}};
}

IdentityTrial LeastTurnTrial() {
  return {"thesis.4.6.2.least-turn",
          "The least turn that makes a unit vector a perpendicular to l_B is by |arcsin(l_B . a)|.",
          "4.6.2, Equation (4.37)",
          "First, a turn by theta about v moves no direction by more than theta: a . R a = cos theta + (1 - "
          "cos theta)(v . a)^2 >= cos theta. Second, where it "
          "arrives, a' perpendicular to l, has (a . a')^2 <= 1 - (a . l)^2, for the squares of a's "
          "components along l, a' and across both add up to one. So cos theta "
          "<= sqrt(1 - (a . l)^2); turning a within the plane of a and l attains it.",
          [] {
            Tried tried;
            for (const Quaternion& q : Quaternions(2)) {
              const Rotation R = q.Turn(), columns = R.Transpose();
              for (const Vector3& a : Vectors()) {
                const Rational square = Dot(a, a), along = Dot(q.v, a);
                Rational parts = 0;
                for (const Vector3& column : columns.rows) parts += Dot(a, column) * Dot(a, column);
                tried.Add(parts == square &&
                          q.Norm() * Dot(a, R * a) == q.Norm() * q.Cosine() * square + 2 * along * along);
              }
            }
            return tried;
          },
          {{},
           {{"a1*((w^2+x^2-y^2-z^2)*a1 + 2*(x*y-w*z)*a2 + 2*(x*z+w*y)*a3) + a2*(2*(x*y+w*z)*a1 + "
             "(w^2-x^2+y^2-z^2)*a2 + "
             "2*(y*z-w*x)*a3) + a3*(2*(x*z-w*y)*a1 + 2*(y*z+w*x)*a2 + (w^2-x^2-y^2+z^2)*a3)",
             "(w^2-x^2-y^2-z^2)*(a1^2+a2^2+a3^2) + 2*(x*a1+y*a2+z*a3)^2",
             {}},
            {"((w^2+x^2-y^2-z^2)*a1 + 2*(x*y+w*z)*a2 + 2*(x*z-w*y)*a3)^2 + (2*(x*y-w*z)*a1 + "
             "(w^2-x^2+y^2-z^2)*a2 + "
             "2*(y*z+w*x)*a3)^2 + (2*(x*z+w*y)*a1 + 2*(y*z-w*x)*a2 + (w^2-x^2-y^2+z^2)*a3)^2",
             "(w^2+x^2+y^2+z^2)^2*(a1^2+a2^2+a3^2)",
             {}}}}};
}

}  // namespace

std::vector<Claim> JointAxisClaims() {
  return {ToClaim(TracesCorrectedTrial()), ToClaim(CosineTrial()), ToClaim(RankTrial()), ToClaim(PairTrial()),
          ToClaim(LeastTurnTrial())};
}

}  // namespace tact::provers
