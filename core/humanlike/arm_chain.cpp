#include "core/humanlike/arm_chain.hpp"

namespace morphe::humanlike {

ArmChain arm_chain(const robot::Robot& robot, const std::vector<Pose>& base_from_frame) {
  ArmChain arm;
  const auto add = [&](int frame, const Vec3& in_frame) {
    arm.joints.push_back(frame < 0 ? in_frame : Vec3(base_from_frame[frame] * in_frame));
    arm.frames.push_back(frame);
  };
  add(robot.shoulder_frame, Vec3::Zero());
  for (const int centre : robot.arm_centres) add(centre, Vec3::Zero());
  for (const auto& tip : robot.tips) {
    if (tip.finger < 0) add(tip.frame, tip.transform.translation());
  }
  return arm;
}

ArmWrist arm_wrist(const robot::Robot& robot, const std::vector<Pose>& base_from_frame) {
  const ArmChain arm = arm_chain(robot, base_from_frame);
  if (arm.joints.size() > 2) return {arm.joints.back(), arm.frames.back()};
  return {base_from_frame[robot.palm_frame].translation(), robot.palm_frame};
}

}  // namespace morphe::humanlike
