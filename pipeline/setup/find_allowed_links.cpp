#include "pipeline/setup/find_allowed_links.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/random_stream.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/setup/kinematics.hpp"
#include "pipeline/setup/moved_pair.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

/// Number of random postures of several joints. A pair that is apart in one of a thousand is then
/// excused with a probability of 2 %.
constexpr int kPostureCount = 4000;
constexpr std::size_t kMaxCornerJoints = 6;  ///< all combinations of the limits of so many joints

/// Tests all combinations of limits and rest, and random postures.
bool overlap_in_samples(MovedPair& pair, const JointVector& rest, LinkPair& found) {
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

/// Judges bodies that overlap at rest.
void judge_overlap(MovedPair& pair, const JointVector& rest, LinkPair& found) {
  found.rest_depth_m = pair.depth_m(rest);
  if (pair.joints.size() != 1) {
    found.excused = overlap_in_samples(pair, rest, found);
    return;
  }
  const JointSweep sweep = keeps_overlapping(pair, rest);
  found.postures = sweep.postures;
  found.excused = sweep.holds;
  found.proven = sweep.proven;
  if (found.excused || !moved_by_one_joint(pair)) return;
  const JointSweep bars = keeps_together(pair, rest);
  found.postures += bars.postures;
  found.excused = found.linkage = bars.holds;
}

/// Judges bodies that are apart at rest. Assumed capsules prove nothing of the shapes.
void judge_gap(MovedPair& pair, const JointVector& rest, LinkPair& found) {
  if (pair.joints.size() != 1 || found.assumed) return;
  const JointSweep sweep = keeps_apart(pair, rest);
  found.postures = sweep.postures;
  found.excused = found.proven = sweep.holds;
  if (sweep.holds) found.least_gap_m = sweep.least_gap_m;
}

/// The robot at rest, whose poses are computed once for all pairs.
struct Rest {
  JointVector position;
  std::vector<Pose> base_from_frame;

  Pose pose(int frame) const { return frame < 0 ? Pose::Identity() : base_from_frame[frame]; }
};

/// Judges the bodies of two frames. Most pairs are apart at rest with several joints between them,
/// of which nothing else is asked.
LinkPair judge(const RobotModel& robot, const LinkBodies& bodies, int first, int second,
               const Rest& rest) {
  const LinkBody &one = bodies.at(first), &other = bodies.at(second);
  LinkPair found;
  found.first = first;
  found.second = second;
  found.joints_between = static_cast<int>(joints_between(robot, first, second).size());
  found.assumed = one.assumed || other.assumed;
  found.rest_gap_m = one.mesh.distance(other.mesh, rest.pose(first).inverse() * rest.pose(second));
  if (found.rest_gap_m <= kTouch_m) found.rest_gap_m = 0;
  if (found.rest_gap_m > 0 && found.joints_between != 1) return found;
  MovedPair pair = moved_pair(robot, bodies, first, second);
  found.rest_gap_m > 0 ? judge_gap(pair, rest.position, found)
                       : judge_overlap(pair, rest.position, found);
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
  if (pair.least_gap_m > 0)
    return fmt::format(
        "the shapes never touch: proved over the whole range of their joint, least distance {} mm",
        least_distance_text(pair));
  const std::string overlap =
      fmt::format("the shapes overlap at rest by {:.1f} mm; {}", 1e3 * pair.rest_depth_m,
                  pair.assumed ? "no shapes: by assumed capsules, " : "");
  if (pair.linkage)
    return fmt::format("{}bars of one mechanism: apart by at most {:.1f} mm in {} postures",
                       overlap, 1e3 * kLinkagePlay_m, pair.postures);
  return fmt::format("{}in all postures ({})", overlap,
                     pair.proven ? "proved" : fmt::format("{} tested", pair.postures));
}

}  // namespace

std::string least_distance_text(const LinkPair& pair) {
  return fmt::format("{:.2f}", std::floor(1e5 * pair.least_gap_m) / 100);
}

std::vector<LinkPair> judge_pairs(const RobotModel& robot, const LinkBodies& bodies) {
  Rest rest{rest_position(robot), {}};
  robot::forward_kinematics(robot, rest.position, rest.base_from_frame);
  std::vector<LinkPair> pairs;
  for (auto one = bodies.begin(); one != bodies.end(); ++one) {
    for (auto other = std::next(one); other != bodies.end(); ++other) {
      if (is_allowed(robot, one->first, other->first)) continue;
      pairs.push_back(judge(robot, bodies, one->first, other->first, rest));
    }
  }
  return pairs;
}

std::string allowed_links_yaml(const std::vector<LinkPair>& pairs,
                               const std::function<std::string(int)>& name_of_frame) {
  std::string text;
  for (const LinkPair& pair : pairs) {
    if (!pair.excused) continue;
    text += fmt::format("    - [{}, {}]  # {}\n", yaml_name(name_of_frame(pair.first)),
                        yaml_name(name_of_frame(pair.second)), reason(pair));
  }
  return text.empty() ? "" : "  allowed_links:\n" + text;
}

}  // namespace morphe::setup
