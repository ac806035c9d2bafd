#include "pipeline/study/plan_recordings.hpp"

#include "pipeline/planning/plan_movement.hpp"

namespace morphe::study {

PlannedRecordings plan_recordings(const planning::LoadedConfig& config,
                                  const std::vector<Demonstration>& recordings, int jobs) {
  const planning::PlanningInputs planner{config.options, config.robot};
  PlannedRecordings result;
  run::Batch batch;
  batch.next = [&, next = 0]() mutable {
    return next == std::ssize(recordings) ? nullptr
                                          : std::make_unique<Demonstration>(recordings[next++]);
  };
  batch.plan = [&](const Demonstration& demonstration) {
    return planning::plan_demonstration(planner, demonstration);
  };
  batch.write = [&](const run::DemonstrationOutcome& outcome) {
    result.plans.insert(result.plans.end(), outcome.plans.begin(), outcome.plans.end());
  };
  result.map_s = run::run_batch(batch, jobs).stage_cpu_s["map"];
  return result;
}

}  // namespace morphe::study
