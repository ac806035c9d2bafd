#pragma once

#include "core/collision/distance.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/grasp/constants.hpp"
#include "stages/grasp/grasp_options.hpp"

namespace morphe::grasp {

/// A contact that a pad is to make with the target, in the target's frame.
struct DesiredContact {
  std::size_t tip = 0;  ///< index of the robot's tip
  ContactOrigin origin = ContactOrigin::demonstrated;
  /// Surface point that the person touched [m]; unknown for a finger that closes by itself.
  Vec3 demonstrated = unknown_point();
  Vec3 point = Vec3::Zero();    ///< on the surface, which the pad should touch [m]
  Vec3 normal = Vec3::UnitZ();  ///< unit inward normal
  Vec3 centre = Vec3::Zero();   ///< of the pad's sphere at contact [m]
  double confidence = 1;        ///< confidence that the person touched here, 0 … 1
};

/// The point of a solid's surface nearest to a query point, in the solid's frame.
struct SurfacePoint {
  Vec3 point, normal;   ///< surface point [m] and unit inward normal
  double distance = 0;  ///< signed distance of the query point, negative inside [m]
};
/// Returns the surface point of `solid` nearest to `point` [solid's frame, m].
SurfacePoint nearest_surface(const collision::Solid& solid, const Vec3& point);

/// Returns the angle between the middle of a pad and the inward normal of a surface, two unit
/// vectors of one frame [rad].
double pad_angle(const Vec3& pad_direction, const Vec3& inward_normal);

/// The interval in which the target is held: from the last `grasp` of a movement to the end of its
/// last hold, at most to the end of the movement. NaN if the target is never held.
struct HoldInterval {
  /// begin of the preshape; kReleaseDuration_s before the grasp without a preshape
  double open_s = kUnknown;
  double begin_s = kUnknown, end_s = kUnknown;
  double release_s = kUnknown;  ///< end of the last transport; infinity without one
  /// The interval in which the pads keep still on the target: held_interval() if it is carried,
  /// otherwise from begin_s to release_s.
  double closed_s = kUnknown, opening_s = kUnknown;
};
/// Computes the hold interval of a movement from its phases.
HoldInterval hold_interval(const Movement& movement);

/// Returns the progress from free (0) to touching (1) at a time, twice differentiable: 0 until
/// open_s, 1 from closed_s to opening_s, and 0 again kReleaseDuration_s later. Always 0 without a
/// hold.
double closing_progress(const HoldInterval& hold, double time_s);

}  // namespace morphe::grasp
