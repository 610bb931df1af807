/// @file
/// The header of a table of poses: which column holds what, by name.
/// Model   A name is its words in lower case, [unit] or (unit) apart. time, timestamp, stamp, t: the time. A last word x, y, z or w, alone
///         or after q, quat, orientation, rotation, ..., p, t, pos, position, translation, ...; or tx, px, qx, ...: so the columns
///         of EuRoC (p_RS_R_x [m], q_RS_w []) and of ROS (pose.position.x) are known. Any other column is ignored.
/// Units   a unit in brackets counts: m, cm, mm, in; s, ms, us, ns.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/cad/length_unit.h"

namespace tact::input {

/// Fields of a pose, in the order of a TUM line.
enum LogField : int { kLogTime, kLogX, kLogY, kLogZ, kLogQx, kLogQy, kLogQz, kLogQw };
inline constexpr int kLogFields = 8;

struct LogHeader {
  char separator = ' ';                   // ',', ';' or, for any blanks, ' '
  std::array<int, kLogFields> columns{};  // of each field, from 0; -1: none
  int count = 0;                          // columns in all
  std::optional<cad::LengthUnit> unit;    // of the location, if the header says so
  double seconds = 1;                     // one unit of time
  std::string twice;                      // a field named twice; empty: none

  bool knows_any() const;
  /// The names of the fields that a pose needs and the header lacks.
  std::vector<std::string_view> Missing() const;
};

LogHeader ParseLogHeader(std::string_view line);

}  // namespace tact::input
