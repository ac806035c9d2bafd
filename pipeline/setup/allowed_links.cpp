#include "pipeline/setup/allowed_links.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/collision/distance.hpp"
#include "core/math/random_stream.hpp"
#include "core/robot/forward.hpp"
#include "core/robot/tree.hpp"

namespace morphe::setup {
namespace {

constexpr int kPostures = 400;
constexpr double kAlways = 0.95;
constexpr double kTouch_m = 0.0015;  ///< nearer than this a margin of 1 mm is hardly kept
constexpr double kDeepAtRest_m = 0.004;
constexpr std::size_t kNearJoints = 3;  ///< between links that may overlap at rest

struct Sampler {
  const RobotTable& robot;
  std::map<int, std::vector<int>> capsules;  ///< of each frame
  std::vector<Pose> poses = {};

  /// How deep capsules of two frames overlap at most, < 0: how far apart they are.
  double overlap(int one, int other, const JointVector& q) {
    robot::forward(robot, q, poses);
    const auto body = [&](int k) -> collision::CapsuleBody {
      const RobotTable::Capsule& c = robot.capsules[static_cast<std::size_t>(k)];
      if (c.frame < 0) return {c.from, c.to, c.radius};
      const Pose& pose = poses[static_cast<std::size_t>(c.frame)];
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
  /// Joints that move one of two frames but not both alike.
  std::set<int> joints_between(int one, int other) const {
    const int both = robot::common_ancestor(robot, one, other);
    std::set<int> joints;
    for (const int end : {one, other}) {
      for (const int f : robot::upwards(robot, end)) {
        if (f == both) break;
        if (robot::joint_of(robot, f) >= 0) joints.insert(robot::joint_of(robot, f));
      }
    }
    return joints;
  }
  /// Both are moved, and by one joint alone: parts of one mechanism.
  bool one_linkage(int one, int other, const std::set<int>& joints) const {
    const int both = robot::common_ancestor(robot, one, other);
    const auto moved = [&](int end) {
      return robot::body_of(robot, end) >= 0 && robot::body_of(robot, end) > both;
    };
    return joints.size() == 1 && moved(one) && moved(other);
  }
  bool allowed_already(int one, int other) const {
    for (const int first : capsules.at(one)) {
      for (const int second : capsules.at(other)) {
        const std::array<int, 2> pair = {std::min(first, second), std::max(first, second)};
        if (!std::ranges::binary_search(robot.allowed_pairs, pair)) return false;
      }
    }
    return true;
  }
  std::string name(int frame) const {
    return frame < 0 ? "base" : robot.frames[static_cast<std::size_t>(frame)].name;
  }
};

}  // namespace

std::vector<AllowedPair> allowed_links(const RobotTable& robot) {
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
      if (sampler.allowed_already(pair.one, pair.other)) continue;
      const std::set<int> joints = sampler.joints_between(pair.one, pair.other);
      pair.deepest_m = sampler.overlap(pair.one, pair.other, rest);
      math::RandomStream random(1, sampler.name(pair.one) + "/" + sampler.name(pair.other));
      int overlapping = 0, drawn = 0;
      JointVector q = rest;
      for (; drawn < kPostures; ++drawn) {
        if (drawn - overlapping > (1 - kAlways) * kPostures) break;  // 95 % are out of reach
        for (const int j : joints) q[j] = random.uniform(robot.lower[j], robot.upper[j]);
        overlapping += sampler.overlap(pair.one, pair.other, q) > -kTouch_m;
      }
      pair.share = static_cast<double>(overlapping) / drawn;
      const bool always = drawn == kPostures;
      const bool linkage = overlapping > 0 && sampler.one_linkage(pair.one, pair.other, joints);
      const bool at_rest = pair.deepest_m > kDeepAtRest_m && joints.size() <= kNearJoints;
      if (always || at_rest || linkage) allowed.push_back(pair);
    }
  }
  return allowed;
}

}  // namespace morphe::setup
