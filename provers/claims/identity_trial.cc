#include "provers/claims/identity_trial.h"

namespace tact::provers {

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - Dot(a.v, b.v), a.w * b.v + b.w * a.v + Cross(a.v, b.v)};
}

std::vector<Quaternion> Quaternions(int largest) {
  std::vector<Quaternion> all;
  const int side = 2 * largest + 1;
  for (int i = 0; i < side * side * side * side; ++i) {
    const Quaternion q{
        i % side - largest,
        {i / side % side - largest, i / side / side % side - largest, i / side / side / side - largest}};
    if (q.Norm().sign() != 0) all.push_back(q);
  }
  return all;
}

algebra::Rotation Turned(const Quaternion& B, const Quaternion& A, int c, int s) {
  return B.Turn() * algebra::Rotation::FromQuaternion(c, 0, 0, s) * A.Turn().Transpose();
}

Claim ToClaim(IdentityTrial trial) {
  const std::string id = trial.id, statement = trial.statement, source = trial.source;
  return {id, statement, source, "symbolic", [trial = std::move(trial)](Effort) {
            const Tried tried = trial.points();
            Outcome outcome;
            outcome.verdict = tried.failures == 0 ? Verdict::kProved : Verdict::kUndecided;
            outcome.bound = "all values: polynomials, compared term by term and at exact points";
            outcome.numbers = {{"exact points", tried.points}, {"failures", tried.failures}};
            outcome.certificates = {IdentityCertificate(trial.id + ".identity", trial.id, trial.identity)};
            outcome.evidence = trial.evidence;
            return outcome;
          }};
}

}  // namespace tact::provers
