#pragma once

#include <vector>

#include "stages/import/audit/step_table.hpp"

namespace morphe::imports {

/// Rows in which a point is away from its course.
struct Excursion {
  std::size_t point = 0;
  std::size_t begin = 0, end = 0;  ///< first row, and the row after the last one
  double size_m = 0;               ///< largest distance from the course
  bool returns = true;             ///< false if the point stays away: end is the last row's
};

/// Returns the excursions of the points of the recorded arm, in the order of points and rows.
/// Excluded are jumps of several points at `body_jump_rows`, and of points that exchange places.
std::vector<Excursion> excursions(const PointStream& stream, const StepTable& steps,
                                  const std::vector<std::size_t>& body_jump_rows);

}  // namespace morphe::imports
