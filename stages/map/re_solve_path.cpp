#include "stages/map/re_solve_path.hpp"

#include <algorithm>
#include <numeric>

#include "stages/map/coarse_grid.hpp"
#include "stages/map/make_movement_problem.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;

/// The frames [first, end) that may move.
struct Window {
  std::size_t first, end;
};

/// Held frames beside a window, the range of the differences.
constexpr std::size_t kHeldFrames = 3;

/// Returns the windows of frames within `reach_s` of a finding; windows whose held frames would
/// overlap are merged.
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

/// Solves the path near a window at some of its frames, with those outside the window held at their
/// positions. The start is the path plus `change`, if it has rows.
JointRows solve_window(const MappingProblem& problem, const std::vector<std::size_t>& frames,
                       const Window& window, const JointRows& path, const JointRows& change,
                       const MovementCost& cost, const solve::MovementOptions& options) {
  constexpr double kHoldWeight_per_rad2 = 1e6;  // per rad²: far stiffer than any term of a frame
  const JointRows before = rows_at(path, frames);
  const MappingProblem part = problem_at_frames(problem, frames);
  const auto moves = [&](std::size_t frame) { return frame >= window.first && frame < window.end; };
  std::vector<MappingScratch> scratch;
  solve::MovementProblem movement = make_movement_problem(part, cost, scratch);
  const auto own_model = movement.frame_model;
  movement.frame_model = [&](std::size_t k, const JointVector& q, solve::Quadratic& model) {
    own_model(k, q, model);
    if (moves(frames[k])) return;
    const JointVector away = q - before.row(k).transpose();
    model.value += kHoldWeight_per_rad2 * away.squaredNorm();
    model.gradient += 2 * kHoldWeight_per_rad2 * away;
    model.hessian.diagonal().array() += 2 * kHoldWeight_per_rad2;
  };
  JointRows start = before;
  for (std::size_t k = 0; k < frames.size() && change.rows() > 0; ++k) {
    if (moves(frames[k])) start.row(k) += change.row(k);
  }
  return solve::minimise_movement(movement, start, options).q;
}

/// Re-solves each window, first at some of its frames, then at all.
JointPath re_solve_windows(const MappingProblem& problem, const JointPath& path,
                           const std::vector<Window>& windows, const MapOptions& options) {
  JointPath resolved = path;
  for (const Window& window : windows) {
    const std::size_t begin = window.first - std::min(window.first, kHeldFrames);
    const std::size_t end = std::min(problem.frames(), window.end + kHeldFrames);
    std::vector<std::size_t> all(end - begin);
    std::iota(all.begin(), all.end(), begin);
    std::vector<std::size_t> some =
        coarse_frames(problem_at_frames(problem, all).time, options.coarse_step_s);
    for (std::size_t& frame : some) frame += begin;
    const auto solve = [&](const std::vector<std::size_t>& frames, const JointRows& change,
                           const solve::MovementOptions& exactness) {
      return solve_window(problem, frames, window, path.position, change, options.movement_cost,
                          exactness);
    };
    const JointRows change =
        solve(some, {}, options.movement_solver) - rows_at(path.position, some);
    const JointRows found =
        solve(all, interpolate(change, some), fine_grid_options(options.movement_solver));
    for (std::size_t frame = begin; frame < end; ++frame) {
      const auto row = static_cast<Index>(frame), k = static_cast<Index>(frame - begin);
      if ((found.row(k) - path.position.row(row)).cwiseAbs().maxCoeff() <= 1e-4) continue;
      resolved.position.row(row) = found.row(k);
      resolved.origin[frame] = SampleOrigin::re_solved;
    }
  }
  return resolved;
}

}  // namespace

JointPath re_solve_path(const MappingProblem& problem, const JointPath& path,
                        const std::vector<Finding>& findings, const MapOptions& options,
                        double reach_s) {
  return re_solve_windows(problem, path, windows_around(findings, problem.time, reach_s), options);
}

JointPath re_solve_between(const MappingProblem& problem, const JointPath& path, double begin_s,
                           double end_s, const MapOptions& options) {
  const auto first = std::ranges::lower_bound(problem.time, begin_s);
  const auto end = std::ranges::upper_bound(problem.time, end_s);
  if (first >= end) return path;
  const auto frame = [&](auto at) { return static_cast<std::size_t>(at - problem.time.begin()); };
  return re_solve_windows(problem, path, {{frame(first), frame(end)}}, options);
}

}  // namespace morphe::map
