#include "core/humanlike/frame_objective.hpp"

#include "core/robot/forward_kinematics.hpp"

namespace morphe::humanlike {

void add_objective(const FrameObjective& objective, const robot::Robot& robot, const JointVector& q,
                   const FrameGoal& goal, ObjectiveScratch& scratch, solve::Quadratic& model,
                   Curvature curvature) {
  if (curvature == Curvature::exact) {
    if (!scratch.loads.points.empty()) {
      scratch.last_q = q - scratch.last_q;  // the step
      predict_multiplier_forces(robot, scratch.last_q, scratch.sweep, scratch.loads.points);
    }
    scratch.last_q = q;
  }
  robot::forward_kinematics(robot, q, scratch.base_from_frame);
  const RobotState state{robot, q, scratch.base_from_frame};
  scratch.loads.reset(robot.frames.size(), curvature);
  objective.for_each_term([&]<class T>(const T& term) {
    const double share = term.weight * goal.weights.of(T::kGroup);
    if constexpr (FrameTerm<T>) {
      if (share != 0) term.add(state, goal, share, scratch.loads);
    }
  });
  add_derivatives(robot, scratch.base_from_frame, scratch.loads, scratch.sweep, model);
  objective.for_each_term([&]<class T>(const T& term) {
    const double share = term.weight * goal.weights.of(T::kGroup);
    if constexpr (JointTerm<T>) {
      if (share != 0) term.add(state, goal, share, model);
    }
  });
}

}  // namespace morphe::humanlike
