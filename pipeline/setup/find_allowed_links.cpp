#include "pipeline/setup/find_allowed_links.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/collision/distance.hpp"
#include "core/math/random_stream.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/setup/kinematics.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

constexpr int kPostureCount = 400;
constexpr double kAlwaysShare = 0.95;
constexpr double kOverlapDistance_m = 0.0015;  ///< nearer frames can hardly keep a margin of 1 mm
constexpr double kMaxRestPenetration_m = 0.004;
constexpr std::size_t kMaxJointsBetween = 3;  ///< between links that may overlap at rest

struct Sampler {
  const RobotModel& robot;
  std::map<int, std::vector<int>> capsules;  ///< capsules of each frame
  std::vector<Pose> poses = {};

  /// Returns the largest penetration of two frames' capsules [m], negative if they are apart.
  double penetration_depth(int one, int other, const JointVector& q) {
    robot::forward_kinematics(robot, q, poses);
    const auto body = [&](int k) -> collision::CapsuleBody {
      const RobotModel::Capsule& c = robot.capsules[k];
      if (c.frame < 0) return {c.from, c.to, c.radius};
      const Pose& pose = poses[c.frame];
      return {pose * c.from, pose * c.to, c.radius};
    };
    double deepest = -HUGE_VAL;
    for (const int first : capsules.at(one))
      for (const int second : capsules.at(other))
        deepest =
            std::max(deepest, -collision::capsule_capsule(body(first), body(second)).distance);
    return deepest;
  }
  /// Returns the joints that move the two frames relative to each other.
  std::set<int> joints_between(int one, int other) const {
    const int common = robot::common_ancestor(robot, one, other);
    std::set<int> joints;
    for (const int end : {one, other}) {
      for (const int f : robot::ancestors(robot, end)) {
        if (f == common) break;
        if (robot::joint_of(robot, f) >= 0) joints.insert(robot::joint_of(robot, f));
      }
    }
    return joints;
  }
  /// Returns true if one joint, the only one of `joints`, moves both frames, as in a mechanism.
  bool moved_by_one_joint(int one, int other, const std::set<int>& joints) const {
    const int common = robot::common_ancestor(robot, one, other);
    const auto moved = [&](int end) {
      return robot::moving_frame_of(robot, end) >= 0 && robot::moving_frame_of(robot, end) > common;
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
  for (int k = 0; k < std::ssize(robot.capsules); ++k)
    sampler.capsules[robot.capsules[k].frame].push_back(k);
  std::vector<int> frames;
  for (const auto& [frame, own] : sampler.capsules) frames.push_back(frame);
  const JointVector rest = rest_position(robot);
  std::vector<AllowedPair> allowed;
  for (int i = 0; i < std::ssize(frames); ++i) {
    for (int k = i + 1; k < std::ssize(frames); ++k) {
      AllowedPair pair{frames[i], frames[k], 0, 0};
      if (sampler.is_allowed(pair.first, pair.second)) continue;
      const std::set<int> joints = sampler.joints_between(pair.first, pair.second);
      pair.rest_penetration_m = sampler.penetration_depth(pair.first, pair.second, rest);
      math::RandomStream random(1, sampler.name(pair.first) + "/" + sampler.name(pair.second));
      int overlapping = 0, drawn = 0;
      JointVector q = rest;
      for (; drawn < kPostureCount; ++drawn) {
        // kAlwaysShare cannot be reached any more.
        if (drawn - overlapping > (1 - kAlwaysShare) * kPostureCount) break;
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

std::string allowed_links_yaml(const std::vector<AllowedPair>& pairs,
                               const std::function<std::string(int)>& name_of_frame) {
  std::string text = pairs.empty() ? "" : "  allowed_links:\n";
  for (const AllowedPair& pair : pairs)
    text += fmt::format("    - [{}, {}]  # overlap in {:.0f} % of postures, at rest by {:.1f} mm\n",
                        yaml_name(name_of_frame(pair.first)), yaml_name(name_of_frame(pair.second)),
                        100 * pair.share, 1e3 * pair.rest_penetration_m);
  return text;
}

}  // namespace morphe::setup
