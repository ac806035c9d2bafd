#include "pipeline/planning/planner.hpp"

#include "pipeline/planning/approach.hpp"
#include "stages/map/reference_posture.hpp"

namespace morphe::planning {

PlanningInputs::PlanningInputs(const PipelineConfig& config_, const robot::Robot& robot_,
                               parallel::StageClock* clock_, const PlanRequirements* requirements_)
    : config(config_),
      robot(robot_),
      clock(clock_),
      requirements(requirements_),
      reference(map::find_reference(
          robot_, config_.map, config_.placement, tolerances_of(config_),
          home_posture(robot_, config_.approach.value_or(ApproachOptions{})))) {}

}  // namespace morphe::planning
