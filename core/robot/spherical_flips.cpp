#include "core/robot/spherical_flips.hpp"

#include <cmath>
#include <numbers>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {
namespace {

/// Cosine below which two axes are orthogonal. Descriptions round π/2 to 1.5708 or 1.57, which is
/// 0.0008 off: a flip then moves a palm at a metre by about as many metres. No arm is known whose
/// axes are inclined on purpose by that little.
constexpr double kOrthogonalityTolerance = 1e-3;

int previous_joint_frame(const RobotModel& robot, int frame) {
  return moving_frame_of(robot, robot.frames[frame].parent);
}

}  // namespace

std::vector<SphericalFlip> possible_flips(const RobotModel& robot) {
  std::vector<Pose> base_from_frame;
  forward_kinematics(robot, JointVector::Zero(robot.lower.size()), base_from_frame);
  const auto axis = [&](int frame) -> Vec3 {
    return base_from_frame[frame].linear() * robot.frames[frame].axis;
  };
  std::vector<SphericalFlip> flips;
  for (int last = 0; last < std::ssize(robot.frames); ++last) {
    const RobotModel::Frame& frame = robot.frames[last];
    const int middle = frame.joint < 0 ? -1 : previous_joint_frame(robot, last);
    const int first = middle < 0 ? -1 : previous_joint_frame(robot, middle);
    if (first < 0) continue;
    const Vec3 a = axis(first), b = axis(middle), c = axis(last);
    if (std::abs(a.dot(b)) > kOrthogonalityTolerance ||
        std::abs(c.dot(b)) > kOrthogonalityTolerance)
      continue;
    const RobotModel::Frame& hinge = robot.frames[middle];
    const double angle = std::atan2(b.dot(c.cross(a)), c.dot(a));  // turns c to a about b
    flips.push_back({robot.frames[first].joint, hinge.joint, frame.joint, angle / hinge.ratio});
  }
  return flips;
}

JointVector apply_flip(const SphericalFlip& flip, JointVector q) {
  q[flip.first] += std::numbers::pi;
  q[flip.middle] = 2 * flip.parallel_rad - q[flip.middle];
  q[flip.last] += std::numbers::pi;
  return q;
}

}  // namespace morphe::robot
