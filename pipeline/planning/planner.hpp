#pragma once

#include "core/robot/robot.hpp"
#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::planning {

/// What is the same for every movement of a run.
struct Planner {
  const PipelineConfig& config;
  const robot::Robot& robot;
};

}  // namespace morphe::planning
