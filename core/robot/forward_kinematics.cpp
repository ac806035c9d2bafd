#include "core/robot/forward_kinematics.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/math/sine_cosine.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {
namespace {

constexpr int kAnglesPerBlock = 32;  ///< number of angles whose sines are computed at once

/// Computes base_from_parent * transform * Rotation(axis, value), or * Translation(axis * value);
/// s, c are sine and cosine of the value. Columns include the fourth row, because four numbers fit
/// SIMD packets and three do not. A rotation about z, as in all DH joints, mixes two columns only.
void set_frame_pose(const Eigen::Matrix4d& parent, const RobotModel::Frame& frame, double s,
                    double c, double value, Eigen::Matrix4d& pose) {
  const Eigen::Matrix4d& t = frame.transform.matrix();
  const Eigen::Vector4d p0 = parent.col(0), p1 = parent.col(1), p2 = parent.col(2);
  const auto column = [&](Eigen::Index j) -> Eigen::Vector4d {
    return p0 * t(0, j) + p1 * t(1, j) + p2 * t(2, j);
  };
  const Eigen::Vector4d x = column(0), y = column(1), z = column(2);
  pose.col(3) = column(3) + parent.col(3);
  if (frame.prismatic && frame.joint >= 0) {
    pose.col(0) = x;
    pose.col(1) = y;
    pose.col(2) = z;
    pose.col(3) += value * (frame.axis.x() * x + frame.axis.y() * y + frame.axis.z() * z);
    return;
  }
  if (frame.axis.z() == 1) {
    pose.col(0) = c * x + s * y;
    pose.col(1) = c * y - s * x;
    pose.col(2) = z;
    return;
  }
  // Rodrigues' formula: v Rotation = c v + s v × axis + (1 - c) (v · axis) axis for every row v.
  const Vec3& a = frame.axis;
  const Eigen::Vector4d along = (1 - c) * (a.x() * x + a.y() * y + a.z() * z);
  pose.col(0) = c * x + s * (a.z() * y - a.y() * z) + a.x() * along;
  pose.col(1) = c * y + s * (a.x() * z - a.z() * x) + a.y() * along;
  pose.col(2) = c * z + s * (a.y() * x - a.x() * y) + a.z() * along;
}

/// Returns ratio * axis in the base frame.
Vec3 scaled_axis(const RobotModel::Frame& frame, const Pose& pose) {
  if (frame.axis.z() == 1) return frame.ratio * pose.matrix().col(2).head<3>();
  return frame.ratio * (pose.linear() * frame.axis);
}

}  // namespace

void forward_kinematics(const RobotModel& robot, const Eigen::Ref<const JointVector>& q,
                        std::vector<Pose>& base_from_frame) {
  assert(q.size() == std::ssize(robot.joint_names));
  const std::ptrdiff_t count = std::ssize(robot.frames);
  base_from_frame.resize(count);
  const Eigen::Matrix4d base = Eigen::Matrix4d::Identity();
  std::array<double, kAnglesPerBlock> angle, sine, cosine;
  for (std::ptrdiff_t begin = 0; begin < count; begin += kAnglesPerBlock) {
    const std::ptrdiff_t size = std::min<std::ptrdiff_t>(kAnglesPerBlock, count - begin);
    for (int i = 0; i < size; ++i) {
      const RobotModel::Frame& frame = robot.frames[begin + i];
      angle[i] = frame.joint < 0 ? 0 : frame.ratio * q[frame.joint] + frame.offset;
    }
    math::sine_cosine(angle.data(), size, sine.data(), cosine.data());
    for (int i = 0; i < size; ++i) {
      const RobotModel::Frame& frame = robot.frames[begin + i];
      assert(frame.parent < begin + i);
      const Eigen::Matrix4d& parent =
          frame.parent < 0 ? base : base_from_frame[frame.parent].matrix();
      set_frame_pose(parent, frame, sine[i], cosine[i], angle[i],
                     base_from_frame[begin + i].matrix());
    }
  }
}

Pose tip_pose(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
              std::ptrdiff_t tip) {
  const RobotModel::Tip& t = robot.tips[tip];
  if (t.frame < 0) return t.transform;
  return base_from_frame[t.frame] * t.transform;
}

void point_jacobian(const RobotModel& robot, const std::vector<Pose>& base_from_frame, int frame,
                    const Vec3& point_in_base, Eigen::Ref<Eigen::Matrix3Xd> jacobian) {
  assert(jacobian.cols() == std::ssize(robot.joint_names));
  jacobian.setZero();
  for (const int above : ancestors(robot, frame)) {
    const RobotModel::Frame& f = robot.frames[above];
    if (f.joint < 0) continue;
    const Pose& pose = base_from_frame[above];
    const Vec3 arm = point_in_base - pose.translation();
    const Vec3 axis = scaled_axis(f, pose);
    jacobian.col(f.joint) += f.prismatic ? axis : axis.cross(arm);
  }
}

void add_point_gradient(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                        int frame, int ancestor, const Vec3& point_in_base, const Vec3& direction,
                        Eigen::Ref<JointVector> slope) {
  assert(slope.size() >= std::ssize(robot.joint_names));
  while (frame != ancestor) {
    const RobotModel::Frame& f = robot.frames[frame];
    if (f.joint >= 0) {
      const Pose& pose = base_from_frame[frame];
      const Vec3 arm = point_in_base - pose.translation();
      slope[f.joint] += scaled_axis(f, pose).dot(f.prismatic ? direction : arm.cross(direction));
    }
    frame = f.parent;
  }
}

void tip_jacobians(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                   Eigen::Ref<Eigen::MatrixXd> jacobian) {
  assert(jacobian.rows() == 6 * std::ssize(robot.tips));
  assert(jacobian.cols() == std::ssize(robot.joint_names));
  jacobian.setZero();
  for (Eigen::Index i = 0; i < std::ssize(robot.tips); ++i) {
    const RobotModel::Tip& tip = robot.tips[i];
    if (tip.frame < 0) continue;
    const Vec3 point = base_from_frame[tip.frame] * tip.transform.translation();
    for (const int frame : ancestors(robot, tip.frame)) {
      const RobotModel::Frame& f = robot.frames[frame];
      if (f.joint < 0) continue;
      const Pose& pose = base_from_frame[frame];
      const Vec3 axis = scaled_axis(f, pose);
      auto column = jacobian.block<6, 1>(6 * i, f.joint);
      if (f.prismatic) {
        column.head<3>() += axis;
      } else {
        column.head<3>() += axis.cross(point - pose.translation());
        column.tail<3>() += axis;
      }
    }
  }
}

}  // namespace morphe::robot
