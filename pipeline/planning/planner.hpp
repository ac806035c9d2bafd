#pragma once

#include <string>

#include "core/parallel/stage_clock.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/planning/pipeline_config.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::planning {

struct PlanRequirements;

/// The inputs common to all movements of a run.
struct PlanningInputs {
  /// Finds the robot's reference posture. All arguments must outlive the inputs.
  PlanningInputs(const PipelineConfig& config, const robot::Robot& robot,
                 parallel::StageClock* clock = nullptr,
                 const PlanRequirements* requirements = nullptr);

  const PipelineConfig& config;
  const robot::Robot& robot;
  parallel::StageClock* clock;  ///< sums the processor time by stage; may be null
  /// Every plan of plan_demonstration() is verified against them; null: plans are not verified.
  const PlanRequirements* requirements;
  map::Reference reference;  ///< of the robot in its placement

  /// Returns step() and adds its processor time to that of the stage.
  template <class Step>
  auto timed(const std::string& stage, const Step& step) const {
    return clock ? clock->measure(stage, step) : step();
  }
};

}  // namespace morphe::planning
