#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/planning/planner.hpp"
#include "pipeline/run/batch.hpp"

namespace morphe::planning {

using StageSeconds = std::map<std::string, double>;

/// All steps for one movement. Never throws for a bad movement: the plan carries the reason. The
/// objects of `demonstration` are where `recorded` is: in the mirror, if a hand of the other side
/// than the robot's was recorded. `offset`: where the base stands, if that is no longer to be
/// chosen (map.free_offset).
Plan plan_movement(const Planner& planner, const Demonstration& demonstration,
                   const HumanMotion& recorded, const Movement& movement, StageSeconds& seconds,
                   const std::optional<Vec3>& offset = {});

/// A demonstration rebuilt as an arm of the robot's side, and the movements found in it; what is
/// around them is where that arm is: in the mirror, if the other one was recorded. The person's
/// other arm is among it, if it is to be an obstacle.
struct Rebuilt {
  HumanMotion motion;
  Demonstration beside;
  std::vector<Movement> movements;
};
Rebuilt rebuild(const Planner& planner, const Demonstration& demonstration, StageSeconds& seconds);

/// Rebuilds a demonstration and plans each of its movements. One without any
/// movement ends as one plan with reason "no_movement".
run::DemonstrationOutcome plan_demonstration(const Planner& planner,
                                             const Demonstration& demonstration);

}  // namespace morphe::planning
