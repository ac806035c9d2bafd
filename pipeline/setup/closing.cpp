#include "pipeline/setup/closing.hpp"

#include <algorithm>
#include <set>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::setup {
namespace {

constexpr int kStepCount = 60;           ///< of a path: 1.4 mm for a gripper of 85 mm
constexpr double kMinStroke_m = 0.001;   ///< jaws that move less do not close
constexpr double kMaxPassedShare = 0.1;  ///< of the range, behind the closed posture: tolerance

struct JawPair {
  const Kinematics& robot;
  const std::array<BodyPoint, 2>& points;

  double distance_at(const JointVector& q) const {
    std::vector<Pose> poses;
    robot::forward_kinematics(robot.table(), q, poses);
    return (points[0].at(poses) - points[1].at(poses)).norm();
  }
};

std::set<int> joints_of(const Kinematics& robot, const std::vector<Finger>& jaws) {
  std::set<int> joints;
  for (const Finger& jaw : jaws)
    for (const int f : jaw.frames) joints.insert(robot.frame(f).joint);
  return joints;
}

/// Returns the posture in which each joint is at that end of its range at which the jaws are nearer
/// to each other, and that in which each is at the other end: closed and open.
std::array<JointVector, 2> ends_of_range(const JawPair& jaws, const std::set<int>& joints) {
  const RobotModel& table = jaws.robot.table();
  JointVector middle = jaws.robot.rest;
  for (const int joint : joints) middle[joint] = 0.5 * (table.lower[joint] + table.upper[joint]);
  std::array<JointVector, 2> ends = {jaws.robot.rest, jaws.robot.rest};
  for (const int joint : joints) {
    JointVector low = middle, high = middle;
    low[joint] = table.lower[joint];
    high[joint] = table.upper[joint];
    const bool closed_below = jaws.distance_at(low) < jaws.distance_at(high);
    ends[closed_below ? 0 : 1][joint] = table.lower[joint];
    ends[closed_below ? 1 : 0][joint] = table.upper[joint];
  }
  return ends;
}

/// Returns the step nearest to the rest position.
std::ptrdiff_t step_at_rest(const Kinematics& robot, const std::vector<JointVector>& path) {
  const auto nearest = std::ranges::min_element(
      path, {}, [&](const JointVector& q) { return (q - robot.rest).norm(); });
  return nearest - path.begin();
}

}  // namespace

std::optional<std::vector<JointVector>> closing_postures(const Kinematics& robot,
                                                         const std::vector<Finger>& jaws,
                                                         const std::array<BodyPoint, 2>& points) {
  const JawPair both{robot, points};
  const auto [closed, open] = ends_of_range(both, joints_of(robot, jaws));
  std::vector<JointVector> path;
  std::vector<double> distances_m;
  for (int i = 0; i <= kStepCount; ++i) {
    const double share = static_cast<double>(i) / kStepCount;
    path.emplace_back((1 - share) * open + share * closed);
    distances_m.push_back(both.distance_at(path.back()));
  }
  const auto nearest =
      static_cast<int>(std::ranges::min_element(distances_m) - distances_m.begin());
  const bool passes = nearest < (1 - kMaxPassedShare) * kStepCount;
  const bool measured =
      points[0].sure == Provenance::derived && points[1].sure == Provenance::derived;
  if (passes && !measured) return std::nullopt;
  if (passes && step_at_rest(robot, path) > nearest) {
    path.erase(path.begin(), path.begin() + nearest);
    std::ranges::reverse(path);
  } else {
    path.resize(static_cast<std::size_t>(nearest) + 1);
  }
  const double stroke_m = both.distance_at(path.front()) - both.distance_at(path.back());
  if (path.size() < 2 || stroke_m < kMinStroke_m) return std::nullopt;
  return path;
}

}  // namespace morphe::setup
