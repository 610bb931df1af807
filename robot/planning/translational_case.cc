#include "robot/planning/translational_case.h"

namespace tact::planning {

using Eigen::Vector3d;

Straight TranslationalCase(const Vector3d& p_s, const Vector3d& p_e, const MotionRows& start,
                           const MotionRows& end) {
  Straight line;
  const Basis& T_e = end.translations;
  switch (end.ranks.translation) {
    case 3:
      line.number = 1;
      line.displacement = p_e - p_s;
      break;
    case 2: {
      line.number = 2;
      const Vector3d& t_r = T_e[0];
      const double u = (p_s - p_e).dot(t_r) / t_r.squaredNorm();
      line.displacement = p_e + u * t_r - p_s;
      break;
    }
    case 1: {
      line.number = 3;
      const Vector3d normal = T_e[0].cross(T_e[1]);
      line.displacement = normal.dot(p_e - p_s) / normal.squaredNorm() * normal;
      break;
    }
    default:
      break;
  }
  const double length = line.displacement.norm();
  if (length > 0) line.off_start = PartOutside(start.translations, line.displacement).norm() / length;
  return line;
}

}  // namespace tact::planning
