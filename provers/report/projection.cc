#include "provers/report/projection.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "algebra/error.h"

namespace tact::provers {
namespace {

using Triple = std::array<double, 3>;

double Dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Triple Cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Triple Unit(const Triple& a) {
  const double length = std::sqrt(Dot(a, a));
  if (!(length > 1e-12)) {  // below this nothing is left of a direction
    throw PreconditionError(
        "Projection: expected a direction toward the viewer that is not zero and not along `up`");
  }
  return {a[0] / length, a[1] / length, a[2] / length};
}

}  // namespace

View AlongAxis(char axis) {
  View view;
  switch (axis) {
    case 'x':
      view.toward_viewer = {1, 0, 0};
      break;
    case 'y':
      view.toward_viewer = {0, -1, 0};
      break;
    case 'z':
      view.toward_viewer = {0, 0, 1};
      view.up = {0, 1, 0};
      break;
    default:
      throw PreconditionError(std::string("AlongAxis: expected 'x', 'y' or 'z', got '") + axis + "'");
  }
  return view;
}

Projection::Projection(const View& view) {
  toward_viewer_ = Unit(view.toward_viewer);
  right_ = Unit(Cross(Unit(view.up), toward_viewer_));
  up_ = Cross(toward_viewer_, right_);
}

ViewPoint Projection::operator()(const algebra::Vector3& v) const { return At(algebra::ToDouble(v)); }

ViewPoint Projection::At(const Triple& point) const {
  return {Dot(right_, point), Dot(up_, point), Dot(toward_viewer_, point)};
}

ViewPoint Projection::Direction(const algebra::Vector3& v) const {
  if (v.IsZero()) throw PreconditionError("Projection: expected a direction that is not zero");
  // The largest entry is brought to one first: exact entries may be too large to square as doubles.
  const algebra::Rational largest = std::max({algebra::Abs(v.x), algebra::Abs(v.y), algebra::Abs(v.z)});
  const ViewPoint p = (*this)(algebra::Rational(1) / largest * v);
  const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
  return {p.x / length, p.y / length, p.z / length};
}

}  // namespace tact::provers
