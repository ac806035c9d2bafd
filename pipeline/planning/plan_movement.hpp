#pragma once

#include <optional>
#include <vector>

#include "pipeline/planning/planner.hpp"
#include "pipeline/run/batch.hpp"

namespace morphe::planning {

/// Plans one movement with all stages. The plan of an infeasible movement contains the reason. If
/// the smooth curve of a free path collides, the movement is planned again, farther from obstacles,
/// and the detail says so.
/// `demonstration` and `recorded` are those of a Reconstruction. `known_offset` is the base's
/// offset from its placement [m]; without it, the offset is chosen according to `map.base_offset`.
Plan plan_movement(const PlanningInputs& planner, const Demonstration& demonstration,
                   const HumanMotion& recorded, const Movement& movement,
                   const std::optional<Vec3>& known_offset = {});

/// Returns the plan of a movement before anything is mapped: what it takes from its recording, with
/// the base displaced by `known_offset` [m]. A movement that plan_movement() refuses before mapping
/// has the reason.
Plan place_movement(const PlanningInputs& planner, const Demonstration& demonstration,
                    const HumanMotion& recorded, const Movement& movement,
                    const Vec3& known_offset);

/// A demonstration reconstructed as an arm of the robot's side, and its movements. A recorded arm
/// of the other side is mirrored, with the objects. These include the other arm as an obstacle, if
/// any.
struct Reconstruction {
  HumanMotion motion;
  Demonstration on_robot_side;  ///< the demonstration with objects in the frame of `motion`
  std::vector<Movement> movements;
};
/// Reconstructs a demonstration and segments it into movements.
Reconstruction reconstruct_demonstration(const PlanningInputs& planner,
                                         const Demonstration& demonstration);

/// Reconstructs a demonstration, plans each of its movements, or a part of it
/// (partial_delivery.hpp), and verifies the plans. A
/// demonstration without movements results in one plan with the reason "no_movement".
run::DemonstrationOutcome plan_demonstration(const PlanningInputs& planner,
                                             const Demonstration& demonstration);

}  // namespace morphe::planning
