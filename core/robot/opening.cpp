#include "core/robot/opening.hpp"

#include <algorithm>
#include <set>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {
namespace {

constexpr int kStepCount = 40;    ///< of a joint's range
constexpr int kMaxSweeps = 4;     ///< over all joints; chosen by hand, a gripper needs one
constexpr double kGain_m = 1e-6;  ///< smaller improvements end the search

struct Search {
  const RobotModel& robot;
  std::ptrdiff_t thumb, index;  ///< tips
  std::set<int> joints;         ///< that move one tip relative to the other
  double enough_m = kInfinity;
  std::vector<Pose> poses = {};

  double opening_at(const JointVector& q) {
    forward_kinematics(robot, q, poses);
    return (tip_pose(robot, poses, thumb).translation() -
            tip_pose(robot, poses, index).translation())
        .norm();
  }

  /// Moves one joint to the best of its positions, and returns the opening there.
  double improve(int joint, JointVector& q, double best_m) {
    JointVector trial = q;
    for (int step = 0; step <= kStepCount; ++step) {
      const double share = static_cast<double>(step) / kStepCount;
      trial[joint] = (1 - share) * robot.lower[joint] + share * robot.upper[joint];
      const double opening_m = opening_at(trial);
      if (opening_m <= best_m + kGain_m) continue;
      best_m = opening_m;
      q[joint] = trial[joint];
    }
    return best_m;
  }

  double widest_from(JointVector q) {
    double best_m = opening_at(q);
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
      const double before_m = best_m;
      for (const int joint : joints)
        if (best_m < enough_m) best_m = improve(joint, q, best_m);
      if (best_m <= before_m + kGain_m) break;
    }
    return best_m;
  }
};

std::ptrdiff_t tip_of(const RobotModel& robot, int finger) {
  const auto found = std::ranges::find(robot.tips, finger, &RobotModel::Tip::finger);
  return found == robot.tips.end() ? -1 : found - robot.tips.begin();
}

/// Returns the joints of the frames from the tips up to their first common ancestor.
std::set<int> joints_between(const RobotModel& robot, int one, int other) {
  std::set<int> joints;
  for (const auto& [from, to] : {std::pair(one, other), std::pair(other, one)})
    for (const int f : ancestors(robot, from))
      if (!is_in_subtree(robot, to, f) && joint_of(robot, f) >= 0)
        joints.insert(joint_of(robot, f));
  return joints;
}

}  // namespace

double widest_opening(const RobotModel& robot, double enough_m) {
  const std::ptrdiff_t thumb = tip_of(robot, 0), index = tip_of(robot, 1);
  if (thumb < 0 || index < 0) return kUnknown;
  Search search{robot, thumb, index,
                joints_between(robot, robot.tips[thumb].frame, robot.tips[index].frame), enough_m};
  const JointVector rest =
      JointVector::Zero(robot.lower.size()).cwiseMax(robot.lower).cwiseMin(robot.upper);
  double widest_m = 0;
  for (const JointVector& start : {rest, robot.lower, robot.upper})
    if (widest_m < enough_m) widest_m = std::max(widest_m, search.widest_from(start));
  return widest_m;
}

}  // namespace morphe::robot
