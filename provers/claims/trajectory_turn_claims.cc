#include "provers/claims/identity_trial.h"
#include "provers/claims/trajectory_claims.h"

namespace tact::provers {
namespace {

using algebra::Rational;
using algebra::Vector3;

bool SameTurn(const Quaternion& a, const Quaternion& b) { return a.Turn() == b.Turn(); }

Quaternion About(int axis, const Rational& w, const Rational& v) {
  Quaternion q{w, {}};
  q.v[axis] = v;
  return q;
}

// All pairs (w, v) of a turn about a fixed axis.
template <typename Visit>
void ForEachHalfAngle(int largest, const Visit& visit) {
  for (int w = -largest; w <= largest; ++w) {
    for (int v = -largest; v <= largest; ++v) {
      if (w != 0 || v != 0) visit(Rational(w), Rational(v));
    }
  }
}

IdentityTrial LeastTranslationTrial() {
  return {
      "thesis.A.3.1.least-translation",
      "Of all straight lines to where C_e holds, the one across T_e (A.10) is the shortest.",
      "A.3.1, Equation (A.10)",
      "With the orientation fixed, the locations where C_e holds are t_e + T_e. If d is across T_e, another "
      "line is d + l "
      "with l in T_e, and |d + l|^2 = |d|^2 + |l|^2. The thesis says less, that the choice tends to minimize "
      "translation. It does minimize it, and no case distinction is needed: d is the solution of F_e d = "
      "-gaps of least length.",
      [] {
        Tried tried;
        for (const Quaternion& q : Quaternions(1)) {
          const Vector3 d{q.w, q.v.x, q.v.y}, e{q.v.z, 1, 2}, l = Cross(d, e), sum = d + l;
          tried.Add(Dot(sum, sum) == Dot(d, d) + Dot(l, l));
        }
        return tried;
      },
      {{"d1*l1 + d2*l2 + d3*l3"},
       {{"(d1+l1)^2 + (d2+l2)^2 + (d3+l3)^2", "d1^2+d2^2+d3^2 + l1^2+l2^2+l3^2", {"2"}}}}};
}

IdentityTrial OneAxisTrial() {
  return {"thesis.A.4.2.case-2",
          "(A.20) always has a solution, and its turn R(m, alpha) is the smallest that leads from Theta_s to "
          "an orientation R_z(beta) Theta_e.",
          "A.4.2, Case 2",
          "With (w, x, y, z) the quaternion of Theta_e Theta_s^T in the frame Sigma_a, R_z(beta) of "
          "quaternion (c, 0, 0, s) makes it "
          "one of real part c w - s z, and (c w - s z)^2 + (s w + c z)^2 = (c^2 + s^2)(w^2 + z^2): the turn "
          "is least where s w + c z = 0, "
          "that is with (c, s) = (w, -z), and then the axis has no part along z. Where w = z = 0, every beta "
          "will do: "
          "a half turn is left.",
          [] {
            Tried tried;
            for (const Quaternion& q : Quaternions(2)) {
              const Rational square = q.w * q.w + q.v.z * q.v.z;
              if (square.sign() == 0) continue;
              const Quaternion rest = About(2, q.w, -q.v.z) * q;
              tried.Add(rest.v.z.sign() == 0);
              ForEachHalfAngle(1, [&](const Rational& c, const Rational& s) {
                tried.Add((About(2, c, s) * q).Cosine() <= rest.Cosine());
              });
            }
            return tried;
          },
          {{}, {{"(c*w-s*z)^2 + (s*w+c*z)^2", "(c^2+s^2)*(w^2+z^2)", {}}, {"w*z + (-z)*w", "0", {}}}}};
}

IdentityTrial TwoAxesCorrectedTrial() {
  return {"thesis.A.4.2.case-3-corrected",
          "(A.21) has a solution just when w x = y z, (w, x, y, z) the quaternion of Theta_e Theta_s^T in "
          "Sigma_a; then it is unique "
          "unless w = z = 0.",
          "A.4.2, Case 3, corrected",
          "Forth: the product of (p, 0, q, 0) and (r, 0, 0, s) is (p r, q s, q r, p s). Back: if w x = y z, "
          "then (w^2 + z^2) (w, x, y, z) "
          "is the product of (w^2 + z^2, 0, y w + x z, 0) and (w, 0, 0, z). In general, D = R(l, beta') R(r, "
          "alpha) needs l . r = l . (D r), "
          "and the first angle is the one from r to D r about l.",
          [] {
            Tried tried;
            for (const Quaternion& q : Quaternions(2)) {
              const Rational square = q.w * q.w + q.v.z * q.v.z;
              if (square.sign() == 0 || q.w * q.v.x != q.v.y * q.v.z) continue;
              tried.Add(SameTurn(About(1, square, q.v.y * q.w + q.v.x * q.v.z) * About(2, q.w, q.v.z), q));
            }
            return tried;
          },
          {{"w*x - y*z"},
           {{"(p*r)*(q*s)", "(q*r)*(p*s)", {"0"}},
            {"(w^2+z^2)*w", "w*(w^2+z^2)", {"0"}},
            {"(w^2+z^2)*x", "(y*w+x*z)*z", {"w"}},
            {"(w^2+z^2)*y", "(y*w+x*z)*w", {"-z"}},
            {"(w^2+z^2)*z", "(w^2+z^2)*z", {"0"}}}}};
}

IdentityTrial OverApproximationTrial() {
  return {"thesis.A.6.1.only-two-axes",
          "In an edge-face contact a turn about an axis in the span of the edge l and the normal n maintains "
          "the contact only if the axis is l "
          "or n, though every such axis does to first order.",
          "A.6.1",
          "Let l be x and n be z. The turn of quaternion (w, a, 0, b) takes n . l from 0 to 2 (x z - w y) / "
          "norm = 2 a b / norm: zero just if a or b "
          "is. With a unit axis (cos t, 0, sin t) and angle theta it is sin t cos t (1 - cos theta): the "
          "edge of 6 mm of our peg, turned by 10 "
          "degrees about the axis at 45 degrees, leaves the plane by 0.046 mm; by 90 degrees, by 3 mm. The "
          "same holds for a face-edge contact, where "
          "l . n goes to 2 (x z + w y) / norm.",
          [] {
            Tried tried;
            for (const Quaternion& q : Quaternions(2)) {
              if (q.v.y.sign() != 0) continue;
              const Rational off = Dot(Vector3{0, 0, 1}, q.Turn() * Vector3{1, 0, 0}),
                             face_edge = Dot(Vector3{1, 0, 0}, q.Turn() * Vector3{0, 0, 1});
              const Rational expected = Rational(2) * q.v.x * q.v.z / q.Norm();
              tried.Add(off == expected && face_edge == expected);
            }
            return tried;
          },
          {{"y"}, {{"2*(x*z-w*y)", "2*x*z", {"-2*w"}}, {"2*(x*z+w*y)", "2*x*z", {"2*w"}}}}};
}

IdentityTrial OrderTrial() {
  return {"thesis.A.6.1.order",
          "R(n, alpha) R(l, beta) maintains an edge-face contact (A.24), R(l, alpha) R(n, beta) a face-edge "
          "contact (A.25), n and l the axes "
          "at first.",
          "A.6.1, Equations (A.24) and (A.25)",
          "Let l be x and n be z. (c, 0, 0, s)(p, q, 0, 0) = (c p, c q, s q, s p), and x z - w y = c q s p - "
          "c p s q = 0: the edge stays across n. "
          "(p, q, 0, 0)(c, 0, 0, s) = (p c, q c, -q s, p s), and x z + w y = 0: the face's normal stays "
          "across l. The other way "
          "round neither holds: x z - w y = 2 p q c s. The order of the two axes does not matter if they are "
          "carried along: "
          "R(n, a) R(l, b) = R(R(n, a) l, b) R(n, a).",
          [] {
            Tried tried;
            ForEachHalfAngle(2, [&](const Rational& c, const Rational& s) {
              ForEachHalfAngle(2, [&](const Rational& p, const Rational& q) {
                const Quaternion n = About(2, c, s), l = About(0, p, q);
                tried.Add(((n * l).Turn() * Vector3{1, 0, 0}).z.sign() == 0);
                tried.Add(((l * n).Turn() * Vector3{0, 0, 1}).x.sign() == 0);
                const bool trivial = (c * s * p * q).sign() == 0;
                tried.Add((((l * n).Turn() * Vector3{1, 0, 0}).z.sign() == 0) == trivial);
              });
            });
            return tried;
          },
          {{},
           {{"(c*q)*(s*p) - (c*p)*(s*q)", "0", {}},
            {"(q*c)*(p*s) + (p*c)*(-q*s)", "0", {}},
            {"(q*c)*(p*s) - (p*c)*(-q*s)", "2*p*q*c*s", {}}}}};
}

IdentityTrial UnsharedTrial() {
  return {"thesis.A.6.2.surface-normal",
          "With a_1 the edge's direction at the end and a_2 the surface normal, (A.21) has a solution "
          "whenever the edge lies in the plane "
          "at both ends.",
          "A.6.2",
          "(A.21) needs a_1 . a_2 = a_1 . (D a_2), D = Theta_e Theta_s^T. The edge at the start is l across "
          "n = a_2, at the end a_1 = D l, across n: the "
          "left side is zero, and the right one (D l) . (D n) = l . n is, too. No turn about the normal "
          "beforehand is needed, as the thesis "
          "says. What it calls practical is what makes it true: with a_1 another direction across n, D = "
          "R(a_1, b) R(n, a) takes the edge "
          "out of the plane unless b is 0 or a half turn. The face-edge contact is the inverse motion's "
          "edge-face contact.",
          [] {
            Tried tried;
            for (const Quaternion& q : Quaternions(2)) {
              for (int i = -1; i <= 1; ++i) {
                const Vector3 l{1, i, 0}, n{0, 0, 1};
                tried.Add(Dot(q.Turn() * l, q.Turn() * n).sign() == 0);
              }
            }
            return tried;
          },
          {{},
           {{"((w^2+x^2-y^2-z^2)*l1 + 2*(x*y-w*z)*l2)*2*(x*z+w*y) + (2*(x*y+w*z)*l1 + "
             "(w^2-x^2+y^2-z^2)*l2)*2*(y*z-w*x) + "
             "(2*(x*z-w*y)*l1 + 2*(y*z+w*x)*l2)*(w^2-x^2-y^2+z^2)",
             "0",
             {}}}}};
}

// What one example refutes: values at which two formulas differ.
struct Refutation {
  std::string id, statement, source, evidence;
  std::function<bool()> shown;  // by turns in exact numbers
  NoIdentity certificate;
};

Claim ToClaim(Refutation refutation) {
  const std::string id = refutation.id, statement = refutation.statement, source = refutation.source;
  return {id, statement, source, "symbolic", [refutation = std::move(refutation)](Effort) {
            Outcome outcome;
            outcome.verdict = refutation.shown() ? Verdict::kRefuted : Verdict::kUndecided;
            outcome.bound = "one example in exact numbers";
            outcome.evidence = refutation.evidence;
            outcome.certificates = {
                NoIdentityCertificate(refutation.id + ".example", refutation.id, refutation.certificate)};
            return outcome;
          }};
}

Refutation TwoAxesRefutation() {
  return {
      "thesis.A.4.2.case-3",
      "(A.21), R_z(alpha) Theta_s = R_y(beta) Theta_e, is always satisfied.",
      "A.4.2, Case 3",
      "Two angles do not make up three dimensions: a product R_y(-beta) R_z(alpha) has w x = y z. A quarter "
      "turn about x, (1, 1, 0, 0), "
      "has w x = 1, y z = 0 and is no such product. Whether the two contact relations leave just such "
      "orientations is another matter: "
      "where the bases can be shared it has to be seen each time; thesis.A.4.2.case-3-corrected says how.",
      [] {
        const Quaternion quarter{1, {1, 0, 0}};
        bool none = true;
        ForEachHalfAngle(3, [&](const Rational& p, const Rational& q) {
          ForEachHalfAngle(3, [&](const Rational& r, const Rational& s) {
            none = none && !SameTurn(About(1, p, q) * About(2, r, s), quarter);
          });
        });
        return none && quarter.w * quarter.v.x != quarter.v.y * quarter.v.z;
      },
      {{{"w", 1}, {"x", 1}, {"y", 0}, {"z", 0}}, {}, "w*x", "y*z"}};
}

Refutation LeastTurnRefutation() {
  return {"thesis.A.4.1.least-turn-case-4",
          "In case 4 the turn by Equation (A.19) is the smallest that leads from Theta_s to an orientation "
          "R(m, beta) Theta_e, m in A_e.",
          "A.4.1, Equation (A.19); A.4.2, Case 4",
          "The thesis says that the optimization tends to minimize the amount of rotation. In case 2 it does "
          "(thesis.A.4.2.case-2), in case 4 it does "
          "not. Let (1, 1, 0, 1) be the quaternion of Theta_e Theta_s^T, z = a_3. The turn about z is (1, 0, "
          "0, 1), a quarter turn. But the "
          "turn (1, -1, 0, 0) about m = a_1 makes of it (2, 0, 1, 1), a turn by 70.5 degrees, for cos^2 of "
          "half the angle is 2/3, not 1/2.",
          [] {
            const Quaternion d{1, {1, 0, 1}}, rest = Quaternion{1, {-1, 0, 0}} * d, about = About(2, 1, 1);
            // about = R(m, beta) d for an axis m across z, and turns by more.
            const Quaternion across = about * Quaternion{d.w, -d.v};
            return across.v.z.sign() == 0 && rest.Cosine() > about.Cosine();
          },
          // cos^2 of half the angles, cross-multiplied: (w^2 + x^2 + y^2) / |q|^2 and w^2 / (w^2 + z^2).
          {{{"w", 1}, {"x", 1}, {"y", 0}, {"z", 1}}, {}, "(w^2+x^2+y^2)*(w^2+z^2)", "w^2*(w^2+x^2+y^2+z^2)"}};
}

Refutation LeastCureRefutation() {
  return {"thesis.A.6.1.least-turn",
          "With Equation (A.24) for R(m, beta) in (A.22), the turn R_z(alpha) is the smallest that brings "
          "the edge into the face's plane.",
          "A.6.1",
          "Its axis is n x l with l the edge at the GIVEN end, so it depends on an end that is one of many. "
          "Let n = z, l = x, so that the axis is "
          "y, and let the edge at the start have the direction (2, 2, 1) / 3. About y it has to turn by "
          "atan(1/2) = 26.6 degrees, about n x (2, 2, 1) "
          "by asin(1/3) = 19.5 degrees. Corrected: take the axis n x (edge at the start); it is (A.19) at "
          "the end that is really reached. "
          "tact plan reports the least angle beside the thesis' one, and Ipopt finds it.",
          [] {
            // Quaternions of turns about y and about (-2, 2, 0) that bring (2, 2, 1) into the plane z = 0: tan of the angle is 1/2 and
            // 1/sqrt(8). sin^2: 1/5 and 1/9.
            const Vector3 u{2, 2, 1}, n{0, 0, 1};
            const Rational about_y = Dot(u, n) * Dot(u, n) / (u.x * u.x + u.z * u.z),
                           least = Dot(u, n) * Dot(u, n) / Dot(u, u);
            return least < about_y;
          },
          {{{"u1", 2}, {"u2", 2}, {"u3", 1}}, {}, "u3^2*(u1^2+u3^2)", "u3^2*(u1^2+u2^2+u3^2)"}};
}

}  // namespace

std::vector<Claim> TrajectoryTurnClaims() {
  return {ToClaim(LeastTranslationTrial()),
          ToClaim(OneAxisTrial()),
          ToClaim(TwoAxesRefutation()),
          ToClaim(TwoAxesCorrectedTrial()),
          ToClaim(LeastTurnRefutation()),
          ToClaim(OverApproximationTrial()),
          ToClaim(OrderTrial()),
          ToClaim(LeastCureRefutation()),
          ToClaim(UnsharedTrial())};
}

}  // namespace tact::provers
