#include "pipeline/kinematics/forward.hpp"

#include <cassert>
#include <cmath>

namespace morphe {
namespace {

/// pose * Rotation(axis, angle); turning about z, as every DH joint does, touches two columns only.
void turn(Pose& pose, const Vec3& axis, double angle) {
  if (axis.z() == 1) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Vec3 x = pose.linear().col(0), y = pose.linear().col(1);
    pose.linear().col(0) = c * x + s * y;
    pose.linear().col(1) = c * y - s * x;
  } else {
    const Eigen::Matrix3d turned =
        pose.linear() * Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    pose.linear() = turned;
  }
}

}  // namespace

void forward(const RobotTable& robot, const Eigen::Ref<const JointVector>& q,
             std::vector<Pose>& base_from_frame) {
  assert(q.size() == static_cast<Eigen::Index>(robot.joints()));
  base_from_frame.resize(robot.frames.size());
  for (std::size_t i = 0; i < robot.frames.size(); ++i) {
    const RobotTable::Frame& frame = robot.frames[i];
    assert(frame.parent < static_cast<int>(i));
    Pose& pose = base_from_frame[i];
    if (frame.parent < 0) {
      pose = frame.transform;
    } else {
      const Pose& parent = base_from_frame[static_cast<std::size_t>(frame.parent)];
      pose.linear().noalias() = parent.linear() * frame.transform.linear();
      pose.translation().noalias() = parent.linear() * frame.transform.translation();
      pose.translation() += parent.translation();
    }
    if (frame.joint >= 0) turn(pose, frame.axis, frame.ratio * q[frame.joint] + frame.offset);
  }
}

Pose tip_pose(const RobotTable& robot, const std::vector<Pose>& base_from_frame, std::size_t tip) {
  const RobotTable::Tip& t = robot.tips[tip];
  if (t.frame < 0) return t.transform;
  return base_from_frame[static_cast<std::size_t>(t.frame)] * t.transform;
}

void point_jacobian(const RobotTable& robot, const std::vector<Pose>& base_from_frame, int frame,
                    const Vec3& point_in_base, Eigen::Ref<Eigen::Matrix3Xd> jacobian) {
  assert(jacobian.cols() == static_cast<Eigen::Index>(robot.joints()));
  jacobian.setZero();
  while (frame >= 0) {
    const RobotTable::Frame& f = robot.frames[static_cast<std::size_t>(frame)];
    if (f.joint >= 0) {
      const Pose& pose = base_from_frame[static_cast<std::size_t>(frame)];
      const Vec3 axis_in_base = pose.linear() * f.axis;
      const Vec3 arm = point_in_base - pose.translation();
      jacobian.col(f.joint) += f.ratio * axis_in_base.cross(arm);
    }
    frame = f.parent;
  }
}

void rotation_jacobian(const RobotTable& robot, const std::vector<Pose>& base_from_frame, int frame,
                       Eigen::Ref<Eigen::Matrix3Xd> jacobian) {
  assert(jacobian.cols() == static_cast<Eigen::Index>(robot.joints()));
  jacobian.setZero();
  while (frame >= 0) {
    const RobotTable::Frame& f = robot.frames[static_cast<std::size_t>(frame)];
    if (f.joint >= 0) {
      const Pose& pose = base_from_frame[static_cast<std::size_t>(frame)];
      jacobian.col(f.joint) += f.ratio * (pose.linear() * f.axis);
    }
    frame = f.parent;
  }
}

}  // namespace morphe
