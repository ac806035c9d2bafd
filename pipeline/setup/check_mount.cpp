#include "pipeline/setup/check_mount.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/collision/distance.hpp"
#include "core/math/random_stream.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {
namespace {

constexpr int kWristPostureCount = 100;
constexpr int kPosturesWithout = 5;  ///< in which the hand may be clear, 5 %

/// Returns random postures of the arm, with the joints beyond the flange at rest.
std::vector<std::vector<Pose>> wrist_postures(const RobotModel& robot, int flange_frame) {
  math::RandomStream random(1, "mount");
  std::vector<std::vector<Pose>> postures(kWristPostureCount);
  for (std::vector<Pose>& poses : postures) {
    JointVector q = rest_position(robot);
    for (int j = 0; j < q.size(); ++j)
      if (robot::joint_moves_frame(robot, j, flange_frame))
        q[j] = random.uniform(robot.lower[j], robot.upper[j]);
    robot::forward_kinematics(robot, q, poses);
  }
  return postures;
}

collision::CapsuleBody body_of(const RobotModel::Capsule& c, const std::vector<Pose>& poses) {
  if (c.frame < 0) return {c.from, c.to, c.radius};
  return {poses[c.frame] * c.from, poses[c.frame] * c.to, c.radius};
}

/// Returns the depth that two capsules exceed in all postures but a few [m].
double usual_depth(const RobotModel& robot, const std::vector<std::vector<Pose>>& postures, int one,
                   int other) {
  std::vector<double> depths;
  for (const std::vector<Pose>& poses : postures)
    depths.push_back(-collision::capsule_capsule(body_of(robot.capsules[one], poses),
                                                 body_of(robot.capsules[other], poses))
                          .distance);
  std::ranges::nth_element(depths, depths.begin() + kPosturesWithout);
  return depths[kPosturesWithout];
}

}  // namespace

std::optional<MountCollision> find_mount_collision(const RobotModel& robot, int flange_frame,
                                                   const std::function<bool(int)>& of_arm) {
  const auto postures = wrist_postures(robot, flange_frame);
  const int mounting_link = robot::moving_frame_of(robot, flange_frame);
  std::optional<MountCollision> worst;
  for (int hand = 0; hand < std::ssize(robot.capsules); ++hand) {
    if (of_arm(hand)) continue;
    for (int arm = 0; arm < std::ssize(robot.capsules); ++arm) {
      const bool carries =
          robot::moving_frame_of(robot, robot.capsules[arm].frame) == mounting_link;
      if (!of_arm(arm) || carries) continue;
      const double depth_m = usual_depth(robot, postures, hand, arm);
      if (depth_m <= kMaxMountDepth_m) continue;
      const double thinner_m = std::min(robot.capsules[hand].radius, robot.capsules[arm].radius);
      const MountCollision found{hand, arm, depth_m, depth_m > thinner_m + kMaxMountDepth_m};
      const auto order = [](const MountCollision& c) {
        return std::pair(c.stands_inside, c.depth_m);
      };
      if (!worst || order(*worst) < order(found)) worst = found;
    }
  }
  return worst;
}

}  // namespace morphe::setup
