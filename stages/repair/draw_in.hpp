#pragma once

#include <random>
#include <vector>

#include "stages/repair/interval_world.hpp"

namespace morphe::repair {

/// Replaces parts of a certified polyline by straight lines while they are certified too. Shorter
/// in shares of the joints' spans; `attempts` pairs of points are tried.
std::vector<JointVector> shortcut(const IntervalWorld& interval, std::vector<JointVector> vertices,
                                  int attempts, std::mt19937_64& random);

/// `count` samples along the polyline, on every vertex and uniform between two of them, each edge
/// with a number that follows its length. Empty if there are more vertices than samples.
JointRows spread(const RobotTable& robot, const std::vector<JointVector>& vertices, int count);

/// Makes the correction d = planned - original small and smooth. It is 0 at both ends and beyond;
///     cost(d) = sum_k |d_k|^2 + L^2 |d_k+1 - d_k|^2 + L^4 |d_k+1 - 2 d_k + d_k-1|^2,  L samples.
/// Each attempt moves a random window, of all joints or some, towards the minimum of the cost
/// with the rest held: the farthest of a few steps that is certified free in `world` at the
/// samples' own times, and inside the joint limits. planned and original [times, joints].
void draw_in(const ClearWorld& world, const std::vector<double>& times, const JointRows& original,
             int attempts, std::mt19937_64& random, JointRows& planned);

}  // namespace morphe::repair
