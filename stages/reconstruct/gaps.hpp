#pragma once

#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::reconstruct {

/// Returns true if all points are unseen.
bool never_seen(const std::vector<Vec3>& points);

/// Replaces unseen points: linearly between the seen ones on either side, by copies before the
/// first and after the last seen one. Leaves the points as they are if all are unseen.
void interpolate_unseen(std::vector<Vec3>& points);

/// Adds a note on the gaps of a marker and their treatment to `problems`, if it has gaps. `filled`
/// is `recorded` after filling from the other markers of its body; of the gaps that remain, those
/// between seen points and of at most max_gap_s are counted as interpolated. All have the size of
/// `time`.
void note_gaps(const std::string& name, const std::vector<double>& time,
               const std::vector<Vec3>& recorded, const std::vector<Vec3>& filled, double max_gap_s,
               std::vector<std::string>& problems);

/// Adds a note on the number of frames in which a point is unseen to `problems`, unless it is 0.
void note_unseen(const std::string& name, const std::vector<Vec3>& points,
                 std::vector<std::string>& problems);

}  // namespace morphe::reconstruct
