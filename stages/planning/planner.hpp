#pragma once

#include "pipeline/motion/robot_table.hpp"
#include "stages/planning/pipeline_config.hpp"

namespace morphe::planning {

/// What is the same for every movement of a run.
struct Planner {
  const PipelineConfig& config;
  const RobotTable& robot;
  JointRows capsule_reach;  ///< of the robot, see pipeline/collision/certified.hpp
};

}  // namespace morphe::planning
