#include "stages/map/re_solve_path.hpp"

#include <algorithm>
#include <numeric>

#include "stages/map/coarse_grid.hpp"
#include "stages/map/constants.hpp"
#include "stages/map/path_problem.hpp"

namespace morphe::map {
namespace {

/// The frames [first, end) that may move.
struct Window {
  std::ptrdiff_t first, end;
};

/// Held frames beside a window: as many as a frame's differences reach (MovementProblem).
constexpr std::ptrdiff_t kHeldFrames = 3;

/// Returns the windows of frames within `window_s` of a finding, merged if held frames overlap.
std::vector<Window> windows_around(const std::vector<Finding>& findings,
                                   const std::vector<double>& time, double window_s) {
  std::vector<Window> windows;
  for (int f = 0; f < std::ssize(time); ++f) {
    const bool may_move = std::ranges::any_of(findings, [&](const Finding& finding) {
      return time[f] >= finding.begin_s - window_s && time[f] <= finding.end_s + window_s;
    });
    if (!may_move) continue;
    if (windows.empty() || f > windows.back().end + 2 * kHeldFrames) windows.push_back({f, f});
    windows.back().end = f + 1;
  }
  return windows;
}

/// Returns the solution at `frames`, of which those outside the window are held. The solve starts
/// from the path plus `change` [frames, n] inside the window; without rows it is zero.
JointRows solve_window(const MappingProblem& problem, const std::vector<std::size_t>& frames,
                       const Window& window, const JointRows& path, const JointRows& change,
                       const MovementCost& cost, const solve::MovementOptions& options) {
  const MappingProblem part = problem_at_frames(problem, frames);
  const PathProblem of_part(part, cost);
  const JointRows rows = rows_at(path, frames);
  const JointRows offsets = of_part.has_offsets ? wrist_offsets(part, rows) : JointRows();
  const JointRows before = of_part.with_offsets(rows, offsets);
  const auto moves = [&](std::ptrdiff_t frame) {
    return frame >= window.first && frame < window.end;
  };
  solve::MovementProblem movement = of_part.movement;
  const auto objective_model = movement.frame_model;
  movement.frame_model = [&](std::size_t k, const JointVector& q, solve::Quadratic& model) {
    objective_model(k, q, model);
    if (moves(frames[k])) return;
    const JointVector deviation = q - before.row(k).transpose();
    model.value += kHoldWeight_per_rad2 * deviation.squaredNorm();
    model.gradient += 2 * kHoldWeight_per_rad2 * deviation;
    model.hessian.diagonal().array() += 2 * kHoldWeight_per_rad2;
  };
  JointRows start = before;
  for (int k = 0; k < std::ssize(frames) && change.rows() > 0; ++k) {
    if (moves(frames[k])) start.row(k).head(change.cols()) += change.row(k);
  }
  return of_part.joints(solve::minimise_movement(movement, start, options).q);
}

JointPath re_solve_windows(const MappingProblem& problem, const JointPath& path,
                           const std::vector<Window>& windows, const MapOptions& options) {
  JointPath resolved = path;
  for (const Window& window : windows) {
    const auto begin = std::max<std::ptrdiff_t>(0, window.first - kHeldFrames);
    const auto end = std::min(std::ssize(problem.time), window.end + kHeldFrames);
    std::vector<std::size_t> fine(end - begin);
    std::iota(fine.begin(), fine.end(), begin);
    std::vector<std::size_t> coarse =
        coarse_frames(problem_at_frames(problem, fine).time, options.coarse_step_s);
    for (std::size_t& frame : coarse) frame += begin;
    const auto solve = [&](const std::vector<std::size_t>& frames, const JointRows& change,
                           const solve::MovementOptions& solver) {
      return solve_window(problem, frames, window, path.position, change, options.movement_cost,
                          solver);
    };
    const JointRows change =
        solve(coarse, {}, options.movement_solver) - rows_at(path.position, coarse);
    const JointRows found =
        solve(fine, interpolate(change, coarse), fine_grid_options(options.movement_solver));
    for (std::ptrdiff_t f = begin; f < end; ++f) {
      const auto row = found.row(f - begin);
      if ((row - path.position.row(f)).cwiseAbs().maxCoeff() <= kReSolvedChange_rad) continue;
      resolved.position.row(f) = row;
      resolved.origin[f] = SampleOrigin::re_solved;
    }
  }
  return resolved;
}

}  // namespace

JointPath re_solve_path(const MappingProblem& problem, const JointPath& path,
                        const std::vector<Finding>& findings, const MapOptions& options,
                        double window_s) {
  return re_solve_windows(problem, path, windows_around(findings, problem.time, window_s), options);
}

JointPath re_solve_between(const MappingProblem& problem, const JointPath& path, double begin_s,
                           double end_s, const MapOptions& options) {
  const auto first = std::ranges::lower_bound(problem.time, begin_s);
  const auto end = std::ranges::upper_bound(problem.time, end_s);
  if (first >= end) return path;
  const auto begin = problem.time.begin();
  return re_solve_windows(problem, path, {{first - begin, end - begin}}, options);
}

}  // namespace morphe::map
