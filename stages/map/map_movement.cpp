#include "stages/map/map_movement.hpp"

#include <algorithm>
#include <numeric>

#include "pipeline/humanlike/metrics.hpp"
#include "pipeline/kinematics/forward.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/finger_curve.hpp"
#include "stages/map/movement_search.hpp"
#include "stages/map/reachable.hpp"

namespace morphe {
namespace {

using Eigen::Index;
constexpr double kMetBelow = 1e-3;  ///< tip error of a frame that counts as met [m]

void measure_humanlikeness(const MappingProblem& problem, const Goals& goals, std::size_t frame,
                           const std::vector<Pose>& base_from_frame, Mapped& mapped) {
  const auto row = static_cast<Index>(frame);
  mapped.humanlikeness.row(row).setConstant(kNotSeen);
  const Chain human{goals.shoulder_position[frame], goals.elbow_position[frame],
                    goals.wrist_position[frame]};
  if (!seen(human[0]) || !seen(human[1]) || !seen(human[2])) return;
  const Chain robot = arm_chain(*problem.robot, base_from_frame).joints;
  std::vector<Vec3> inner;
  for (const auto& centre : problem.robot->centres) {
    if (centre.chain == "arm") {
      inner.push_back(base_from_frame[static_cast<std::size_t>(centre.frame)].translation());
    }
  }
  mapped.humanlikeness(row, 0) = joint_distance_sum(human[1], inner);
  mapped.humanlikeness(row, 1) = triangle_area_sum(human, robot);
  mapped.humanlikeness(row, 2) = hull_volume_sum(human, robot);
}

void measure_frame(const MappingProblem& problem, const Goals& goals, std::size_t frame,
                   MappingScratch& scratch, Mapped& mapped) {
  const auto row = static_cast<Index>(frame);
  const JointVector q = mapped.position.row(row).transpose();
  const FrameGoal goal = frame_goal(goals, frame);
  scratch.model.reset(q.size());
  add_frame(problem, frame, q, scratch, scratch.model);
  mapped.objective.push_back(scratch.model.value);
  bool any = false, met = true, reachable = true;
  for (std::size_t i = 0; i < goal.tip_position.size(); ++i) {
    const Pose tip = tip_pose(*problem.robot, scratch.base_from_frame, i);
    const auto col = static_cast<Index>(i);
    if (seen(goal.tip_orientation[i])) {
      mapped.orientation_error(row, col) =
          angle_between(Quat(tip.linear()), goal.tip_orientation[i]);
    }
    if (!seen(goal.tip_position[i])) continue;
    any = true;
    const double error = (tip.translation() - goal.tip_position[i]).norm();
    mapped.position_error(row, col) = error;
    met = met && error < kMetBelow;
    reachable = reachable && goals.reachable(frame, i);
  }
  mapped.status.push_back(!any        ? FrameStatus::no_goal
                          : met       ? FrameStatus::met
                          : reachable ? FrameStatus::compromise
                                      : FrameStatus::out_of_reach);
  measure_humanlikeness(problem, goals, frame, scratch.base_from_frame, mapped);
}

Mapped measure(const MappingProblem& problem, const Goals& goals, const JointRows& q) {
  const auto frames = q.rows();
  const auto tips = static_cast<Index>(goals.tip_position.cols);
  Mapped mapped;
  mapped.position = q;
  mapped.position_error = JointRows::Constant(frames, tips, kNotSeen);
  mapped.orientation_error = JointRows::Constant(frames, tips, kNotSeen);
  mapped.humanlikeness = JointRows::Constant(frames, 3, kNotSeen);
  MappingScratch scratch;
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    measure_frame(problem, goals, f, scratch, mapped);
  }
  return mapped;
}

double posture_error(const MappingProblem& problem, const Goals& goals, const JointRows& q) {
  double sum = 0;
  int count = 0;
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    const double error = problem.objective.posture.distance(
        q.row(static_cast<Index>(f)).transpose(), frame_goal(goals, f));
    if (std::isnan(error)) continue;
    sum += error * error;
    ++count;
  }
  return count == 0 ? kNotSeen : std::sqrt(sum / count);
}

/// Where the middle joints of fingers between the human's would be: the rule of their tips.
std::vector<Vec3> curve_joints(const RobotTable& robot, const Goals& goals, std::size_t frame) {
  const auto joint = [&](std::size_t finger) { return goals.finger_joint_position(frame, finger); };
  std::vector<Vec3> points(robot.tips.size(), unseen_point());
  for (std::size_t tip = 0; tip < points.size(); ++tip) {
    const double along = robot.tips[tip].along;
    if (!std::isfinite(along)) continue;
    points[tip] = point_along({joint(1), joint(2), joint(3), joint(4)}, along);
  }
  return points;
}

/// Frames [first, end) that may move.
struct Window {
  std::size_t first, end;
};

constexpr std::size_t kHeldFrames = 3;  ///< beside a window: as far as its differences reach

/// Frames within `reach_s` of a finding; windows whose held frames would meet are one.
std::vector<Window> windows_around(const std::vector<Finding>& findings,
                                   const std::vector<double>& time, double reach_s) {
  std::vector<Window> windows;
  for (std::size_t f = 0; f < time.size(); ++f) {
    const bool may_move = std::ranges::any_of(findings, [&](const Finding& finding) {
      return time[f] >= finding.begin_s - reach_s && time[f] <= finding.end_s + reach_s;
    });
    if (!may_move) continue;
    if (windows.empty() || f > windows.back().end + 2 * kHeldFrames) windows.push_back({f, f});
    windows.back().end = f + 1;
  }
  return windows;
}

