#include "pipeline/setup/find_allowed_links.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/collision/distance.hpp"
#include "core/math/random_stream.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::setup {
namespace {

constexpr int kPostureCount = 400;
constexpr double kAlwaysShare = 0.95;
/// Below this distance, a margin of 1 mm can hardly be kept.
constexpr double kOverlapDistance_m = 0.0015;
constexpr double kMaxRestPenetration_m = 0.004;
constexpr std::size_t kMaxJointsBetween = 3;  ///< between links that may overlap at rest

struct Sampler {
  const RobotModel& robot;
  std::map<int, std::vector<int>> capsules;  ///< capsules of each frame
  std::vector<Pose> poses = {};

  /// Returns the largest penetration depth of the capsules of two frames, negative if they are
  /// apart.
  double penetration_depth(int one, int other, const JointVector& q) {
    robot::forward_kinematics(robot, q, poses);
    const auto body = [&](int k) -> collision::CapsuleBody {
      const RobotModel::Capsule& c = robot.capsules[k];
      if (c.frame < 0) return {c.from, c.to, c.radius};
      const Pose& pose = poses[c.frame];
      return {pose * c.from, pose * c.to, c.radius};
    };
    double deepest = -HUGE_VAL;
    for (const int first : capsules.at(one)) {
      for (const int second : capsules.at(other)) {
        deepest =
            std::max(deepest, -collision::capsule_capsule(body(first), body(second)).distance);
      }
    }
    return deepest;
  }
  /// Returns the joints that move the two frames relative to each other.
  std::set<int> joints_between(int one, int other) const {
    const int both = robot::common_ancestor(robot, one, other);
    std::set<int> joints;
    for (const int end : {one, other}) {
      for (const int f : robot::ancestors(robot, end)) {
        if (f == both) break;
        if (robot::joint_of(robot, f) >= 0) joints.insert(robot::joint_of(robot, f));
      }
    }
    return joints;
  }
  /// Returns true if both frames are moved by one joint alone, that is, if they are parts of one
  /// mechanism.
  bool moved_by_one_joint(int one, int other, const std::set<int>& joints) const {
    const int both = robot::common_ancestor(robot, one, other);
    const auto moved = [&](int end) {
      return robot::moving_frame_of(robot, end) >= 0 && robot::moving_frame_of(robot, end) > both;
    };
    return joints.size() == 1 && moved(one) && moved(other);
  }
  bool is_allowed(int one, int other) const {
    for (const int first : capsules.at(one)) {
      for (const int second : capsules.at(other)) {
        const std::array<int, 2> pair = {std::min(first, second), std::max(first, second)};
        if (!std::ranges::binary_search(robot.allowed_collision_pairs, pair)) return false;
      }
    }
    return true;
  }
  std::string name(int frame) const { return frame < 0 ? "base" : robot.frames[frame].name; }
};

}  // namespace

std::vector<AllowedPair> find_allowed_links(const RobotModel& robot) {
  Sampler sampler{robot, {}};
  for (std::size_t k = 0; k < robot.capsules.size(); ++k) {
    sampler.capsules[robot.capsules[k].frame].push_back(static_cast<int>(k));
  }
  std::vector<int> frames;
  for (const auto& [frame, own] : sampler.capsules) frames.push_back(frame);
  const JointVector rest =
      JointVector::Zero(robot.lower.size()).cwiseMax(robot.lower).cwiseMin(robot.upper);
  std::vector<AllowedPair> allowed;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (std::size_t k = i + 1; k < frames.size(); ++k) {
      AllowedPair pair{frames[i], frames[k], 0, 0};
      if (sampler.is_allowed(pair.first, pair.second)) continue;
      const std::set<int> joints = sampler.joints_between(pair.first, pair.second);
      pair.rest_penetration_m = sampler.penetration_depth(pair.first, pair.second, rest);
      math::RandomStream random(1, sampler.name(pair.first) + "/" + sampler.name(pair.second));
      int overlapping = 0, drawn = 0;
      JointVector q = rest;
      for (; drawn < kPostureCount; ++drawn) {
        if (drawn - overlapping > (1 - kAlwaysShare) * kPostureCount)
          break;  // 95 % cannot be reached any more
        for (const int j : joints) q[j] = random.uniform(robot.lower[j], robot.upper[j]);
        overlapping += sampler.penetration_depth(pair.first, pair.second, q) > -kOverlapDistance_m;
      }
      pair.share = static_cast<double>(overlapping) / drawn;
      const bool always = drawn == kPostureCount;
      const bool linkage =
          overlapping > 0 && sampler.moved_by_one_joint(pair.first, pair.second, joints);
      const bool at_rest =
          pair.rest_penetration_m > kMaxRestPenetration_m && joints.size() <= kMaxJointsBetween;
      if (always || at_rest || linkage) allowed.push_back(pair);
    }
  }
  return allowed;
}

}  // namespace morphe::setup
