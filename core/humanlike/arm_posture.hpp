#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::humanlike {

/// The points of an arm that its posture is compared by [m]; unknown if the arm does not have them.
struct ArmPoints {
  Vec3 shoulder = unknown_point(), elbow = unknown_point(), wrist = unknown_point();
};
/// Returns the robot's: the first and the last joint of arm_chain() and the joint between them. The
/// palm is the wrist of an arm whose chain ends at the elbow. An arm with more joints has no elbow,
/// a hand alone has none of the points.
ArmPoints arm_points(const robot::Robot& robot, const std::vector<Pose>& base_from_frame);
/// Returns the person's at a demonstration time, interpolated as all goals.
ArmPoints arm_points(const Goals& goals, double time_s);

/// Returns the angle between two directions [rad]; NaN if one of them is unknown.
double direction_error(const Vec3& a, const Vec3& b);

/// An elbow that is nearer to the line from shoulder to wrist than this share of the arm's length
/// does not define a swivel angle. On a person's arm of 0.55 m that is 55 mm, where an elbow that
/// is wrong by 10 mm turns the angle by 10 degrees.
constexpr double kMinElbowOffsetShare = 0.1;

/// Returns the swivel angle from arm `a` to arm `b` [rad], in (-pi, pi]: the rotation of b's elbow
/// about its line from shoulder to wrist, against the elbow of `a` after `a` has been turned by the
/// shortest rotation that lays its line on b's. NaN if a point is unknown, an elbow is too near to
/// its line (kMinElbowOffsetShare), or the lines are 90 degrees or more apart.
double swivel_error(const ArmPoints& a, const ArmPoints& b);

}  // namespace morphe::humanlike
