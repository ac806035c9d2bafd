#pragma once

#include <vector>

#include "core/collision/distance.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/grasp/grasp_options.hpp"

namespace morphe::grasp {

/// A contact that a pad is to make with the target, in the target's frame.
struct DesiredContact {
  /// Index of the robot's tip.
  std::size_t tip = 0;
  ContactOrigin origin = ContactOrigin::demonstrated;  ///< demonstrated or closed
  Vec3 point = Vec3::Zero();                           ///< contact point on the surface [m]
  Vec3 normal = Vec3::UnitZ();                         ///< unit inward normal
  Vec3 centre = Vec3::Zero();  ///< centre of the pad's sphere at contact [m]
  double confidence = 1;       ///< confidence that the person touched at this point
};

/// The point of a solid's surface nearest to a query point and the inward normal there, both in the
/// solid's frame.
struct SurfacePoint {
  Vec3 point, normal;   ///< surface point [m] and unit inward normal
  double distance = 0;  ///< signed distance of the query point, negative inside [m]
};
/// Returns the surface point of `solid` nearest to `point` [solid's frame, m].
SurfacePoint nearest_surface(const collision::Solid& solid, const Vec3& point);

/// The interval in which the target is held: from the last `grasp` of a movement to the end of its
/// hold or of the planned interval. `begin_s` is NaN if the target is never held.
struct HoldInterval {
  /// Time at which the hand begins to shape (kReleaseDuration_s before the grasp if there is no
  /// preshape).
  double open_s = kUnknown;
  /// Start and end of the interval [s].
  double begin_s = kUnknown, end_s = kUnknown;
  /// Time at which the target leaves the hand; infinity if not in this movement.
  double release_s = kUnknown;
};
/// Computes the hold interval of a movement from its phases.
HoldInterval hold_interval(const Movement& movement);

/// Returns the progress from free (0) to touching (1) at a time: 0 until the hand begins to shape,
/// 1 from the grasp to the release, and 0 again kReleaseDuration_s later. The function is twice
/// differentiable.
double closing_progress(const HoldInterval& when, double time_s);
/// Time over which the contacts are released [s].
inline constexpr double kReleaseDuration_s = 0.3;

}  // namespace morphe::grasp
