#pragma once

#include <vector>

#include "stages/import/audit/step_table.hpp"

namespace morphe::imports {

/// Rows in which a point has exactly its position of the row before them, although it moves: it
/// jumps afterwards, or other points move while it, which otherwise is never still, does not.
struct HeldRows {
  std::size_t point = 0;
  std::size_t begin = 0, end = 0;  ///< first row, and the row after the last one
  double size_m = 0;    ///< the step into the row after them, or into them at the end; may be 0
  bool at_end = false;  ///< true if the recording ends with them
};

/// Returns the held rows of all points, in the order of points and rows. Rows at the begin of the
/// recording include the first one.
std::vector<HeldRows> held_rows(const PointStream& stream, const StepTable& steps);

/// Returns how far rows that are held in all points are caught up with, in usual steps for each
/// held row, in the median: 1 if time went on in them, 0 if rows were only written more often. The
/// usual steps are those around; NaN if there are none, as in a recording all of whose rows are
/// written twice.
double catch_up(const PointStream& stream, const std::vector<HeldRows>& held);

/// Rows that are equal to as many rows before them, which did not stand still in between.
struct RepeatedBlock {
  std::size_t begin = 0, end = 0;  ///< first row, and the row after the last one
  std::size_t original = 0;        ///< the row to which the first one is equal
};
/// Returns the blocks of at least kMinBlockRows rows that repeat an earlier block.
std::vector<RepeatedBlock> repeated_blocks(const PointStream& stream);

}  // namespace morphe::imports
