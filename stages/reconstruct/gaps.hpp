#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// Returns true if all points are unseen.
bool never_seen(const std::vector<Vec3>& points);

/// Interpolates unseen points linearly between the seen ones on either side; before the first and
/// after the last seen point they are copies of it. All stay unseen if no point is seen.
void interpolate_unseen(std::vector<Vec3>& points);

/// Adds a note on the gaps of a marker and their treatment: `filled` is `recorded` after filling
/// from the other markers of its body; remaining gaps of up to max_gap_s are bridged by the spline.
/// Adds no note if it was always seen.
void note_gaps(const std::string& name, const std::vector<double>& time,
               const std::vector<Vec3>& recorded, const std::vector<Vec3>& filled, double max_gap_s,
               std::vector<std::string>& problems);

/// Adds a note on the number of frames of the clock in which a point is not seen, if any.
void note_unseen(const std::string& name, const std::vector<Vec3>& points,
                 std::vector<std::string>& problems);

/// Returns the residual of the finite distances; NaN if there is no finite distance.
Residual residual_of(const std::string& name, const std::vector<double>& distances);

}  // namespace morphe::reconstruct
