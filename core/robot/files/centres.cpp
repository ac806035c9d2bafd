#include <algorithm>

#include "core/robot/files/assembly.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::robot {
namespace {

/// Returns the chain's hinges, one for each place; those at the place of frame `skip` are omitted.
std::vector<int> distinct_hinges(const Chain& chain, const std::vector<Pose>& base_from_frame,
                                 int skip) {
  const auto origin = [&](int frame) -> Vec3 { return base_from_frame[frame].translation(); };
  std::vector<int> distinct;
  for (const int hinge : chain.hinges) {
    const auto same = [&](int other) {
      return (origin(hinge) - origin(other)).norm() < kCoincidentTolerance_m;
    };
    if (!same(skip) && std::ranges::none_of(distinct, same)) distinct.push_back(hinge);
  }
  return distinct;
}

bool carries_chain(const Assembly& assembly, const Chain& arm) {
  return std::ranges::any_of(assembly.chains, [&](const Chain& chain) {
    return chain.name != arm.name &&
           is_in_subtree(assembly.table, chain.frames.front(), arm.frames.front());
  });
}

bool is_finger(const RobotModel& table, const Chain& chain) {
  return std::ranges::any_of(table.tips, [&](const RobotModel::Tip& tip) {
    return tip.finger >= 0 && is_in_subtree(table, tip.frame, chain.frames.back());
  });
}

}  // namespace

void derive_centres(Assembly& assembly) {
  RobotModel& table = assembly.table;
  std::vector<Pose> base_from_frame;
  forward_kinematics(table, JointVector::Zero(table.joints()), base_from_frame);
  std::vector<RobotModel::JointCentre> centres;
  for (const Chain& chain : assembly.chains) {
    const auto of_chain = [&](const RobotModel::JointCentre& c) { return c.chain == chain.name; };
    std::ranges::copy_if(table.joint_centres, std::back_inserter(centres), of_chain);
    if (std::ranges::any_of(table.joint_centres, of_chain)) continue;
    if (chain.arm) {
      std::vector<int> joints = distinct_hinges(chain, base_from_frame, table.shoulder_frame);
      if (joints.size() > 1 && !carries_chain(assembly, chain)) joints.pop_back();
      for (const int frame : joints) centres.push_back({frame, "arm"});
    } else if (is_finger(table, chain)) {
      const std::vector<int> joints = distinct_hinges(chain, base_from_frame, chain.frames.front());
      if (!joints.empty()) centres.push_back({joints.front(), chain.name});
    }
  }
  table.joint_centres = std::move(centres);
}

}  // namespace morphe::robot
