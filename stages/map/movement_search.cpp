#include "stages/map/movement_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/seed.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/join_ik_branches.hpp"
#include "stages/map/make_movement_problem.hpp"
#include "stages/map/posture_symmetries.hpp"
#include "stages/map/rounded_problem.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;

constexpr int kMaxTrackingEvaluations = 5;  ///< evaluations per tracked frame

/// Tracks a branch by warm-started solves from a key frame to both ends, as accurately as joining
/// and smoothing require.
IkBranch track_branch(const MappingProblem& problem, std::size_t key, const JointVector& q,
                      solve::MinimiseOptions options, MappingScratch& scratch) {
  options = limit_evaluations(options, kMaxTrackingEvaluations);
  options.relative_tolerance = std::max(options.relative_tolerance, 1e-5);
  const double share = mean_step(problem.time) / kReferenceStep_s;
  IkBranch way{key, JointRows(problem.frames(), q.size()), std::vector<double>(problem.frames())};
  const auto solve = [&](std::size_t frame, const JointVector& start) {
    const solve::Minimum found = solve_frame(problem, frame, start, options, scratch);
    way.q.row(frame) = found.x.transpose();
    way.frame_cost[frame] = share * found.value;
  };
  solve(key, q);
  const auto near = [&](std::size_t frame) -> JointVector { return way.q.row(frame).transpose(); };
  for (std::size_t f = key; f + 1 < problem.frames(); ++f) solve(f + 1, near(f));
  for (std::size_t f = key; f > 0; --f) solve(f - 1, near(f));
  return way;
}

/// Returns true if two paths have the same or equivalent postures in all frames.
bool same_path(const PostureSymmetries& twins, const JointRows& a, const JointRows& b) {
  for (Index f = 0; f < a.rows(); ++f) {
    if (!same_up_to_symmetry(twins, a.row(f).transpose(), b.row(f).transpose(),
                             kBasinTolerance_rad))
      return false;
  }
  return true;
}

/// Iterations after which the jumps are gone and the value of a sequence becomes apparent, and the
/// number of best sequences that are smoothed until convergence. The others are kept for repair,
/// which changes them anyway.
constexpr int kScreeningIterations = 7;
constexpr std::size_t kFullySmoothedCount = 2;
/// Factor on the relative value at which the comparison converges.
constexpr double kComparisonToleranceFactor = 10;

solve::MovementOptions limit_iterations(solve::MovementOptions options, int iterations) {
  options.max_iterations = std::min(options.max_iterations, iterations);
  return options;
}

/// Smooths all frames of the problem at once.
CandidatePath minimise_path(const MappingProblem& problem, const JointRows& start,
                            const MovementCost& cost, const solve::MovementOptions& options) {
  std::vector<MappingScratch> scratch;
  const solve::MovementMinimum found =
      solve::minimise_movement(make_movement_problem(problem, cost, scratch), start, options);
  return {found.q, found.value};
}

/// Smooths a path on the coarse grid until it converges, then refines it over all frames.
CandidatePath solve_coarse_to_fine(const MappingProblem& problem, const MappingProblem& coarse,
                                   const std::vector<std::size_t>& frames, const JointRows& start,
                                   const MapOptions& options) {
  const CandidatePath settled =
      minimise_path(coarse, start, options.movement_cost, options.movement_solver);
  return minimise_path(problem, interpolate(settled.q, frames), options.movement_cost,
                       fine_grid_options(options.movement_solver));
}

/// Returns the equivalent postures that are worth tracking.
std::vector<JointVector> first_equivalent_postures(const PostureSymmetries& twins,
                                                   const JointVector& q) {
  constexpr std::size_t kMaxEquivalentPostures = 3;
  std::vector<JointVector> found = equivalent_postures(twins, q);
  if (found.size() > kMaxEquivalentPostures) found.resize(kMaxEquivalentPostures);
  return found;
}

/// Returns true if a joint that differs among equivalent postures reaches its limit.
bool reaches_limit(const PostureSymmetries& twins, const JointRows& way) {
  return std::ranges::any_of(symmetry_joints(twins), [&](Index j) {
    return way.col(j).minCoeff() <= twins.lower[j] || way.col(j).maxCoeff() >= twins.upper[j];
  });
}

void sort_by_value(std::vector<CandidatePath>& courses) {
  std::stable_sort(
      courses.begin(), courses.end(),
      [](const CandidatePath& a, const CandidatePath& b) { return a.value < b.value; });
}

