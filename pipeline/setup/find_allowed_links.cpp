#include "pipeline/setup/find_allowed_links.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/math/random_stream.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/motion_bounds.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/setup/kinematics.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

constexpr double kTouch_m = 1e-5;  ///< shapes as near as this touch: rounding of files
/// Number of random postures of several joints. A pair that is apart in one of a thousand is then
/// excused with a probability of 2 %.
constexpr int kPostureCount = 4000;
constexpr std::size_t kMaxCornerJoints = 6;  ///< all combinations of the limits of so many joints
constexpr int kMaxSteps = 2000;              ///< of the proof for one joint; chosen by hand
/// A linkage's bars that are at most so far apart can hardly keep a margin of 1 mm.
constexpr double kLinkagePlay_m = 0.0015;

/// Two bodies, and the joints that move them relative to each other.
struct Pair {
  const RobotModel& robot;
  int first, second;
  const LinkBody &one, &other;
  std::vector<int> joints;
  std::vector<Pose> poses = {};

  Pose one_from_other(const JointVector& q) {
    robot::forward_kinematics(robot, q, poses);
    const Pose base_from_one = first < 0 ? Pose::Identity() : poses[first];
    return base_from_one.inverse() * (second < 0 ? Pose::Identity() : poses[second]);
  }
  double gap_m(const JointVector& q) { return one.mesh.distance(other.mesh, one_from_other(q)); }
  bool touch(const JointVector& q) {
    const Pose pose = one_from_other(q);
    return one.mesh.overlaps(other.mesh, pose) || one.mesh.distance(other.mesh, pose) <= kTouch_m;
  }
  double depth_m(const JointVector& q) { return overlap_depth_m(one, other, one_from_other(q)); }
};

std::vector<int> joints_between(const RobotModel& robot, int one, int other) {
  const int common = robot::common_ancestor(robot, one, other);
  std::set<int> joints;
  for (const int end : {one, other}) {
    for (const int f : robot::ancestors(robot, end)) {
      if (f == common) break;
      if (robot::joint_of(robot, f) >= 0) joints.insert(robot::joint_of(robot, f));
    }
  }
  return {joints.begin(), joints.end()};
}

/// Returns true if the pair's only joint moves both bodies, as in a mechanism.
bool moved_by_one_joint(const Pair& pair) {
  const int common = robot::common_ancestor(pair.robot, pair.first, pair.second);
  const auto moved = [&](int end) {
    const int frame = robot::moving_frame_of(pair.robot, end);
    return frame >= 0 && frame > common;
  };
  return pair.joints.size() == 1 && moved(pair.first) && moved(pair.second);
}

/// Returns the length by which a joint's unit moves the bodies relative to each other at most.
double lever_m(const Pair& pair, int joint) {
  double sum = 0;
  for (const auto& [frame, body] : {std::pair{pair.first, &pair.one}, {pair.second, &pair.other}})
    if (frame >= 0)
      sum += robot::sphere_motion_bounds(pair.robot, frame, Vec3::Zero(), body->radius_m)[joint];
  return sum;
}

/// Follows the only joint from limit to limit while the bodies overlap, in steps within which the
/// deepest point cannot leave the other body. Steps that would be too many are longer, and then
/// nothing is proved between them.
bool overlap_along_joint(Pair& pair, JointVector q, LinkPair& found) {
  const int j = pair.joints.front();
  const double lever = lever_m(pair, j), upper = pair.robot.upper[j];
  const double min_step = (upper - pair.robot.lower[j]) / kMaxSteps;
  found.proven = true;
  for (q[j] = pair.robot.lower[j];;) {
    ++found.postures;
    if (!pair.touch(q)) return false;
    if (q[j] >= upper) return true;
    const double safe_step = lever > 0 ? pair.depth_m(q) / lever : kInfinity;
    if (safe_step < min_step) found.proven = false;
    q[j] = std::min(upper, q[j] + std::max(safe_step, min_step));
  }
}

