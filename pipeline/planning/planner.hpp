#pragma once

#include <string>

#include "core/parallel/stage_clock.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::planning {

struct PlanRequirements;

/// The inputs common to all movements of a run.
struct PlanningInputs {
  const PipelineConfig& config;
  const robot::Robot& robot;
  parallel::StageClock* clock = nullptr;  ///< sums the processor time by stage; may be null
  /// Every plan of plan_demonstration() is verified against them; null: plans are not verified.
  const PlanRequirements* requirements = nullptr;

  /// Returns step() and adds its processor time to that of the stage.
  template <class Step>
  auto timed(const std::string& stage, const Step& step) const {
    return clock ? clock->measure(stage, step) : step();
  }
};

}  // namespace morphe::planning
