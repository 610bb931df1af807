/// @file
/// Table relations with noise, drawn from a seed.
/// Model   the noise of [thesis, 4.5.2]: R <- exp(w) R and p <- p + d, |w| uniform in [0, 5 degrees], |d| in [0, 10 mm].
/// Units   millimetre, radian.
#pragma once

#include <string>

#include "robot/correction/correct.h"
#include "robot/correction/table_relations.h"
#include "robot/perception/random_numbers.h"

namespace tact::correction {

struct TableCase {
  explicit TableCase(const std::string& name)
      : table(TableRelationNamed(name)),
        models(ModelsOf(table.moving, table.fixed)),
        relation(RelationOf(table)) {}
  TableRelation table;
  Models models;
  Relation relation;
};

inline Eigen::Vector3d AnyDirection(perception::RandomNumbers& random) {
  for (;;) {
    const Eigen::Vector3d v = random.InBall();
    if (v.norm() > 1e-3) return v.normalized();
  }
}

inline joint::Transform Noisy(const joint::Transform& X, perception::RandomNumbers& random,
                              double times = 1) {
  const Eigen::Vector3d w = times * 5 * M_PI / 180 * random.Uniform() * AnyDirection(random);
  const Eigen::Vector3d d = times * 10 * random.Uniform() * AnyDirection(random);
  return {joint::RotationExp(w) * X.R, X.p + d};
}

}  // namespace tact::correction