/// Tests all combinations of limits and rest, and random postures.
bool overlap_in_samples(Pair& pair, const JointVector& rest, LinkPair& found) {
  const RobotModel& robot = pair.robot;
  const std::size_t turned = std::min(pair.joints.size(), kMaxCornerJoints);
  const int corners = static_cast<int>(std::pow(3, turned));
  math::RandomStream random(1, fmt::format("{}/{}", pair.first, pair.second));
  JointVector q = rest;
  for (int k = 0; k < corners + kPostureCount; ++k) {
    for (std::size_t i = 0, digits = k; i < pair.joints.size(); ++i, digits /= 3) {
      const int j = pair.joints[i];
      const double at[] = {rest[j], robot.lower[j], robot.upper[j]};
      q[j] = k < corners ? at[digits % 3] : random.uniform(robot.lower[j], robot.upper[j]);
    }
    ++found.postures;
    if (!pair.touch(q)) return false;
  }
  return true;
}

/// Returns true if the bodies never part by more than the play of a linkage, in kMaxSteps / 5
/// postures of their joint.
bool stay_together(Pair& pair, JointVector q, LinkPair& found) {
  const int j = pair.joints.front();
  constexpr int kSweepSteps = kMaxSteps / 5;
  for (int k = 0; k <= kSweepSteps; ++k, ++found.postures) {
    q[j] = pair.robot.lower[j] + (pair.robot.upper[j] - pair.robot.lower[j]) * k / kSweepSteps;
    if (pair.gap_m(q) > kLinkagePlay_m) return false;
  }
  return true;
}

LinkPair judge(Pair pair, const JointVector& rest) {
  LinkPair found;
  found.first = pair.first;
  found.second = pair.second;
  found.joints_between = static_cast<int>(pair.joints.size());
  found.assumed = pair.one.assumed || pair.other.assumed;
  found.rest_gap_m = pair.gap_m(rest);
  if (found.rest_gap_m > kTouch_m) return found;
  found.rest_gap_m = 0;
  found.rest_depth_m = pair.depth_m(rest);
  found.excused = pair.joints.size() == 1 ? overlap_along_joint(pair, rest, found)
                                          : overlap_in_samples(pair, rest, found);
  if (!found.excused) found.proven = false;
  if (found.excused || !moved_by_one_joint(pair)) return found;
  found.excused = found.linkage = stay_together(pair, rest, found);
  return found;
}

bool is_allowed(const RobotModel& robot, int one, int other) {
  for (int i = 0; i < std::ssize(robot.capsules); ++i) {
    if (robot.capsules[i].frame != one) continue;
    for (int k = 0; k < std::ssize(robot.capsules); ++k) {
      if (robot.capsules[k].frame != other) continue;
      const std::array<int, 2> pair = {std::min(i, k), std::max(i, k)};
      return std::ranges::binary_search(robot.allowed_collision_pairs, pair);
    }
  }
  return true;
}

std::string reason(const LinkPair& pair) {
  const std::string by = pair.assumed ? "no shapes: by assumed capsules, " : "";
  if (pair.linkage)
    return fmt::format("{}bars of one mechanism: apart by at most {:.1f} mm in {} postures", by,
                       1e3 * kLinkagePlay_m, pair.postures);
  return fmt::format("{}in all postures ({})", by,
                     pair.proven ? "proved" : fmt::format("{} tested", pair.postures));
}

}  // namespace

std::vector<LinkPair> judge_pairs(const RobotModel& robot, const LinkBodies& bodies) {
  const JointVector rest = rest_position(robot);
  std::vector<LinkPair> pairs;
  for (auto one = bodies.begin(); one != bodies.end(); ++one) {
    for (auto other = std::next(one); other != bodies.end(); ++other) {
      if (is_allowed(robot, one->first, other->first)) continue;
      pairs.push_back(judge({robot, one->first, other->first, one->second, other->second,
                             joints_between(robot, one->first, other->first)},
                            rest));
    }
  }
  return pairs;
}

std::string allowed_links_yaml(const std::vector<LinkPair>& pairs,
                               const std::function<std::string(int)>& name_of_frame) {
  std::string text;
  for (const LinkPair& pair : pairs) {
    if (!pair.excused) continue;
    text += fmt::format("    - [{}, {}]  # the shapes overlap at rest by {:.1f} mm; {}\n",
                        yaml_name(name_of_frame(pair.first)), yaml_name(name_of_frame(pair.second)),
                        1e3 * pair.rest_depth_m, reason(pair));
  }
  return text.empty() ? "" : "  allowed_links:\n" + text;
}

}  // namespace morphe::setup
