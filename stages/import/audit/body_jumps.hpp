#pragma once

#include <vector>

#include "stages/import/audit/step_table.hpp"

namespace morphe::imports {

/// A row at which all points that move jump at once, and from which on they stay away.
struct BodyJump {
  std::size_t row = 0;
  double size_m = 0;  ///< of the largest jump
  /// Number of rows in which the points would have covered the jump at their speeds around it; NaN
  /// if they do not jump in the directions in which they move.
  double rows_lost = 0;
};

/// Returns the rows at which the points of a stream jump together.
std::vector<BodyJump> body_jumps(const PointStream& stream, const StepTable& steps);

}  // namespace morphe::imports
