#pragma once

#include <random>
#include <vector>

#include "stages/repair/interval_world.hpp"

namespace morphe::repair {

/// Shortens a certified polyline by shortcuts: straight lines that are certified replace parts of
/// it. Lengths are measured in shares of the joints' spans; `attempts` pairs of points are tried.
std::vector<JointVector> shortcut(const IntervalWorld& interval, std::vector<JointVector> vertices,
                                  int attempts, std::mt19937_64& random);

/// Returns `count` samples along the polyline, one on every vertex and the others uniform within
/// each edge, their number proportional to its length. Returns an empty matrix if there are more
/// vertices than samples.
JointRows resample(const RobotModel& robot, const std::vector<JointVector>& vertices, int count);

/// Makes the correction d = planned - original small and smooth. It is 0 at both ends and beyond;
///     cost(d) = sum_k |d_k|^2 + L^2 |d_k+1 - d_k|^2 + L^4 |d_k+1 - 2 d_k + d_k-1|^2,  L samples.
/// Each attempt moves a random window, of all joints or some, towards the minimum of the cost with
/// the rest fixed, by the largest of a few steps that is certified to be free in `world` at the
/// samples' own times and inside the joint limits. planned and original [times, joints].
void pull_towards_original(const PaddedWorld& world, const std::vector<double>& times,
                           const JointRows& original, int attempts, std::mt19937_64& random,
                           JointRows& planned);

}  // namespace morphe::repair
