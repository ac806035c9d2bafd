#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

bool never_seen(const std::vector<Vec3>& points);

/// Unseen points become the straight line between the seen ones on either side, before the first
/// and after the last of them a copy; all stay unseen if none is seen.
void interpolate_unseen(std::vector<Vec3>& points);

/// Says how much of a marker was hidden and what became of it: `filled` is `recorded` after others
/// of its body carried it; what is then still hidden is bridged by the spline in gaps up to
/// max_gap_s. Nothing if it was seen throughout.
void note_gaps(const std::string& name, const std::vector<double>& time,
               const std::vector<Vec3>& recorded, const std::vector<Vec3>& filled, double max_gap_s,
               std::vector<std::string>& problems);

/// Says in how many frames of the clock a point is not seen, if any.
void note_unseen(const std::string& name, const std::vector<Vec3>& points,
                 std::vector<std::string>& problems);

/// Of the finite ones among the distances; NaN if there is none.
Residual residual_of(const std::string& name, const std::vector<double>& distances);

}  // namespace morphe::reconstruct
