/// @file
/// Identities about turns, tried at exact points and certified as polynomials.
/// Model   A quaternion (w, v) of any size but zero turns by R = FromQuaternion; cleared of its norm n, an entry of R
///         is a polynomial of degree 2. A polynomial of degree at most 2 k in each variable that vanishes on {-k ...
///         k} in each is zero.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algebra/screw/pose.h"
#include "provers/identity_certificate.h"
#include "provers/ledger.h"

namespace tact::provers {

struct Quaternion {
  algebra::Rational w;
  algebra::Vector3 v;

  algebra::Rational Norm() const { return w * w + Dot(v, v); }
  algebra::Rotation Turn() const { return algebra::Rotation::FromQuaternion(w, v.x, v.y, v.z); }
  /// Of the angle it turns by.
  algebra::Rational Cosine() const { return (w * w - Dot(v, v)) / Norm(); }
};
Quaternion operator*(const Quaternion& a, const Quaternion& b);

/// All but the zero one with entries from -largest to largest.
std::vector<Quaternion> Quaternions(int largest);

/// R_BA = R_BJ Rz R_AJ^T with frames from two quaternions, turned by the quaternion (c, 0, 0, s).
algebra::Rotation Turned(const Quaternion& B, const Quaternion& A, int c, int s);

/// What trying an identity at points gave.
struct Tried {
  long long points = 0, failures = 0;

  void Add(bool holds) {
    ++points;
    failures += holds ? 0 : 1;
  }
};

struct IdentityTrial {
  std::string id, statement, source, evidence;
  std::function<Tried()> points;
  Identity identity;
};

/// Proved if it holds at all points.
Claim ToClaim(IdentityTrial trial);

}  // namespace tact::provers
