#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/planning/planner.hpp"
#include "pipeline/run/batch.hpp"

namespace morphe::planning {

/// processor time by stage [s]
using StageSeconds = std::map<std::string, double>;

/// Plans one movement with all stages. Never throws for an infeasible movement: the plan contains
/// the reason. The objects of `demonstration` are in the frame of `recorded`, which is mirrored if
/// a hand of the other side than the robot's was recorded. `offset` is the position of the base, if
/// it is not to be chosen any more (map.free_offset).
Plan plan_movement(const PlanningInputs& planner, const Demonstration& demonstration,
                   const HumanMotion& recorded, const Movement& movement, StageSeconds& seconds,
                   const std::optional<Vec3>& offset = {});

/// A demonstration reconstructed as an arm of the robot's side, and the movements found in it. The
/// objects are mirrored with the arm if the other one was recorded, and include the person's other
/// arm if it is an obstacle.
struct Reconstruction {
  HumanMotion motion;
  Demonstration on_robot_side;  ///< the demonstration in the frame of `motion`
  std::vector<Movement> movements;
};
/// Reconstructs a demonstration and segments it into movements.
Reconstruction reconstruct_demonstration(const PlanningInputs& planner,
                                         const Demonstration& demonstration, StageSeconds& seconds);

/// Reconstructs a demonstration and plans each of its movements. A demonstration without movements
/// results in one plan with the reason "no_movement".
run::DemonstrationOutcome plan_demonstration(const PlanningInputs& planner,
                                             const Demonstration& demonstration);

}  // namespace morphe::planning
