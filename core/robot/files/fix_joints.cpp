#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/robot/files/assembly.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {
namespace {

bool moves_a_tip(const RobotModel& table, int joint) {
  return std::ranges::any_of(table.tips, [&](const RobotModel::Tip& tip) {
    return joint_moves_frame(table, joint, tip.frame);
  });
}

void fix(RobotModel::Frame& frame, double at) {
  const double value = frame.ratio * at + frame.offset;
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

/// Removes a joint from every list; the indices of later joints decrease by one.
void remove_joint(Assembly& assembly, int joint, double at) {
  RobotModel& table = assembly.table;
  for (RobotModel::Frame& frame : table.frames) {
    if (frame.joint == joint) fix(frame, at);
    if (frame.joint > joint) --frame.joint;
  }
  std::erase_if(table.coupled_limits, [&](const RobotModel::CoupledLimit& limit) {
    return table.frames[limit.frame].joint < 0;
  });
  std::erase_if(table.braking_curves,
                [&](const RobotModel::BrakingCurve& curve) { return curve.joint == joint; });
  for (RobotModel::BrakingCurve& curve : table.braking_curves) curve.joint -= curve.joint > joint;
  for (std::vector<double>* list : {&assembly.lower, &assembly.upper, &assembly.velocity,
                                    &assembly.acceleration, &assembly.jerk}) {
    list->erase(list->begin() + joint);
  }
  table.joint_names.erase(table.joint_names.begin() + joint);
}

}  // namespace

void fix_joints(Assembly& assembly) {
  RobotModel& table = assembly.table;
  std::vector<std::string> idle;
  for (int joint = static_cast<int>(table.joints()) - 1; joint >= 0; --joint) {
    const auto j = static_cast<std::size_t>(joint);
    const std::string name = table.joint_names[j];
    const auto held = std::ranges::find(assembly.fixed_joints, name, &FixedJoint::joint);
    const bool asked = held != assembly.fixed_joints.end();
    if (!asked && (table.tips.empty() || moves_a_tip(table, joint))) continue;
    const double rest = std::clamp(0.0, assembly.lower[j], assembly.upper[j]);
    const double at = asked ? held->position : rest;
    if (!asked) idle.insert(idle.begin(), fmt::format("{} at {:.4g}", name, at));
    remove_joint(assembly, joint, at);
    std::erase_if(assembly.natural, [&](const NaturalJoint& natural) {
      return natural.joint == name || natural.follow == name;
    });
  }
  if (idle.empty()) return;
  assembly.notes.push_back(
      fmt::format("joints that move no fingertip are fixed: {}", fmt::join(idle, ", ")));
}

}  // namespace morphe::robot
