#pragma once

#include <vector>

#include "core/humanlike/knots.hpp"

namespace morphe::humanlike {

/// Computes metric A, Eq. (5) [m²]: the sum of ‖elbow - s_j‖² over the robot's inner centres s_j,
/// those between shoulder and wrist.
double joint_distance_sum(const Vec3& human_elbow, const std::vector<Vec3>& inner_centres);

/// Computes metric B, Eq. (6) [m²]. Both chains get virtual joints at the union of their knots
/// (knots.hpp). The metric is the sum of the areas of the triangles that connect each inner joint
/// of the human with the robot's joints at the same and at the next knot. It is 0 if the chains
/// coincide.
double triangle_area_sum(const Chain& human, const Chain& robot);

/// Computes metric C, Eqs. (7)–(9) [m³]: the sum of the volumes of two convex hulls, that of the
/// human's shoulder and elbow with the robot's joints up to the elbow's knot, and that of elbow and
/// wrist with the remaining joints. Coplanar points have volume 0. So the metric is 0 in every pose
/// for robots with fewer than two joints in each set besides the shared shoulder, such as the PA10.
double hull_volume_sum(const Chain& human, const Chain& robot);

}  // namespace morphe::humanlike
