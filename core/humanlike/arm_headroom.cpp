#include "core/humanlike/arm_headroom.hpp"

#include <algorithm>
#include <cmath>

#include "core/humanlike/arm_chain.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::humanlike {
namespace {

constexpr double kMinWristLever_m = 1e-3, kMaxShoulderLever_m = 0.02;
constexpr int kJointsOfACircle = 4;  ///< three place the wrist, one more turns the elbow

/// Raises levers [n] to the distances that a point moves per unit of each joint.
void raise_levers(const robot::Robot& robot, const std::vector<Pose>& base_from_frame, int frame,
                  const Vec3& point, Eigen::RowVectorXd& levers) {
  Eigen::Matrix3Xd jacobian(3, levers.size());
  robot::point_jacobian(robot, base_from_frame, frame, point, jacobian);
  levers = levers.cwiseMax(jacobian.colwise().norm());
}

/// Returns the angle at the end of `side` in the triangle of three lengths, opposite to `opposite`.
double triangle_angle(double side, double other, double opposite) {
  const double cosine = (side * side + other * other - opposite * opposite) / (2 * side * other);
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

}  // namespace

bool has_elbow_circle(const robot::Robot& robot, const JointRows& postures) {
  Eigen::RowVectorXd of_wrist = Eigen::RowVectorXd::Zero(postures.cols()), of_shoulder = of_wrist;
  std::vector<Pose> base_from_frame;
  for (Eigen::Index k = 0; k < postures.rows(); ++k) {
    robot::forward_kinematics(robot, postures.row(k).transpose(), base_from_frame);
    const ArmPoints arm = arm_points(robot, base_from_frame);
    if (!is_known(arm.elbow)) return false;
    const ArmChain chain = arm_chain(robot, base_from_frame);
    const int wrist_frame = chain.frames.size() == 2 ? robot.palm_frame : chain.frames.back();
    raise_levers(robot, base_from_frame, wrist_frame, arm.wrist, of_wrist);
    raise_levers(robot, base_from_frame, robot.shoulder_frame, arm.shoulder, of_shoulder);
  }
  return (of_wrist.array() > kMinWristLever_m && of_shoulder.array() <= kMaxShoulderLever_m)
             .count() >= kJointsOfACircle;
}

LeastDirectionErrors least_direction_errors(const ArmPoints& human, const ArmPoints& robot) {
  const Vec3 line = robot.wrist - robot.shoulder;
  const double upper_arm_m = (robot.elbow - robot.shoulder).norm();
  const double forearm_m = (robot.wrist - robot.elbow).norm(), line_m = line.norm();
  const double upper_arm = direction_error(human.elbow - human.shoulder, line);
  const double forearm = direction_error(human.wrist - human.elbow, line);
  return {std::abs(upper_arm - triangle_angle(upper_arm_m, line_m, forearm_m)),
          std::abs(forearm - triangle_angle(forearm_m, line_m, upper_arm_m))};
}

Vec3 wrist_offset(const ArmPoints& human, const ArmPoints& robot) {
  const double upper_arm_m = (robot.elbow - robot.shoulder).norm();
  const double forearm_m = (robot.wrist - robot.elbow).norm();
  return robot.wrist - robot.shoulder - upper_arm_m * (human.elbow - human.shoulder).normalized() -
         forearm_m * (human.wrist - human.elbow).normalized();
}

}  // namespace morphe::humanlike
