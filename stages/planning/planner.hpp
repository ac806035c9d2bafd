#pragma once

#include "pipeline/robot/robot.hpp"
#include "stages/planning/pipeline_config.hpp"

namespace morphe::planning {

/// What is the same for every movement of a run.
struct Planner {
  const PipelineConfig& config;
  const robot::Robot& robot;
};

}  // namespace morphe::planning
