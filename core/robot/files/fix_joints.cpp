#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

bool moves_a_tip(const RobotModel& table, int joint) {
  return std::ranges::any_of(table.tips, [&](const RobotModel::Tip& tip) {
    return joint_moves_frame(table, joint, tip.frame);
  });
}

/// Makes a frame fixed at its place for this position of its joint.
void fix(RobotModel::Frame& frame, double position) {
  const double value = frame.ratio * position + frame.offset;
  if (frame.prismatic) {
    frame.transform.translate(value * frame.axis);
  } else {
    frame.transform.rotate(Eigen::AngleAxisd(value, frame.axis));
  }
  frame.joint = -1;
  frame.ratio = 1;
  frame.offset = 0;
  frame.axis = Vec3::UnitZ();
  frame.prismatic = false;
}

/// Fixes a joint and removes it from every list; the indices of later joints decrease by one.
void remove_joint(Assembly& assembly, int joint, double position) {
  RobotModel& table = assembly.table;
  for (RobotModel::Frame& frame : table.frames) {
    if (frame.joint == joint) fix(frame, position);
    if (frame.joint > joint) --frame.joint;
  }
  std::erase_if(table.coupled_limits, [&](const RobotModel::CoupledLimit& limit) {
    return table.frames[limit.frame].joint < 0;
  });
  std::erase_if(table.braking_curves,
                [&](const RobotModel::BrakingCurve& curve) { return curve.joint == joint; });
  for (RobotModel::BrakingCurve& curve : table.braking_curves) curve.joint -= curve.joint > joint;
  assembly.limits.erase(assembly.limits.begin() + joint);
  table.joint_names.erase(table.joint_names.begin() + joint);
}

}  // namespace

void fix_joints(Assembly& assembly) {
  RobotModel& table = assembly.table;
  std::vector<std::string> idle;
  for (int joint = static_cast<int>(table.joints()) - 1; joint >= 0; --joint) {
    const std::string name = table.joint_names[joint];
    const auto fixed = std::ranges::find(assembly.fixed_joints, name, &FixedJoint::joint);
    const bool requested = fixed != assembly.fixed_joints.end();
    if (!requested && (table.tips.empty() || moves_a_tip(table, joint))) continue;
    const JointLimits& limits = assembly.limits[joint];
    const double position =
        requested ? fixed->position : std::clamp(0.0, limits.lower, limits.upper);
    if (!requested) idle.insert(idle.begin(), fmt::format("{} at {:.4g}", name, position));
    remove_joint(assembly, joint, position);
    std::erase_if(assembly.natural, [&](const NaturalJoint& natural) {
      return natural.joint == name || natural.follow == name;
    });
  }
  if (idle.empty()) return;
  assembly.notes.push_back(
      fmt::format("joints that move no fingertip are fixed: {}", fmt::join(idle, ", ")));
}

}  // namespace morphe::robot
