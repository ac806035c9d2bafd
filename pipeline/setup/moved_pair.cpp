#include "pipeline/setup/moved_pair.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/motion_bounds.hpp"
#include "core/robot/tree.hpp"

namespace morphe::setup {
namespace {

constexpr int kMaxSteps = 2000;  ///< of the proof for one joint; chosen by hand
/// Share of the least measured distance by which its lower bound may be less; chosen by hand: two
/// digits of it are shown.
constexpr double kGapTolerance = 0.02;

/// Appends the frames from below `common` to `end` to a branch; returns the index of the last one,
/// -1 without any.
int append_path(const RobotModel& robot, int common, int end, RobotModel& branch) {
  std::vector<int> path;
  for (int f = end; f != common; f = robot.frames[f].parent) path.push_back(f);
  int last = -1;
  for (auto f = path.rbegin(); f != path.rend(); ++f) {
    branch.frames.push_back(robot.frames[*f]);
    branch.frames.back().parent = last;
    last = static_cast<int>(branch.frames.size()) - 1;
  }
  return last;
}

/// Returns the length by which a joint's unit moves the bodies relative to each other at most.
double lever_m(const MovedPair& pair, int joint) {
  double sum = 0;
  for (const auto& [frame, body] : {std::pair{pair.first, &pair.one}, {pair.second, &pair.other}})
    if (frame >= 0)
      sum += robot::sphere_motion_bounds(pair.robot, frame, Vec3::Zero(), body->radius_m)[joint];
  return sum;
}

/// A part of a joint's range, and the distances of the bodies at its ends.
struct JointPart {
  double begin, begin_gap_m, end, end_gap_m;
};

}  // namespace

std::vector<int> joints_between(const RobotModel& robot, int one, int other) {
  const int common = robot::common_ancestor(robot, one, other);
  std::vector<int> joints;
  for (const int end : {one, other})
    for (int f = end; f != common; f = robot.frames[f].parent)
      if (robot::joint_of(robot, f) >= 0) joints.push_back(robot::joint_of(robot, f));
  std::ranges::sort(joints);
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  return joints;
}

Pose MovedPair::one_from_other(const JointVector& q) {
  robot::forward_kinematics(branch, q, poses);
  const auto pose = [&](int end) { return end < 0 ? Pose::Identity() : poses[end]; };
  return pose(one_end).inverse() * pose(other_end);
}

double MovedPair::gap_m(const JointVector& q) {
  return one.mesh.distance(other.mesh, one_from_other(q));
}

bool MovedPair::touch(const JointVector& q) {
  const Pose pose = one_from_other(q);
  return one.mesh.overlaps(other.mesh, pose) || one.mesh.distance(other.mesh, pose) <= kTouch_m;
}

double MovedPair::depth_m(const JointVector& q) {
  return overlap_depth_m(one, other, one_from_other(q));
}

MovedPair moved_pair(const RobotModel& robot, const LinkBodies& bodies, int first, int second) {
  MovedPair pair{robot,
                 first,
                 second,
                 bodies.at(first),
                 bodies.at(second),
                 joints_between(robot, first, second)};
  const int common = robot::common_ancestor(robot, first, second);
  pair.branch.joint_names = robot.joint_names;
  pair.one_end = append_path(robot, common, first, pair.branch);
  pair.other_end = append_path(robot, common, second, pair.branch);
  return pair;
}

bool moved_by_one_joint(const MovedPair& pair) {
  const int common = robot::common_ancestor(pair.robot, pair.first, pair.second);
  const auto moved = [&](int end) {
    const int frame = robot::moving_frame_of(pair.robot, end);
    return frame >= 0 && frame > common;
  };
  return pair.joints.size() == 1 && moved(pair.first) && moved(pair.second);
}

JointSweep keeps_overlapping(MovedPair& pair, JointVector q) {
  const int j = pair.joints.front();
  const double lever = lever_m(pair, j), upper = pair.robot.upper[j];
  const double min_step = (upper - pair.robot.lower[j]) / kMaxSteps;
  JointSweep sweep{.proven = true};
  for (q[j] = pair.robot.lower[j];;) {
    ++sweep.postures;
    if (!pair.touch(q)) return {.postures = sweep.postures};
    if (q[j] >= upper) break;
    const double safe_step = lever > 0 ? pair.depth_m(q) / lever : kInfinity;
    if (safe_step < min_step) sweep.proven = false;
    q[j] = std::min(upper, q[j] + std::max(safe_step, min_step));
  }
  sweep.holds = true;
  return sweep;
}

JointSweep keeps_apart(MovedPair& pair, JointVector q) {
  const int j = pair.joints.front();
  const double lever = lever_m(pair, j);
  double least_measured_m = kInfinity;
  JointSweep sweep{.least_gap_m = kInfinity};
  const auto gap_at = [&](double position) {
    ++sweep.postures;
    q[j] = position;
    const double gap = pair.gap_m(q);
    least_measured_m = std::min(least_measured_m, gap);
    return gap;
  };
  const double lower = pair.robot.lower[j], upper = pair.robot.upper[j];
  if (!std::isfinite(upper - lower)) return {};
  std::vector<JointPart> parts = {{lower, gap_at(lower), upper, gap_at(upper)}};
  while (!parts.empty()) {
    if (least_measured_m <= kTouch_m || sweep.postures >= kMaxSteps)
      return {.postures = sweep.postures};
    const JointPart part = parts.back();
    parts.pop_back();
    const double bound_m =
        0.5 * (part.begin_gap_m + part.end_gap_m - lever * (part.end - part.begin));
    if (bound_m >= (1 - kGapTolerance) * least_measured_m) {
      sweep.least_gap_m = std::min(sweep.least_gap_m, bound_m);
      continue;
    }
    const double middle = 0.5 * (part.begin + part.end), gap = gap_at(middle);
    parts.push_back({part.begin, part.begin_gap_m, middle, gap});
    parts.push_back({middle, gap, part.end, part.end_gap_m});
  }
  sweep.holds = sweep.proven = true;
  return sweep;
}

JointSweep keeps_together(MovedPair& pair, JointVector q) {
  const int j = pair.joints.front();
  constexpr int kSweepSteps = kMaxSteps / 5;
  JointSweep sweep;
  for (int k = 0; k <= kSweepSteps; ++k, ++sweep.postures) {
    q[j] = pair.robot.lower[j] + (pair.robot.upper[j] - pair.robot.lower[j]) * k / kSweepSteps;
    if (pair.gap_m(q) > kLinkagePlay_m) return sweep;
  }
  sweep.holds = true;
  return sweep;
}

}  // namespace morphe::setup
