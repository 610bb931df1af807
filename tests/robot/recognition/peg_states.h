/// @file
/// The states of the peg insertion among the examples, where geometry is exact.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "robot/input/demonstration.h"
#include "robot/recognition/point_contact.h"
#include "robot/recognition/posed_models.h"

namespace tact::recognition {

using joint::ToTransform;

/// A small motion in the fixed frame, about its origin.
inline joint::Transform Moved(const joint::Transform& X, const Eigen::Matrix<double, 6, 1>& twist) {
  const Eigen::Matrix3d R = joint::RotationExp(twist.head<3>());
  return {R * X.R, R * X.p + twist.tail<3>()};
}

struct PegStates : testing::Test {
  PegStates() {
    const std::string path = std::string(TACT_SOURCE_DIR) + "/examples/peg_in_hole/demonstration.json";
    std::ifstream file(path);
    demonstration = std::get<input::PoseDemonstration>(input::ReadDemonstration(file, path));
    models = LoadModels(demonstration.models);
    moving = ToDouble(models.moving);
    fixed = ToDouble(models.fixed);
  }
  std::vector<PointContact> ContactsIn(const input::NamedPose& state) const {
    return PointContactsOf(ContactsInPose(models, state.pose.pose, state.where),
                           Transform(models.moving, state.pose.pose), models.fixed);
  }
  input::PoseDemonstration demonstration;
  ModelPair models;
  SolidF moving, fixed;
};

}  // namespace tact::recognition
