#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::humanlike {

/// Two kinematic chains in the paper's common base frame, from the shoulder outwards [m]. The human
/// chain is shoulder, elbow, wrist; the robot's its joint centres, shoulder and end included.
using Chain = std::vector<Vec3>;

/// Metric A, Eq. (5): sum over the robot's inner centres of ‖elbow - s_j‖² [m²]: the sum, as files
/// hold it.
double joint_distance_sum(const Vec3& human_elbow, const std::vector<Vec3>& inner_centres);

/// Metric B, Eq. (6): both chains get virtual joints at the union of their normalised arc-length
/// knots; sum of the areas of the triangles that join each inner human joint with the corresponding
/// and the next robot joint [m²]. Zero when the chains coincide.
double triangle_area_sum(const Chain& human, const Chain& robot);

/// Metric C, Eqs. (7)–(9): volumes of the convex hulls of {shoulder, elbow, robot joints up to the
/// elbow's normalised arc length} and {elbow, wrist, the rest} [m³]. Coplanar sets have volume 0,
/// so the metric is degenerate (0 whatever the pose) for robots with fewer than two centres in a
/// set beside the shared shoulder, the PA10 among them.
double hull_volume_sum(const Chain& human, const Chain& robot);

/// Volume of the convex hull of points: a determinant for four, Quickhull for more, 0 if flat [m³].
double hull_volume(const std::vector<Vec3>& points);

}  // namespace morphe::humanlike
