#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

/// Chooses the first of the arms that carry the palm, else the first arm, and clears Chain::arm of
/// all others. Returns null without an arm.
const Chain* choose_arm(Assembly& assembly) {
  const int palm = frame_index(assembly.table, assembly.palm);
  Chain* arm = nullptr;
  bool arm_carries = false;
  for (Chain& chain : assembly.chains) {
    if (!std::exchange(chain.arm, false)) continue;
    const bool carries = palm >= 0 && is_in_subtree(assembly.table, palm, chain.frames.front());
    if (!arm || (carries && !arm_carries)) arm = &chain;
    arm_carries = arm_carries || carries;
  }
  if (arm) arm->arm = true;
  return arm;
}

}  // namespace

void remove_parent_wrist_tip(Assembly& assembly, const MountPoint& mount) {
  std::erase_if(assembly.table.tips, [&](const RobotModel::Tip& tip) {
    return tip.finger < 0 && mount.frame >= 0 &&
           (is_in_subtree(assembly.table, tip.frame, mount.frame) ||
            is_in_subtree(assembly.table, mount.frame, tip.frame));
  });
}

void finalize_robot(Assembly& assembly) {
  tighten_limits(assembly);
  fix_joints(assembly);
  set_limits(assembly);
  RobotModel& table = assembly.table;
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
  for (const auto& [one, other] : assembly.allowed_frames) allow_frames(table, one, other);
  allow_neighbours(table);
  table.unchecked_links = unchecked_links(assembly);
}

}  // namespace morphe::robot
