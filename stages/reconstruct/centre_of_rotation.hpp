#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::reconstruct {

/// A prior estimate of a joint centre in the frames of both of its bodies.
struct CentreOfRotationPrior {
  Vec3 in_a, in_b;  ///< [m]
  double sd_m = 0;  ///< standard deviation of each from the true centre
};

/// An estimated joint centre in the frames of both of its bodies.
struct CentreOfRotation {
  Vec3 in_a, in_b;           ///< [m]
  double residual_m = 0;     ///< RMS distance in the world between in_a and in_b
  double uncertainty_m = 0;  ///< standard deviation along the least certain direction
};

/// Estimates the point shared by two moving bodies a and b (symmetrical centre of rotation, Ehrig
/// et al. 2006). The poses are [frame], equally many. Minimises over c_a, c_b, with world poses
/// (R, t) and the prior p and its sd,
///   mean_i |R_a c_a + t_a - R_b c_b - t_b|^2 + (residual / sd)^2 (|c_a - p_a|^2 + |c_b - p_b|^2).
/// The residual in the weight is that of the result: skin movement and noise are taken for one
/// error that is the same in all frames. The motion thus determines the centre where it can; along
/// the axis of a hinge the point stays near the prior. All is NaN if no frame shows both bodies.
CentreOfRotation estimate_centre_of_rotation(const std::vector<Pose>& world_from_a,
                                             const std::vector<Pose>& world_from_b,
                                             const CentreOfRotationPrior& prior);

}  // namespace morphe::reconstruct
