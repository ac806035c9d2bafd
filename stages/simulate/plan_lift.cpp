#include "stages/simulate/plan_lift.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::simulate {
namespace {

constexpr double kRotationScale_m = 0.1;  ///< position error that counts as much as one radian
constexpr double kPositionTolerance_m = 0.002, kOrientationTolerance_rad = 5 * kRadPerDegree;
constexpr double kDamping_m = 1e-4;  ///< of the joint steps
constexpr int kIterations = 4;

/// Computes d (palm's position, kRotationScale_m * rotation) / d (arm joints) [6, arm joints].
Eigen::MatrixXd palm_jacobian(const robot::Robot& robot, const std::vector<Pose>& base_from_frame) {
  const Eigen::Index n = robot.joints();
  Eigen::Matrix3Xd position(3, n), rotation = Eigen::Matrix3Xd::Zero(3, n);
  const Pose& palm = base_from_frame[robot.palm_frame];
  robot::point_jacobian(robot, base_from_frame, robot.palm_frame, palm.translation(), position);
  for (const int f : robot::ancestors(robot, robot.palm_frame)) {
    const RobotModel::Frame& frame = robot.frames[f];
    if (frame.joint >= 0 && !frame.prismatic)
      rotation.col(frame.joint) += frame.ratio * (base_from_frame[f].linear() * frame.axis);
  }
  Eigen::MatrixXd jacobian(6, robot.arm_joints.size());
  for (int k = 0; k < jacobian.cols(); ++k) {
    const int j = robot.arm_joints[k];
    jacobian.col(k) << position.col(j), kRotationScale_m * rotation.col(j);
  }
  return jacobian;
}

}  // namespace

double minimum_jerk(double s) { return s * s * s * (10 - 15 * s + 6 * s * s); }

std::optional<JointRows> plan_lift(const robot::Robot& robot, const JointVector& start,
                                   const Vec3& up, double height_m, Eigen::Index rows) {
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, start, base_from_frame);
  const Pose start_pose = base_from_frame[robot.palm_frame];
  JointRows path(rows, start.size());
  JointVector q = start;
  for (int row = 0; row < rows; ++row) {
    const double s = (row + 1) / static_cast<double>(rows);
    const Vec3 goal = start_pose.translation() + minimum_jerk(s) * height_m * up;
    Vec3 position_error, rotation_error;
    for (int k = 0;; ++k) {
      robot::forward_kinematics(robot, q, base_from_frame);
      const Pose& palm = base_from_frame[robot.palm_frame];
      position_error = goal - palm.translation();
      const Eigen::AngleAxisd rotation(start_pose.linear() * palm.linear().transpose());
      rotation_error = rotation.angle() * rotation.axis();
      if (k == kIterations) break;
      const Eigen::MatrixXd jacobian = palm_jacobian(robot, base_from_frame);
      Eigen::Matrix<double, 6, 1> error;
      error << position_error, kRotationScale_m * rotation_error;
      const Eigen::Matrix<double, 6, 6> normal =
          jacobian * jacobian.transpose() +
          kDamping_m * kDamping_m * Eigen::Matrix<double, 6, 6>::Identity();
      const JointVector step = jacobian.transpose() * normal.llt().solve(error);
      for (int i = 0; i < step.size(); ++i) {
        const int j = robot.arm_joints[i];
        q[j] = std::clamp(q[j] + step[i], robot.lower[j], robot.upper[j]);
      }
    }
    if (!(position_error.norm() <= kPositionTolerance_m &&
          rotation_error.norm() <= kOrientationTolerance_rad))
      return std::nullopt;
    path.row(row) = q.transpose();
  }
  return path;
}

}  // namespace morphe::simulate
