#include "provers/claims/identity_trial.h"
#include "provers/claims/joint_claims.h"

namespace tact::provers {
namespace {

using algebra::Rational;
using algebra::Rotation;
using algebra::Vector3;

Rational Trace(const Rotation& R) { return R.rows[0].x + R.rows[1].y + R.rows[2].z; }

IdentityTrial TraceTrial() {
  return {"thesis.4.2.2.trace",
          "The trace of a turn by theta is 1 + 2 cos theta, so 1 - cos theta is half of 3 less the trace.",
          "4.2.2, Equations (4.5) and (4.6)",
          "A quaternion (w, v) of any size turns by theta with cos theta = (w^2 - |v|^2) / (w^2 + |v|^2). "
          "Cleared of the denominator both "
          "sides are polynomials of degree 2.",
          [] {
            Tried tried;
            for (const Quaternion& q : Quaternions(1)) tried.Add(Trace(q.Turn()) == 1 + 2 * q.Cosine());
            return tried;
          },
          {{},
           {{"(w^2+x^2-y^2-z^2) + (w^2-x^2+y^2-z^2) + (w^2-x^2-y^2+z^2)",
             "(w^2+x^2+y^2+z^2) + 2*(w^2-x^2-y^2-z^2)",
             {}}}}};
}

IdentityTrial ChordTrial() {
  return {
      "thesis.4.2.2.least-angles-corrected",
      "(4.6) is a quarter of the sum of squared distances |R_i - R|^2 between the matrices: it is least at "
      "the rotation nearest to the mean "
      "of the R_i.",
      "4.2.2, Equation (4.6), corrected",
      "|R_i - R|^2, summed over the nine entries, is 4 (1 - cos theta_i). So the rotation sought is the one "
      "nearest to the sum of the "
      "R_i, which a singular value decomposition gives at once: there is nothing to iterate and no initial "
      "guess.",
      [] {
        Tried tried;
        for (const Quaternion& q : Quaternions(2)) {
          const Rotation R = q.Turn(), I;
          Rational squares = 0;
          for (size_t i = 0; i < 3; ++i) squares += Dot(R.rows[i] - I.rows[i], R.rows[i] - I.rows[i]);
          tried.Add(squares == 4 * (1 - q.Cosine()));
        }
        return tried;
      },
      {{},
       {{"4*(y^2+z^2)^2 + 4*(x^2+z^2)^2 + 4*(x^2+y^2)^2 + 4*(x*y-w*z)^2 + 4*(x*y+w*z)^2 + 4*(x*z-w*y)^2 + "
         "4*(x*z+w*y)^2 + 4*(y*z-w*x)^2 + 4*(y*z+w*x)^2",
         "8*(w^2+x^2+y^2+z^2)*(x^2+y^2+z^2)",
         {}}}}};
}

IdentityTrial SplitTrial() {
  return {"thesis.4.3.2.two-turns",
          "Every turn is one about l_B after one about an axis perpendicular to l_B.",
          "4.3.2, Equation (4.11)",
          "With z along l_B, the quaternion (w, x, y, z) times w^2 + z^2 is the product of (w, 0, 0, z), a "
          "turn about l_B, and (w^2 + z^2, "
          "w x + y z, w y - x z, 0). Where w = z = 0, it is a half turn about a perpendicular axis itself.",
          [] {
            Tried tried;
            for (const Quaternion& q : Quaternions(2)) {
              const Rational square = q.w * q.w + q.v.z * q.v.z;
              if (square.sign() == 0) continue;
              const Quaternion about{q.w, {0, 0, q.v.z}},
                  across{square, {q.w * q.v.x + q.v.y * q.v.z, q.w * q.v.y - q.v.x * q.v.z, 0}};
              tried.Add(about.Turn() * across.Turn() == q.Turn());
            }
            return tried;
          },
          {{},
           {{"w*(w^2+z^2)", "(w^2+z^2)*w", {}},
            {"w*(w*x+y*z) - z*(w*y-x*z)", "(w^2+z^2)*x", {}},
            {"w*(w*y-x*z) + z*(w*x+y*z)", "(w^2+z^2)*y", {}},
            {"z*(w^2+z^2)", "(w^2+z^2)*z", {}}}}};
}

IdentityTrial NoTurnAboutAxisTrial() {
  return {
      "thesis.4.3.2.no-turn-about-the-axis",
      "Of the corrections (4.11) with one turn theta_2 across the axis, that with theta_1 = 0 turns least.",
      "4.3.2, on Equation (4.12)",
      "A turn about l_B leaves l_B where it is (4.12), so theta_1 is free. The real part of the product of "
      "the two quaternions gives cos(theta / 2) = "
      "cos(theta_1 / 2) cos(theta_2 / 2), for their axes are perpendicular: theta is least, theta_2, just at "
      "theta_1 = 0.",
      [] {
        Tried tried;
        for (int i = 0; i < 243; ++i) {
          const Quaternion about{i % 3 - 1, {0, 0, i / 3 % 3 - 1}},
              across{i / 9 % 3 - 1, {i / 27 % 3 - 1, i / 81 - 1, 0}};
          const Vector3 l{0, 0, 1};
          if (about.Norm().sign() == 0 || across.Norm().sign() == 0) continue;
          const Quaternion product = about * across;
          tried.Add(about.Turn() * l == l && (about.Turn() * across.Turn()) == product.Turn() &&
                    product.w == about.w * across.w && product.Norm() == about.Norm() * across.Norm());
        }
        return tried;
      },
      {{"l1*m1 + l2*m2 + l3*m3"},
       {{"c1*c2 - (s1*l1*s2*m1 + s1*l2*s2*m2 + s1*l3*s2*m3)", "c1*c2", {"-s1*s2"}}}}};
}

IdentityTrial SkewFormTrial() {
  return {"thesis.4.3.2.skew-form",
          "The turn about -l by theta is I - sin theta [l]x + (1 - cos theta) [l]x^2.",
          "4.3.2, Equation (4.14)",
          "With the quaternion (w, v), sin theta l = 2 w v / n and (1 - cos theta) [l]x^2 = 2 [v]x^2 / n, n "
          "= w^2 + |v|^2. All nine entries agree.",
          [] {
            Tried tried;
            for (const Quaternion& q : Quaternions(1)) {
              const Rotation back = q.Turn().Transpose();
              const Rational two_over_n = Rational(2) / q.Norm();
              for (const Vector3& a : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
                const Vector3 once = Cross(q.v, a), twice = Cross(q.v, once);
                tried.Add(back * a == a - (two_over_n * q.w) * once + two_over_n * twice);
              }
            }
            return tried;
          },
          {{},
           {{"w^2+x^2-y^2-z^2", "(w^2+x^2+y^2+z^2) - 2*(y^2+z^2)", {}},
            {"2*(x*y+w*z)", "-2*w*(-z) + 2*x*y", {}},
            {"2*(x*z-w*y)", "-2*w*y + 2*x*z", {}},
            {"2*(x*y-w*z)", "-2*w*z + 2*x*y", {}},
            {"w^2-x^2+y^2-z^2", "(w^2+x^2+y^2+z^2) - 2*(x^2+z^2)", {}},
            {"2*(y*z+w*x)", "-2*w*(-x) + 2*y*z", {}},
            {"2*(x*z+w*y)", "-2*w*(-y) + 2*x*z", {}},
            {"2*(y*z-w*x)", "-2*w*x + 2*y*z", {}},
            {"w^2-x^2-y^2+z^2", "(w^2+x^2+y^2+z^2) - 2*(x^2+y^2)", {}}}}};
}

}  // namespace

std::vector<Claim> JointTurnClaims() {
  return {ToClaim(TraceTrial()), ToClaim(ChordTrial()), ToClaim(SplitTrial()),
          ToClaim(NoTurnAboutAxisTrial()), ToClaim(SkewFormTrial())};
}

}  // namespace tact::provers
