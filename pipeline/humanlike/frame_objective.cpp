#include "pipeline/humanlike/frame_objective.hpp"

#include "pipeline/robot/forward.hpp"

namespace morphe::humanlike {

void add_objective(const FrameObjective& objective, const RobotTable& robot, const JointVector& q,
                   const FrameGoal& goal, ObjectiveScratch& scratch, solve::Quadratic& model,
                   Curvature curvature) {
  if (curvature == Curvature::exact) {
    if (!scratch.loads.points.empty()) {
      scratch.last = q - scratch.last;
      promise(robot, scratch.last, scratch.sweep, scratch.loads.points);
    }
    scratch.last = q;
  }
  robot::forward(robot, q.head(static_cast<Eigen::Index>(robot.joints())), scratch.base_from_frame);
  RobotState state{robot, q, scratch.base_from_frame};
  if (objective.offset.free) state.offset = q.tail<3>();
  scratch.loads.reset(robot.frames.size(), curvature);
  objective.tip_position.add(state, goal, scratch.loads);
  objective.tip_orientation.add(state, goal, scratch.loads);
  objective.hand_orientation.add(state, goal, scratch.loads);
  objective.joint_distance.add(state, goal, scratch.loads);
  objective.finger_joint_distance.add(state, goal, scratch.loads);
  objective.triangle_area.add(state, goal, scratch.loads);
  objective.hull_volume.add(state, goal, scratch.loads);
  objective.chain_position.add(state, goal, scratch.loads);
  add_derivatives(robot, scratch.base_from_frame, scratch.loads, scratch.sweep, model);
  objective.posture.add(state, goal, model);
  objective.joint_angle.add(state, goal, model);
  objective.offset.add(state, model);
}

}  // namespace morphe::humanlike
