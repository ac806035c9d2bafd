#include "pipeline/setup/opposition.hpp"

#include <algorithm>
#include <numbers>
#include <string>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/setup/finger_bodies.hpp"

namespace morphe::setup {
namespace {

/// Distance of two ends that oppose each other, relative to the greatest distance of an end from
/// the palm. Chosen by hand: the ends of jaws meet, and a propeller behind the jaws stays at 0.5.
constexpr double kMaxOpposedShare = 0.4;

bool turns_freely(const Kinematics& robot, const Finger& finger) {
  constexpr double kTurn_rad = 2 * std::numbers::pi - 1e-3;
  return std::ranges::all_of(finger.frames, [&](int f) {
    const RobotModel::Frame& frame = robot.frame(f);
    const double range = robot.table().upper[frame.joint] - robot.table().lower[frame.joint];
    return !frame.prismatic && std::abs(frame.ratio) * range > kTurn_rad;
  });
}

bool has_body(const Kinematics& robot, const Finger& finger, const BodyPoints& points) {
  const auto carries = [&](int f) {
    return points.contains(f) || robot.model->inertias.contains(robot.link[f]);
  };
  const std::ptrdiff_t frames = std::ssize(robot.table().frames);
  for (int f = finger.frames.front(); f < frames; ++f)
    if (robot::is_in_subtree(robot.table(), f, finger.frames.front()) && carries(f)) return true;
  return find_urdf_tip(robot, finger.body, points) >= 0;
}

/// Returns true if a chain has a body, or joints away from the palm's origin.
bool has_extent(const Kinematics& robot, int root, const Finger& finger, const BodyPoints& points) {
  const Vec3 palm = robot.pose(root).translation();
  const auto is_away = [&](int f) { return (robot.pose(f).translation() - palm).norm() > 1e-3; };
  return std::ranges::any_of(finger.frames, is_away) || has_body(robot, finger, points);
}

/// Returns the end of a finger in sampled postures: all its joints at the same share of their
/// ranges, and each joint by itself at both ends of its range.
std::vector<Vec3> sampled_ends(const Kinematics& robot, const Finger& finger,
                               const BodyPoint& end) {
  constexpr int kShares = 4;
  const RobotModel& table = robot.table();
  std::vector<JointVector> postures = {robot.rest};
  for (int i = 0; i <= kShares; ++i) {
    JointVector& q = postures.emplace_back(robot.rest);
    const double share = static_cast<double>(i) / kShares;
    for (const int f : finger.frames) {
      const int joint = robot.frame(f).joint;
      q[joint] = (1 - share) * table.lower[joint] + share * table.upper[joint];
    }
  }
  for (const int f : finger.frames)
    for (const JointVector* limit : {&table.lower, &table.upper})
      postures.emplace_back(robot.rest)[robot.frame(f).joint] = (*limit)[robot.frame(f).joint];
  std::vector<Vec3> ends;
  std::vector<Pose> poses;
  for (const JointVector& q : postures) {
    robot::forward_kinematics(table, q, poses);
    ends.push_back(end.at(poses));
  }
  return ends;
}

double least_distance(const std::vector<Vec3>& some, const std::vector<Vec3>& others) {
  double least_m = kInfinity;
  for (const Vec3& one : some)
    for (const Vec3& other : others) least_m = std::min(least_m, (one - other).norm());
  return least_m;
}

/// Moves the fingers for which `idle` is true to `left`, unless less than `remaining` would remain.
template <class Idle>
void move_idle(std::vector<Finger>& fingers, const Idle& idle, const std::string& reason,
               std::ptrdiff_t remaining, std::vector<LeftOut>& left) {
  std::vector<Finger> kept;
  std::vector<LeftOut> moved;
  for (std::ptrdiff_t i = 0; i < std::ssize(fingers); ++i) {
    if (idle(i)) {
      moved.push_back({fingers[i].body, reason});
    } else {
      kept.push_back(fingers[i]);
    }
  }
  if (std::ssize(kept) < remaining) return;
  fingers = std::move(kept);
  left.insert(left.end(), moved.begin(), moved.end());
}

}  // namespace

std::vector<LeftOut> leave_out_idle_chains(const Kinematics& robot, int root,
                                           const BodyPoints& points, std::vector<Finger>& fingers) {
  std::vector<LeftOut> left;
  move_idle(
      fingers, [&](std::ptrdiff_t i) { return !has_extent(robot, root, fingers[i], points); },
      "it has no extent", 0, left);
  move_idle(
      fingers, [&](std::ptrdiff_t i) { return turns_freely(robot, fingers[i]); }, "it turns freely",
      1, left);
  move_idle(
      fingers, [&](std::ptrdiff_t i) { return !has_body(robot, fingers[i], points); },
      "it has no body", 1, left);
  const Vec3 palm = robot.pose(root).translation();
  std::vector<std::vector<Vec3>> ends;
  double size_m = 0;
  bool measured = true;
  for (const Finger& finger : fingers) {
    const BodyPoint end = body_end(robot, finger, points, palm);
    size_m = std::max(size_m, (end.at(robot.base_from_frame) - palm).norm());
    measured = measured && end.sure == Provenance::derived;
    ends.push_back(sampled_ends(robot, finger, end));
  }
  const auto opposes_nothing = [&](std::ptrdiff_t i) {
    for (std::ptrdiff_t k = 0; k < std::ssize(ends); ++k)
      if (k != i && least_distance(ends[i], ends[k]) < kMaxOpposedShare * size_m) return false;
    return true;
  };
  if (measured)
    move_idle(fingers, opposes_nothing, "its end comes near to no other finger's", 2, left);
  return left;
}

}  // namespace morphe::setup
