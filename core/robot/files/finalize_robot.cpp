#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

JointVector vector_of(const std::vector<double>& values) {
  return Eigen::Map<const JointVector>(values.data(), values.size());
}

/// Returns the arm that carries the palm, or the first arm if no arm does, and clears the mark of
/// all other arms.
const Chain* choose_arm(Assembly& assembly) {
  const int palm = frame_index(assembly.table, assembly.palm);
  Chain* arm = nullptr;
  bool carried = false;
  for (Chain& chain : assembly.chains) {
    if (!std::exchange(chain.arm, false)) continue;
    const bool carries = palm >= 0 && is_in_subtree(assembly.table, palm, chain.frames.front());
    if (!arm || (carries && !carried)) arm = &chain;
    carried = carried || carries;
  }
  if (arm) arm->arm = true;
  return arm;
}

}  // namespace

void remove_parent_wrist_tip(Assembly& assembly, const MountPoint& place) {
  std::erase_if(assembly.table.tips, [&](const RobotModel::Tip& tip) {
    return tip.finger < 0 && place.frame >= 0 &&
           (is_in_subtree(assembly.table, tip.frame, place.frame) ||
            is_in_subtree(assembly.table, place.frame, tip.frame));
  });
}

void finalize_robot(Assembly& assembly) {
  tighten_limits(assembly);
  fix_joints(assembly);
  RobotModel& table = assembly.table;
  table.lower = vector_of(assembly.lower);
  table.upper = vector_of(assembly.upper);
  table.velocity = vector_of(assembly.velocity);
  table.acceleration = vector_of(assembly.acceleration);
  table.jerk = vector_of(assembly.jerk);

  const Chain* arm = choose_arm(assembly);
  if (!assembly.shoulder.empty()) {
    table.shoulder_frame = frame_index(table, assembly.shoulder);
  } else if (arm) {
    table.shoulder_frame = arm->frames.front();
  }
  if (!assembly.palm.empty()) {
    table.palm_frame = frame_index(table, assembly.palm);
  } else {
    assert(arm);
    table.palm_frame = arm->end.frame;
  }
  derive_centres(assembly);
  for (auto& [file, links] : assembly.meshes) {
    links.erase(std::unique(links.begin(), links.end()), links.end());
    assembly.notes.push_back(
        fmt::format("{}: meshes of {} are ignored; `morphe robot setup` fits capsules to them",
                    file, fmt::join(links, ", ")));
  }
  for (const auto& [one, other] : assembly.allowed_frames) allow_frames(table, 0, one, other);
  allow_neighbours(table);
  table.unchecked_links = unchecked_links(assembly);
}

}  // namespace morphe::robot
