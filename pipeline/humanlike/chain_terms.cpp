#include "pipeline/humanlike/chain_slopes.hpp"
#include "pipeline/humanlike/terms.hpp"

namespace morphe::humanlike {
namespace {

bool seen_arm(const FrameGoal& goal) {
  return seen(goal.shoulder) && seen(goal.elbow) && seen(goal.wrist);
}

Chain human_chain(const RobotState& state, const FrameGoal& goal) {
  return {goal.shoulder + state.offset, goal.elbow + state.offset, goal.wrist + state.offset};
}

void add_slopes(const ChainSlopes& slopes, const ArmChain& arm, double weight, Loads& loads) {
  loads.value += weight * slopes.value;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Vec3 force = weight * slopes.slope[i];
    loads.add_force(arm.frames[i], arm.joints[i], force, force, weight * slopes.curvature[i]);
  }
}

}  // namespace

void TriangleArea::add(const RobotState& state, const FrameGoal& goal, Loads& loads) const {
  const double share = weight * goal.weights.humanlike_arm;
  if (share == 0 || !seen_arm(goal)) return;
  const ArmChain arm = arm_chain(state.robot, state.base_from_frame);
  if (arm.joints.size() < 2) return;  // a hand alone
  add_slopes(triangle_area_slopes(human_chain(state, goal), arm.joints, smoothing_m2), arm, share,
             loads);
}

void HullVolume::add(const RobotState& state, const FrameGoal& goal, Loads& loads) const {
  const double share = weight * goal.weights.humanlike_arm;
  if (share == 0 || !seen_arm(goal)) return;
  const ArmChain arm = arm_chain(state.robot, state.base_from_frame);
  if (arm.joints.size() < 2) return;  // a hand alone
  add_slopes(hull_volume_slopes(human_chain(state, goal), arm.joints), arm, share, loads);
}

void ChainPosition::add(const RobotState& state, const FrameGoal& goal, Loads& loads) const {
  if (weight == 0 || goal.chain.empty()) return;
  const ArmChain arm = arm_chain(state.robot, state.base_from_frame);
  for (std::size_t i = 1; i < arm.joints.size(); ++i) {
    if (!seen(goal.chain[i])) continue;
    loads.add_point(arm.frames[i], arm.joints[i], goal.chain[i] + state.offset, weight, true);
  }
}

ArmChain arm_chain(const RobotTable& robot, const std::vector<Pose>& base_from_frame) {
  ArmChain arm;
  const auto add = [&](int frame, const Vec3& in_frame) {
    arm.joints.push_back(
        frame < 0 ? in_frame : Vec3(base_from_frame[static_cast<std::size_t>(frame)] * in_frame));
    arm.frames.push_back(frame);
  };
  add(robot.shoulder_frame, Vec3::Zero());
  for (const auto& centre : robot.centres) {
    if (centre.chain == "arm") add(centre.frame, Vec3::Zero());
  }
  for (const auto& tip : robot.tips) {
    if (tip.finger < 0) add(tip.frame, tip.transform.translation());
  }
  return arm;
}

}  // namespace morphe::humanlike
