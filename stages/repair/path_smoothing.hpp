#pragma once

#include <random>
#include <vector>

#include "stages/repair/interval_world.hpp"

namespace morphe::repair {

/// Returns a certified polyline of which parts are replaced by certified straight lines. The first
/// of `attempts` tries the line from end to end, the others lines between two random points.
std::vector<JointVector> shortcut(const IntervalWorld& interval, std::vector<JointVector> vertices,
                                  int attempts, std::mt19937_64& random);

/// Returns `count` samples of a polyline: one on every vertex, the others where steps are longest.
/// Returns no rows if there are more vertices than samples, or fewer than two.
JointRows resample(const RobotModel& robot, const std::vector<JointVector>& vertices, int count);

/// Makes the correction d = planned - original small and smooth; both are [times, joints]. With
/// d = 0 at both ends and beyond, and L a number of samples, it reduces
///     cost(d) = sum_k |d_k|^2 + L^2 |d_k+1 - d_k|^2 + L^4 |d_k+1 - 2 d_k + d_k-1|^2.
/// Each attempt moves all, some or one of the joints in a random window towards the minimum of the
/// cost with all else fixed. The step is the first of kPullShares that stays inside the limits and
/// is certified to be free at `times`, the samples' demonstration times [s].
void pull_towards_original(const PaddedWorld& world, const std::vector<double>& times,
                           const JointRows& original, int attempts, std::mt19937_64& random,
                           JointRows& planned);

}  // namespace morphe::repair