std::vector<double> times_at(const MappingProblem& problem,
                             const std::vector<std::size_t>& frames) {
  std::vector<double> times;
  for (const std::size_t frame : frames) times.push_back(problem.time[frame]);
  return times;
}

/// The path near a window at some of its frames, those outside the window held where they are;
/// from `change` beside the path, if there is any.
JointRows solve_window(const MappingProblem& problem, const std::vector<std::size_t>& frames,
                       const Window& window, const JointRows& path, const JointRows& change,
                       const MovementCost& cost, const MovementOptions& options) {
  constexpr double kHold = 1e6;  // per rad²: far stiffer than any term of a frame
  const JointRows before = rows_at(path, frames);
  const std::vector<double> times = times_at(problem, frames);
  const double share = mean_step(times) / kReferenceStep;
  const auto moves = [&](std::size_t frame) { return frame >= window.first && frame < window.end; };
  MovementProblem movement;
  movement.frames = frames.size();
  movement.lower = problem.robot->lower;
  movement.upper = problem.robot->upper;
  movement.difference_weight = difference_weights(*problem.robot, times, cost);
  std::vector<MappingScratch> scratch(frames.size());
  movement.frame_model = [&](std::size_t k, const JointVector& q, Quadratic& model) {
    add_frame(problem, frames[k], q, scratch[k], model, Curvature::exact);
    model.scale(share);
    if (moves(frames[k])) return;
    const JointVector away = q - before.row(static_cast<Index>(k)).transpose();
    model.value += kHold * away.squaredNorm();
    model.gradient += 2 * kHold * away;
    model.hessian.diagonal().array() += 2 * kHold;
  };
  JointRows start = before;
  for (std::size_t k = 0; k < frames.size() && change.rows() > 0; ++k) {
    if (moves(frames[k])) start.row(static_cast<Index>(k)) += change.row(static_cast<Index>(k));
  }
  return minimise_movement(movement, start, options).q;
}

}  // namespace

MappingProblem make_mapping_problem(const RobotTable& robot, const Goals& goals,
                                    const CollisionWorld& world, const MapOptions& options,
                                    const std::vector<Phase>& phases) {
  MappingProblem problem;
  problem.robot = &robot;
  problem.objective = make_objective(options, robot);
  problem.clearance = options.clearance;
  problem.world = &world;
  problem.time = goals.time;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    problem.goals.push_back(frame_goal(goals, f));
    problem.goals.back().curve_joint = curve_joints(robot, goals, f);
    problem.goals.back().weights =
        weights_at(options.phases, phases, goals.time[f], options.phase_blend_s);
  }
  return problem;
}

MapResult map_movement(const MappingProblem& problem, Goals& goals, const MapOptions& options,
                       std::uint64_t seed) {
  MapResult result;
  MappingProblem tracked = problem;  // what is reached is judged by the tips in every mode
  for (std::size_t f = 0; f < goals.frames(); ++f) tracked.goals[f] = frame_goal(goals, f);
  const bool any_goal = std::any_of(tracked.goals.begin(), tracked.goals.end(),
                                    [](const FrameGoal& goal) { return goal.tips_seen() > 0; });
  if (problem.frames() < 5 || !any_goal) {
    result.reason = "no_goal";
    result.detail = any_goal ? "the movement has fewer than 5 frames"
                             : "no fingertip was seen in the whole movement";
    return result;
  }
  const std::vector<Course> courses = search_movement(problem, options, seed);
  const JointRows& q = courses.front().q;
  const std::vector<bool> reachable = reachable_frames(
      tracked, q, {options.reachable_starts, options.reachable_m, options.solver}, seed + 1000);
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    for (std::size_t i = 0; i < goals.reachable.cols; ++i) goals.reachable(f, i) = reachable[f];
  }
  result.mapped = measure(problem, goals, q);
  result.posture_error_rad = posture_error(problem, goals, q);
  result.path = {q, std::vector<Origin>(problem.frames(), Origin::mapped), problem.time};
  for (std::size_t i = 1; i < courses.size(); ++i) result.candidates.push_back(courses[i].q);
  return result;
}

JointPath resolve_path(const MappingProblem& problem, const JointPath& path,
                       const std::vector<Finding>& findings, const MapOptions& options,
                       double firmness, double reach_s) {
  MappingProblem clear = problem;
  clear.clearance.weight *= firmness;
  JointPath resolved = path;
  for (const Window& window : windows_around(findings, problem.time, reach_s)) {
    const std::size_t begin = window.first - std::min(window.first, kHeldFrames);
    const std::size_t end = std::min(problem.frames(), window.end + kHeldFrames);
    std::vector<std::size_t> all(end - begin);
    std::iota(all.begin(), all.end(), begin);
    std::vector<std::size_t> some = coarse_frames(times_at(problem, all), options.coarse_step_s);
    for (std::size_t& frame : some) frame += begin;
    const auto solve = [&](const std::vector<std::size_t>& frames, const JointRows& change,
                           const MovementOptions& exactness) {
      return solve_window(clear, frames, window, path.position, change, options.movement_cost,
                          exactness);
    };
    const JointRows change = solve(some, {}, options.movement) - rows_at(path.position, some);
    const JointRows found = solve(all, interpolate(change, some), between(options.movement));
    for (std::size_t frame = begin; frame < end; ++frame) {
      const auto row = static_cast<Index>(frame), k = static_cast<Index>(frame - begin);
      if ((found.row(k) - path.position.row(row)).cwiseAbs().maxCoeff() <= 1e-4) continue;
      resolved.position.row(row) = found.row(k);
      resolved.origin[frame] = Origin::resolved;
    }
  }
  return resolved;
}

}  // namespace morphe
