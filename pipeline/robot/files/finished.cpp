#include <algorithm>
#include <cassert>

#include "pipeline/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

JointVector vector_of(const std::vector<double>& values) {
  return Eigen::Map<const JointVector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

void drop_carriers_wrist(Assembly& assembly, const Anchor& place) {
  std::erase_if(assembly.table.tips, [&](const RobotTable::Tip& tip) {
    return tip.finger < 0 && place.frame >= 0 &&
           (hangs_on(assembly.table, tip.frame, place.frame) ||
            hangs_on(assembly.table, place.frame, tip.frame));
  });
}

RobotTable finished(Assembly assembly) {
  RobotTable& table = assembly.table;
  table.lower = vector_of(assembly.lower);
  table.upper = vector_of(assembly.upper);
  table.velocity = vector_of(assembly.velocity);
  table.acceleration = vector_of(assembly.acceleration);
  table.jerk = vector_of(assembly.jerk);

  const auto arm =
      std::ranges::find_if(assembly.chains, [](const Chain& c) { return c.name == "arm"; });
  const bool has_arm = arm != assembly.chains.end();
  if (!assembly.shoulder.empty()) {
    table.shoulder_frame = frame_index(table, assembly.shoulder);
  } else if (has_arm) {
    table.shoulder_frame = arm->frames.front();
  }
  if (!assembly.palm.empty()) {
    table.palm_frame = frame_index(table, assembly.palm);
  } else {
    assert(has_arm);
    table.palm_frame = arm->end.frame;
  }
  derive_centres(assembly);
  allow_neighbours(table);
  return std::move(table);
}

}  // namespace morphe::robot
