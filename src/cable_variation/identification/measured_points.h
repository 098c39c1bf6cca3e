#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// Points of a cable's centreline that were measured, in order from its start towards its end.
struct MeasuredShape {
  std::string source;                   ///< a file's path, for messages
  std::size_t cable = 0;                ///< index into Harness::cables
  std::vector<Eigen::Vector3d> points;  ///< [m], world
  DesignValues known;                   ///< variables that were known to be off their nominal values
};

/// Points of a table: the first line names its columns, x, y and z in any order, the unit of each in brackets
/// or behind a low line ("x [mm]", "x_m"; without one metres); a column z that is not there is 0; other
/// columns are left out. Numbers are parted by commas, semicolons or blanks.
/// Throws std::invalid_argument with path, line and what was expected: no such file, a column missing or
/// twice, a unit that is no length, a line of another length, what is no number, fewer than two points or
/// more than 100,000.
std::vector<Eigen::Vector3d> readMeasuredPoints(const std::string& path);

}  // namespace cable_variation
