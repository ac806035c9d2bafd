#pragma once

#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

// Programs write numbers for points that were not seen. These functions make such points unknown
// (NaN), in every reader alike, and add a note with their number.

/// Hides points exactly at the origin.
void hide_points_at_origin(Array2D<Vec3>& position, std::vector<std::string>& notes);

/// Hides points with a number that stands for a missing one in the file's unit of `unit_m` metres:
/// nines (-9999, 999.9) in all three coordinates, or in one of them if no other coordinate of the
/// file is half as large; -1 in all three, if the point was also elsewhere; above 1e9 in any. Then
/// hides points of which only some coordinates are known.
void hide_fillers(double unit_m, Array2D<Vec3>& position, std::vector<std::string>& notes);

}  // namespace morphe::imports
