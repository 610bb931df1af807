#include "algebra/contact/singular_edge.h"

namespace tact::algebra {

bool PermitsEdgeMotion(const EdgeRates& rates) {
  const Rational &a = rates.first_end_first_plane, &b = rates.first_end_second_plane;
  const Rational &c = rates.second_end_first_plane, &d = rates.second_end_second_plane;
  if (a.sign() >= 0 && c.sign() >= 0) return true;
  if (b.sign() >= 0 && d.sign() >= 0) return true;
  // Each end needs a plane of its own, another one each. Between them the first plane's product becomes negative
  // after the share a / (a - c) of the way, the second's stops being negative after b / (b - d): not later is safe.
  if (a.sign() >= 0 && d.sign() >= 0) return a * d >= b * c;
  if (b.sign() >= 0 && c.sign() >= 0) return b * c >= a * d;
  return false;
}

}  // namespace tact::algebra
