#include "pipeline/planning/palm_error.hpp"

#include "core/robot/forward_kinematics.hpp"

namespace morphe::planning {

double palm_error(const RobotModel& robot, const Plan& plan) {
  std::vector<Pose> frames;
  double sum = 0;
  int count = 0;
  for (Eigen::Index f = 0; f < plan.mapped.position.rows(); ++f) {
    const Quat hand = plan.goals.wrist_orientation[f];
    if (!is_known(hand)) continue;
    robot::forward_kinematics(robot, plan.mapped.position.row(f).transpose(), frames);
    const Pose& palm = frames[robot.palm_frame];
    sum += angle_between(Quat(palm.linear()), hand);
    ++count;
  }
  return count > 0 ? sum / count : kUnknown;
}

}  // namespace morphe::planning
