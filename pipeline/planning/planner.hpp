#pragma once

#include "core/robot/robot.hpp"
#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::planning {

/// The inputs common to all movements of a run.
struct PlanningInputs {
  const PipelineConfig& config;
  const robot::Robot& robot;
};

}  // namespace morphe::planning
