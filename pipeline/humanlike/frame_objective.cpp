#include "pipeline/humanlike/frame_objective.hpp"

#include "pipeline/kinematics/forward.hpp"

namespace morphe {

void add_objective(const FrameObjective& objective, const RobotTable& robot, const JointVector& q,
                   const FrameGoal& goal, std::vector<Pose>& base_from_frame, Quadratic& model) {
  forward(robot, q, base_from_frame);
  const RobotState state{robot, q, base_from_frame};
  objective.tip_position.add(state, goal, model);
  objective.tip_orientation.add(state, goal, model);
  objective.hand_orientation.add(state, goal, model);
  objective.joint_distance.add(state, goal, model);
  objective.finger_joint_distance.add(state, goal, model);
  objective.posture.add(state, goal, model);
}

}  // namespace morphe
