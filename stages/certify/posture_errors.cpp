#include "stages/certify/posture_errors.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/humanlike/arm_posture.hpp"
#include "core/math/statistics.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::certify {
namespace {

double greatest(const std::vector<double>& values) {
  double largest = kUnknown;
  for (const double value : values) largest = std::fmax(largest, value);
  return largest;
}

}  // namespace

PostureErrors posture_errors_at(const robot::Robot& robot, const std::vector<Pose>& base_from_frame,
                                const Goals& goals, double time_s) {
  const humanlike::ArmPoints own = humanlike::arm_points(robot, base_from_frame);
  const humanlike::ArmPoints human = humanlike::arm_points(goals, time_s);
  PostureErrors errors;
  errors.forearm = humanlike::direction_error(human.wrist - human.elbow, own.wrist - own.elbow);
  errors.swivel = std::abs(humanlike::swivel_error(human, own));
  const Quat hand = wrist_orientation_at(goals, time_s);
  if (is_known(hand))
    errors.palm = angle_between(Quat(base_from_frame[robot.palm_frame].linear()), hand);
  return errors;
}

void set_posture_errors(const robot::Robot& robot, const Goals& goals, const Trajectory& trajectory,
                        Certificate& certificate) {
  if (goals.frames() == 0) return;
  std::vector<double> forearm, swivel, palm;
  std::vector<Pose> base_from_frame;
  for (int sample = 0; sample < std::ssize(trajectory.time); ++sample) {
    const double time_s = trajectory.demonstration_time[sample];
    robot::forward_kinematics(robot, trajectory.position.row(sample).transpose(), base_from_frame);
    const PostureErrors errors = posture_errors_at(robot, base_from_frame, goals, time_s);
    forearm.push_back(errors.forearm);
    swivel.push_back(errors.swivel);
    palm.push_back(errors.palm);
  }
  certificate.forearm_error_mean = math::mean(forearm);
  certificate.forearm_error_max = greatest(forearm);
  certificate.swivel_error_mean = math::mean(swivel);
  certificate.swivel_error_max = greatest(swivel);
  certificate.palm_error_mean = math::mean(palm);
  certificate.palm_error_max = greatest(palm);
}

}  // namespace morphe::certify
