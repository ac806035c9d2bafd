#pragma once

#include <vector>

#include "core/collision/distance.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/grasp/grasp_options.hpp"

namespace morphe::grasp {

/// Where a pad is to touch the target, in the target's frame.
struct Touch {
  std::size_t tip = 0;
  ContactOrigin origin = ContactOrigin::demonstrated;
  Vec3 point = Vec3::Zero();    ///< of the surface [m]
  Vec3 normal = Vec3::UnitZ();  ///< unit, inwards
  Vec3 centre = Vec3::Zero();   ///< of the pad's ball, then [m]
  double confidence = 1;        ///< that the person touched there
};

/// The nearest point of a solid's surface, and the inward normal there, in its frame.
struct SurfacePoint {
  Vec3 point, normal;
  double distance = 0;  ///< < 0: the point lies inside [m]
};
SurfacePoint nearest_surface(const collision::Solid& solid, const Vec3& point);

/// When the target is held: from the last `grasp` of a movement to the end of its hold, or of what
/// is planned. `begin_s` NaN: never.
struct HoldTime {
  double open_s = kNotSeen;  ///< the hand begins to shape (the grasp itself where it does not)
  double begin_s = kNotSeen, end_s = kNotSeen;
  double release_s = kNotSeen;  ///< the target leaves the hand; infinity: not in this movement
};
HoldTime hold_time(const Movement& movement);

/// The share of the way from free to touching at a time: 0 until the hand begins to shape, 1 from
/// the grasp to the release, and 0 again kLetGo_s later; twice differentiable.
double closed_share(const HoldTime& when, double time_s);
inline constexpr double kLetGo_s = 0.3;

}  // namespace morphe::grasp
