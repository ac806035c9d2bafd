#include "stages/certify/wrist_speed.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/humanlike/arm_posture.hpp"
#include "core/math/statistics.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/certify/trajectory_motion.hpp"

namespace morphe::certify {
namespace {

/// Returns the first time at which a trajectory reaches a demonstration time, within its ends.
double time_reached(const Trajectory& trajectory, double demonstration_s) {
  const std::vector<double>& clock = trajectory.demonstration_time;
  const auto next = std::ranges::lower_bound(clock, demonstration_s);
  if (next == clock.begin()) return trajectory.time.front();
  if (next == clock.end()) return trajectory.time.back();
  const std::ptrdiff_t after = next - clock.begin();
  const double share = (demonstration_s - clock[after - 1]) / (clock[after] - clock[after - 1]);
  return std::lerp(trajectory.time[after - 1], trajectory.time[after], share);
}

/// A wrist's way: its positions at times.
struct WristPath {
  std::vector<double> time;
  std::vector<Vec3> position;

  /// Returns the mean velocity's magnitude between the neighbours of an instant [m/s].
  double speed_at(std::ptrdiff_t k) const {
    return (position[k + 1] - position[k - 1]).norm() / (time[k + 1] - time[k - 1]);
  }
};

WristPath robot_wrist(const robot::Robot& robot, const Goals& goals, const Trajectory& trajectory) {
  const collision::JointMotion motion = trajectory_motion(trajectory);
  WristPath path;
  JointVector q;
  std::vector<Pose> base_from_frame;
  for (const double demonstration_s : goals.time) {
    path.time.push_back(time_reached(trajectory, demonstration_s));
    motion.position(path.time.back(), q);
    robot::forward_kinematics(robot, q, base_from_frame);
    path.position.push_back(humanlike::arm_points(robot, base_from_frame).wrist);
  }
  return path;
}

}  // namespace

double wrist_speed_correlation(const robot::Robot& robot, const Goals& goals,
                               const Trajectory& trajectory) {
  if (goals.wrist_position.size() != goals.frames() || trajectory.samples() < 2) return kUnknown;
  const WristPath human{goals.time, goals.wrist_position};
  const WristPath own = robot_wrist(robot, goals, trajectory);
  std::vector<double> human_speed, own_speed;
  for (std::ptrdiff_t k = 1; k + 1 < std::ssize(human.time); ++k) {
    const double expected = human.speed_at(k), driven = own.speed_at(k);
    if (!std::isfinite(expected) || !std::isfinite(driven)) continue;
    human_speed.push_back(expected);
    own_speed.push_back(driven);
  }
  if (human_speed.size() < 2 || std::ranges::max(human_speed) <= kMinWristSpeed_m_s ||
      std::ranges::max(own_speed) <= kMinWristSpeed_m_s)
    return kUnknown;
  return math::correlation(human_speed, own_speed);
}

}  // namespace morphe::certify
