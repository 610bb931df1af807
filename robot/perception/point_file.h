/// @file
/// Scans as text: a point a line, `x y z`, separated by blanks.
/// Model   further columns (normals, colours, intensities) are left out; every line has as many numbers as the first.
/// Units   those of the file.
/// Errors  InputError: "file:line: expected ..., got ...".
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace tact::perception {

/// The points in a file's contents; name stands for the file in errors.
std::vector<Eigen::Vector3d> ReadPoints(std::string_view contents, const std::string& name);

/// The points in a file.
std::vector<Eigen::Vector3d> ReadPointFile(const std::string& path);

}  // namespace tact::perception
