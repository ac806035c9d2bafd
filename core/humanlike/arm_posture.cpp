#include "core/humanlike/arm_posture.hpp"

#include <cmath>

#include "core/humanlike/arm_chain.hpp"
#include "core/math/rotation.hpp"
#include "core/motion/goal_interpolation.hpp"

namespace morphe::humanlike {
namespace {

/// Returns the elbow's offset from the line from shoulder to wrist [m]; unknown if it is too small.
Vec3 elbow_offset(const ArmPoints& arm, const Vec3& line) {
  const Vec3 upper_arm = arm.elbow - arm.shoulder;
  const Vec3 offset = upper_arm - line.dot(upper_arm) * line;
  const double length_m = upper_arm.norm() + (arm.wrist - arm.elbow).norm();
  return offset.norm() >= kMinElbowOffsetShare * length_m ? offset : unknown_point();
}

}  // namespace

ArmPoints arm_points(const robot::Robot& robot, const std::vector<Pose>& base_from_frame) {
  if (robot.arm_centres.empty()) return {};
  const Chain chain = arm_chain(robot, base_from_frame).joints;
  return {chain.front(), chain.size() <= 3 ? chain[1] : unknown_point(),
          arm_wrist(robot, base_from_frame).position};
}

ArmPoints arm_points(const Goals& goals, double time_s) {
  const FrameInterpolation frames = frame_interpolation(goals, time_s);
  return {interpolate_point(goals.shoulder_position, frames),
          interpolate_point(goals.elbow_position, frames),
          interpolate_point(goals.wrist_position, frames)};
}

double direction_error(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double swivel_error(const ArmPoints& a, const ArmPoints& b) {
  const Vec3 from = (a.wrist - a.shoulder).normalized(), to = (b.wrist - b.shoulder).normalized();
  const Vec3 from_offset = elbow_offset(a, from), to_offset = elbow_offset(b, to);
  if (!is_known(from_offset) || !is_known(to_offset) || from.dot(to) <= 0) return kUnknown;
  const Vec3 turned = math::shortest_rotation(from, to) * from_offset;
  return std::atan2(to.dot(turned.cross(to_offset)), turned.dot(to_offset));
}

}  // namespace morphe::humanlike
