#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::reconstruct {

/// A prior estimate of a joint centre in both of its bodies.
struct CentreOfRotationPrior {
  /// Estimates in the frames of the two bodies [m].
  Vec3 in_a, in_b;
  double sd_m = 0;  ///< standard deviation of each from the true centre [m]
};

/// An estimated joint centre in both of its bodies.
struct CentreOfRotation {
  /// Positions in the frames of the two bodies [m].
  Vec3 in_a, in_b;
  double residual_m = 0;     ///< rms distance between the two during the motion of the bodies [m]
  double uncertainty_m = 0;  ///< standard deviation along the least certain direction [m]
};

/// Estimates the point shared by two moving bodies a and b (symmetrical centre of rotation, Ehrig
/// et al. 2006). Minimises over c_a, c_b, with world poses (R, t) and the prior p,
///   mean_i |R_a c_a + t_a - R_b c_b - t_b|^2 + (residual / sd)^2 (|c_a - p_a|^2 + |c_b - p_b|^2).
/// The weight is consistent with the resulting residual (skin movement and noise, treated as one
/// and the same error in all frames), so that the motion determines the centre if it can; along the
/// axis of a hinge, where motion gives no information, the point stays near the prior. NaN if no
/// frame shows both bodies.
CentreOfRotation estimate_centre_of_rotation(const std::vector<Pose>& world_from_a,
                                             const std::vector<Pose>& world_from_b,
                                             const CentreOfRotationPrior& prior);

}  // namespace morphe::reconstruct
