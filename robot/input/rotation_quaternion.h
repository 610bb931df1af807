/// @file
/// Rotations in doubles: matrices checked, and turned into quaternions.
/// Exact   no.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace tact::input {

using RotationRows = std::array<std::array<double, 3>, 3>;

/// In what, and how far, rows differ from those of a rotation, whose products they may miss by `allowed`; nullopt: they do not.
std::optional<std::string> RotationFault(const RotationRows& rows, double allowed);

/// A multiple of the quaternion w x y z of a rotation's rows, from the largest of its four squares, so that nothing cancels
/// [Shepperd, 1978].
std::array<double, 4> QuaternionOf(const RotationRows& rows);

/// Brings it to length one and returns the length it had: 0 for the zero quaternion, which stays.
double NormaliseQuaternion(std::array<double, 4>* q);

}  // namespace tact::input
