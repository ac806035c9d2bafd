#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/run/batch.hpp"
#include "stages/pipeline_config.hpp"

namespace morphe {

/// What is the same for every movement of a run.
struct Planner {
  const PipelineConfig& config;
  const RobotTable& robot;
  JointRows capsule_reach;  ///< of the robot, see pipeline/collision/certified.hpp
};

using StageSeconds = std::map<std::string, double>;

/// All steps for one movement. Never throws for a bad movement: the plan carries the reason. The
/// objects of `demonstration` are where `recorded` is: a left hand's in the mirror.
Plan plan_movement(const Planner& planner, const Demonstration& demonstration,
                   const HumanMotion& recorded, const Movement& movement, StageSeconds& seconds);

/// Reconstructs and segments a demonstration and plans each of its movements. One without any
/// movement ends as one plan with reason "no_movement".
DemonstrationOutcome plan_demonstration(const Planner& planner, const Demonstration& demonstration);

}  // namespace morphe
