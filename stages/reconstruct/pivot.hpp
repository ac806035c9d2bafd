#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::reconstruct {

/// Where a joint centre is thought to be, in both of its bodies, before they move.
struct PivotPrior {
  Vec3 in_a, in_b;
  double sd_m = 0;  ///< standard deviation of each from the truth
};

struct Pivot {
  Vec3 in_a, in_b;
  double residual_m = 0;  ///< rms distance between the two while the bodies move
  double doubt_m = 0;     ///< standard deviation along the direction that is known least
};

/// The point that two moving bodies a and b share (symmetrical centre of rotation, Ehrig et al.
/// 2006): minimises over c_a, c_b, with world poses (R, t) and the prior p,
///   mean_i |R_a c_a + t_a - R_b c_b - t_b|^2 + (residual / sd)^2 (|c_a - p_a|^2 + |c_b - p_b|^2).
/// The weight follows the residual that it leads to (skin and noise, taken as one and the same
/// error in all frames), so that the motion decides where it can: along the axis of a hinge, which
/// no motion tells, the point stays near the prior. NaN if no frame shows both bodies.
Pivot find_pivot(const std::vector<Pose>& world_from_a, const std::vector<Pose>& world_from_b,
                 const PivotPrior& prior);

}  // namespace morphe::reconstruct
