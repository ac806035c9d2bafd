#include "stages/simulate/plan_lift.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::simulate {
namespace {

/// length that corresponds to one radian of the palm's rotation
constexpr double kRotationScale_m = 0.1;
constexpr double kPositionTolerance_m = 0.002, kOrientationTolerance_rad = 5 * kRadPerDegree;
constexpr double kDamping_m = 1e-4;  ///< damping of the joint steps [m]
constexpr int kMaxIterations = 4;

/// Computes d (palm's position, kRotationScale_m * rotation) / d (arm joints) [6, arm joints].
Eigen::MatrixXd palm_jacobian(const robot::Robot& robot, const std::vector<Pose>& base_from_frame) {
  const auto n = static_cast<Eigen::Index>(robot.joints());
  Eigen::Matrix3Xd point(3, n), turn = Eigen::Matrix3Xd::Zero(3, n);
  const Pose& palm = base_from_frame[robot.palm_frame];
  robot::point_jacobian(robot, base_from_frame, robot.palm_frame, palm.translation(), point);
  for (const int f : robot::ancestors(robot, robot.palm_frame)) {
    const RobotModel::Frame& frame = robot.frames[f];
    if (frame.joint >= 0 && !frame.prismatic) {
      turn.col(frame.joint) += frame.ratio * (base_from_frame[f].linear() * frame.axis);
    }
  }
  Eigen::MatrixXd jacobian(6, robot.arm_joints.size());
  for (Eigen::Index k = 0; k < jacobian.cols(); ++k) {
    const int j = robot.arm_joints[k];
    jacobian.col(k) << point.col(j), kRotationScale_m * turn.col(j);
  }
  return jacobian;
}

}  // namespace

double minimum_jerk(double s) { return s * s * s * (10 - 15 * s + 6 * s * s); }

std::optional<JointRows> plan_lift(const robot::Robot& robot, const JointVector& from,
                                   const Vec3& up, double height_m, Eigen::Index rows) {
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, from, base_from_frame);
  const auto palm = static_cast<std::size_t>(robot.palm_frame);
  const Pose start = base_from_frame[palm];
  JointRows path(rows, from.size());
  JointVector q = from;
  for (Eigen::Index row = 0; row < rows; ++row) {
    const double s = static_cast<double>(row + 1) / static_cast<double>(rows);
    const Vec3 wanted = start.translation() + minimum_jerk(s) * height_m * up;
    Vec3 aside, turn;
    for (int k = 0;; ++k) {
      robot::forward_kinematics(robot, q, base_from_frame);
      aside = wanted - base_from_frame[palm].translation();
      const Eigen::AngleAxisd left(start.linear() * base_from_frame[palm].linear().transpose());
      turn = left.angle() * left.axis();
      if (k == kMaxIterations) break;
      const Eigen::MatrixXd jacobian = palm_jacobian(robot, base_from_frame);
      Eigen::Matrix<double, 6, 1> error;
      error << aside, kRotationScale_m * turn;
      const Eigen::Matrix<double, 6, 6> normal =
          jacobian * jacobian.transpose() +
          kDamping_m * kDamping_m * Eigen::Matrix<double, 6, 6>::Identity();
      const JointVector step = jacobian.transpose() * normal.llt().solve(error);
      for (Eigen::Index i = 0; i < step.size(); ++i) {
        const int j = robot.arm_joints[i];
        q[j] = std::clamp(q[j] + step[i], robot.lower[j], robot.upper[j]);
      }
    }
    if (!(aside.norm() <= kPositionTolerance_m && turn.norm() <= kOrientationTolerance_rad))
      return std::nullopt;
    path.row(row) = q.transpose();
  }
  return path;
}

}  // namespace morphe::simulate