void add_if_new(const PostureSymmetries& twins, std::vector<CandidatePath>& courses,
                CandidatePath course) {
  for (CandidatePath& known : courses) {
    if (!same_path(twins, known.q, course.q)) continue;
    if (course.value < known.value) known = std::move(course);
    return;
  }
  courses.push_back(std::move(course));
}

}  // namespace

CandidatePath smooth_movement(const MappingProblem& problem, const JointRows& start,
                              const MapOptions& options) {
  const std::vector<std::size_t> frames = coarse_frames(problem.time, options.coarse_step_s);
  const RoundedProblem coarse(problem_at_frames(problem, frames));
  return solve_coarse_to_fine(problem, coarse.problem, frames, rows_at(start, frames), options);
}

std::vector<CandidatePath> search_movement(const MappingProblem& problem, const MapOptions& options,
                                           std::uint64_t seed) {
  const std::vector<std::size_t> frames = coarse_frames(problem.time, options.coarse_step_s);
  const RoundedProblem rounded(problem_at_frames(problem, frames));
  const MappingProblem& coarse = rounded.problem;
  MappingScratch scratch;

  const PostureSymmetries twins = find_posture_symmetries(coarse);
  std::vector<IkBranch> ways;
  std::vector<bool> stopped;  // by a limit that an equivalent posture may not reach
  const auto on_known_way = [&](std::size_t key, const JointVector& q) {
    for (std::size_t w = 0; w < ways.size(); ++w) {
      const JointVector passed = ways[w].q.row(key).transpose();
      const bool same = stopped[w] ? (passed - q).cwiseAbs().maxCoeff() < kBasinTolerance_rad
                                   : same_up_to_symmetry(twins, passed, q, kBasinTolerance_rad);
      if (same) return true;
    }
    return false;
  };
  for (int k = 0; k < options.key_frames; ++k) {
    const auto last = static_cast<double>(coarse.frames() - 1);
    const double position = options.key_frames == 1 ? last : last * k / (options.key_frames - 1);
    const auto key = static_cast<std::size_t>(std::lround(position));
    for (const solve::Minimum& start : search_frame(
             coarse, key, options.starts, options.candidates, quick_stages(options.frame_solver),
             math::seed_from(seed, "key frame", k), scratch)) {
      for (const JointVector& twin : first_equivalent_postures(twins, start.x)) {
        if (on_known_way(key, twin)) continue;
        ways.push_back(track_branch(coarse, key, twin, options.frame_solver, scratch));
        stopped.push_back(reaches_limit(twins, ways.back().q));
        if (!stopped.back()) break;
      }
    }
  }
  std::vector<JointRows> sequences = join_ik_branches(
      ways, difference_weights(*problem.robot, coarse.time, options.movement_cost));
  if (sequences.size() > static_cast<std::size_t>(options.candidates)) {
    sequences.resize(options.candidates);
  }
  std::vector<CandidatePath> paths;
  for (const JointRows& sequence : sequences) {
    add_if_new(twins, paths,
               minimise_path(coarse, sequence, options.movement_cost,
                             limit_iterations(options.movement_solver, kScreeningIterations)));
  }
  sort_by_value(paths);
  solve::MovementOptions comparing = options.movement_solver;
  comparing.relative_tolerance *= kComparisonToleranceFactor;
  for (std::size_t k = 0; k < std::min(kFullySmoothedCount, paths.size()); ++k) {
    paths[k] = minimise_path(coarse, paths[k].q, options.movement_cost, comparing);
  }
  sort_by_value(paths);
  paths.front() = solve_coarse_to_fine(problem, coarse, frames, paths.front().q, options);
  for (std::size_t k = 1; k < paths.size(); ++k) {
    paths[k].q = interpolate(paths[k].q, frames);
  }
  return paths;
}

CandidatePath path_through(const MappingProblem& problem, std::size_t frame,
                           const JointVector& posture, const MapOptions& options) {
  std::vector<std::size_t> frames = coarse_frames(problem.time, options.coarse_step_s);
  const auto place = std::ranges::lower_bound(frames, frame);
  const auto key = static_cast<std::size_t>(place - frames.begin());
  if (*place != frame) frames.insert(place, frame);
  const RoundedProblem coarse(problem_at_frames(problem, frames));
  MappingScratch scratch;
  const IkBranch followed =
      track_branch(coarse.problem, key, posture, options.frame_solver, scratch);
  return solve_coarse_to_fine(problem, coarse.problem, frames, followed.q, options);
}

}  // namespace morphe::map
