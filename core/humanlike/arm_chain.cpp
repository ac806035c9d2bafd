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

void add_chain(const ChainGradient& slopes, const ArmChain& arm, double weight, Loads& loads) {
  loads.value += weight * slopes.value;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Vec3 force = weight * slopes.gradient[i];
    loads.add_force(arm.frames[i], arm.joints[i], force, force, weight * slopes.curvature[i]);
  }
}

}  // namespace morphe::humanlike
