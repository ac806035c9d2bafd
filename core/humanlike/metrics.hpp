#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::humanlike {

/// A kinematic chain in the paper's common base frame, from the shoulder outwards [m]. The human
/// chain is shoulder, elbow, wrist; the robot's chain consists of its joint centres, including
/// shoulder and end.
using Chain = std::vector<Vec3>;

/// Computes metric A, Eq. (5): sum over the robot's inner centres of ‖elbow - s_j‖² [m²]. The sum
/// is stored in files.
double joint_distance_sum(const Vec3& human_elbow, const std::vector<Vec3>& inner_centres);

/// Computes metric B, Eq. (6): both chains get virtual joints at the union of their normalised
/// arc-length knots; the metric is the sum of the areas of the triangles that connect each inner
/// human joint with the corresponding and the next robot joint [m²]. It is zero if the chains
/// coincide.
double triangle_area_sum(const Chain& human, const Chain& robot);

/// Computes metric C, Eqs. (7)–(9): the volumes of the convex hulls of {shoulder, elbow, robot
/// joints up to the elbow's normalised arc length} and {elbow, wrist, the remaining joints} [m³].
/// Coplanar sets have volume 0, so the metric is degenerate (0 for every pose) for robots with
/// fewer than two centres in a set besides the shared shoulder, such as the PA10.
double hull_volume_sum(const Chain& human, const Chain& robot);

}  // namespace morphe::humanlike
