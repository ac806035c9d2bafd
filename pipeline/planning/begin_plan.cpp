#include "pipeline/planning/begin_plan.hpp"

#include <utility>

namespace morphe::planning {

Plan begin_plan(const Demonstration& demonstration, const Movement& movement,
                const Tolerances& tolerances) {
  Plan plan;
  plan.demonstration = demonstration.name;
  plan.subject = demonstration.subject;
  plan.task = demonstration.task;
  plan.source = demonstration.source;
  plan.licence = demonstration.licence;
  plan.hand = demonstration.hand;
  plan.movement = movement;
  plan.recording_assumptions = demonstration.assumptions;
  plan.tolerances = tolerances;
  return plan;
}

Plan fail(Plan plan, PlanningFailure failure) {
  plan.reason = failure.reason;
  plan.detail = std::move(failure.detail);
  plan.approximate = false;
  plan.delivered.reset();
  plan.trajectory = plan.approach = plan.retreat = {};
  plan.grasp = {};
  plan.certificate = {};
  return plan;
}

}  // namespace morphe::planning
