#include "stages/map/movement_search.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/math/seed.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/constants.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/join_ik_branches.hpp"
#include "stages/map/path_problem.hpp"
#include "stages/map/placement.hpp"
#include "stages/map/posture_symmetries.hpp"
#include "stages/map/rest_branch.hpp"
#include "stages/map/rounded_problem.hpp"

namespace morphe::map {
namespace {

/// Returns the first `count` values, or all if there are fewer.
template <class Values>
auto first_values(Values& values, std::size_t count) {
  return std::span(values).first(std::min(count, values.size()));
}

/// Tracks a branch by warm-started solves from a key frame to both ends.
IkBranch track_branch(const MappingProblem& problem, int key, const JointVector& q,
                      solve::MinimiseOptions options, MappingScratch& scratch) {
  options = limit_evaluations(options, kMaxTrackingEvaluations);
  options.relative_tolerance = std::max(options.relative_tolerance, kTrackingTolerance);
  const double share = mean_step(problem.time) / kReferenceStep_s;
  const std::size_t frames = problem.frames();
  IkBranch branch{key, JointRows(frames, q.size()), std::vector<double>(frames)};
  const auto solve = [&](int frame, const JointVector& start) {
    const solve::Minimum found = solve_frame(problem, frame, start, options, scratch);
    branch.q.row(frame) = found.x.transpose();
    branch.frame_cost[frame] = share * found.value;
  };
  solve(key, q);
  for (int f = key + 1; f < branch.q.rows(); ++f) solve(f, branch.q.row(f - 1).transpose());
  for (int f = key - 1; f >= 0; --f) solve(f, branch.q.row(f + 1).transpose());
  return branch;
}

bool same_path(const PostureSymmetries& symmetries, const JointRows& a, const JointRows& b) {
  for (Eigen::Index f = 0; f < a.rows(); ++f) {
    if (!same_up_to_symmetry(symmetries, a.row(f).transpose(), b.row(f).transpose(),
                             kSameMinimum_rad))
      return false;
  }
  return true;
}

CandidatePath smoothed(const MappingProblem& problem, const JointRows& start,
                       const MovementCost& cost, const solve::MovementOptions& options) {
  solve::MovementMinimum found = minimise_path(problem, start, cost, options);
  return {std::move(found.q), found.value};
}

CandidatePath solve_coarse_to_fine(const MappingProblem& problem, const MappingProblem& coarse,
                                   const std::vector<std::size_t>& frames, const JointRows& start,
                                   const MapOptions& options) {
  const CandidatePath settled =
      smoothed(coarse, start, options.movement_cost, options.movement_solver);
  return smoothed(problem, interpolate(settled.q, frames), options.movement_cost,
                  fine_grid_options(options.movement_solver));
}

/// Returns true if a joint that differs among equivalent postures reaches its limit.
bool reaches_limit(const PostureSymmetries& symmetries, const JointRows& path) {
  return std::ranges::any_of(symmetry_joints(symmetries), [&](Eigen::Index j) {
    return path.col(j).minCoeff() <= symmetries.lower[j] ||
           path.col(j).maxCoeff() >= symmetries.upper[j];
  });
}

/// Returns the options with which the path that is taken is solved. Without a preferred branch the
/// least value decides, which more steps would hardly change; a hand alone has no redundant arm.
MapOptions polishing_options(const MappingProblem& problem, MapOptions options) {
  if (problem.reference.posture.size() == 0 || is_hand_only(*problem.robot)) return options;
  options.movement_solver.relative_tolerance *= kPolishingToleranceFactor;
  return options;
}

void sort_by_value(std::vector<CandidatePath>& paths) {
  std::ranges::stable_sort(paths, {}, &CandidatePath::value);
}

void add_if_new(const PostureSymmetries& symmetries, std::vector<CandidatePath>& paths,
                CandidatePath path) {
  for (CandidatePath& known : paths) {
    if (!same_path(symmetries, known.q, path.q)) continue;
    if (path.value < known.value) known = std::move(path);
    return;
  }
  paths.push_back(std::move(path));
}

/// Tracks minima of the key frames, each unless an equivalent of it is on a branch already.
std::vector<IkBranch> track_key_frames(const MappingProblem& coarse,
                                       const PostureSymmetries& symmetries,
                                       const MapOptions& options, std::uint64_t seed) {
  MappingScratch scratch;
  std::vector<IkBranch> branches;
  std::vector<bool> stopped;  // true if the branch meets a limit that an equivalent one may not
  const auto on_known_branch = [&](int key, const JointVector& q) {
    for (int b = 0; b < std::ssize(branches); ++b) {
      const JointVector posture = branches[b].q.row(key).transpose();
      const bool same = stopped[b] ? (posture - q).cwiseAbs().maxCoeff() < kSameMinimum_rad
                                   : same_up_to_symmetry(symmetries, posture, q, kSameMinimum_rad);
      if (same) return true;
    }
    return false;
  };
  for (int k = 0; k < options.key_frames; ++k) {
    const auto last = static_cast<double>(coarse.frames() - 1);
    const double position = options.key_frames == 1 ? last : last * k / (options.key_frames - 1);
    const auto key = static_cast<int>(std::lround(position));
    for (const solve::Minimum& start : search_frame(
             coarse, key, options.starts, options.candidates, quick_stages(options.frame_solver),
             math::seed_from(seed, "key frame", k), scratch)) {
      std::vector<JointVector> postures = equivalent_postures(symmetries, start.x);
      for (std::size_t p = 0; p < std::min(postures.size(), kMaxEquivalentPostures); ++p) {
        const JointVector posture = postures[p];
        if (on_known_branch(key, posture)) continue;
        branches.push_back(track_branch(coarse, key, posture, options.frame_solver, scratch));
        stopped.push_back(reaches_limit(symmetries, branches.back().q));
        if (!stopped.back()) break;
        JointVector turned = turned_off_limits(symmetries, branches.back().q, posture);
        if (turned != posture)
          postures.insert(postures.begin() + static_cast<std::ptrdiff_t>(p) + 1, std::move(turned));
      }
    }
  }
  return branches;
}

/// Returns the paths that the branches of the key frames lead to, the least value first.
std::vector<CandidatePath> search_coarse_paths(const MappingProblem& coarse,
                                               const MapOptions& options, std::uint64_t seed) {
  const PostureSymmetries symmetries = find_posture_symmetries(coarse);
  const std::vector<JointRows> sequences =
      join_ik_branches(track_key_frames(coarse, symmetries, options, seed),
                       difference_weights(*coarse.robot, coarse.time, options.movement_cost));
  solve::MovementOptions screening = options.movement_solver, comparing = options.movement_solver;
  screening.max_iterations = std::min(screening.max_iterations, kScreeningIterations);
  comparing.relative_tolerance *= kComparisonToleranceFactor;
  std::vector<CandidatePath> paths;
  for (const JointRows& sequence : first_values(sequences, options.candidates)) {
    add_if_new(symmetries, paths, smoothed(coarse, sequence, options.movement_cost, screening));
  }
  sort_by_value(paths);
  for (CandidatePath& path : first_values(paths, kFullySmoothedCount)) {
    path = smoothed(coarse, path.q, options.movement_cost, comparing);
  }
  for (CandidatePath& path : paths) path.q = preferred_equivalent(symmetries, path.q);
  sort_by_value(paths);
  return paths;
}

/// Continues postures of the person at rest into the movement, the preferred one first. Ends with
/// the preferred one if it is within the share of `best`, the least value that is known.
std::vector<CandidatePath> continued_paths(const MappingProblem& coarse,
                                           const PostureSymmetries& symmetries,
                                           const MapOptions& options, double best) {
  MappingScratch scratch;
  std::vector<CandidatePath> paths;
  for (const JointVector& posture : first_values(coarse.reference.starts, kRestBranches)) {
    const IkBranch branch = continue_from_rest(coarse, posture, options, scratch);
    paths.push_back(smoothed(coarse, turned_towards_reference(symmetries, branch.q),
                             options.movement_cost, options.movement_solver));
    if (paths.front().value <= (1 + options.branch_share) * best) break;
  }
  return paths;
}

/// Puts the path that is taken first: the first continued one whose value is within the share of
/// the least that is known. Without one, the branch is chosen among all. A path that does not
/// continue the preferred posture is flipped to the sides of the reference if that costs no more
/// than the share.
void put_preferred_first(const MappingProblem& coarse, const MapOptions& options,
                         std::vector<CandidatePath>& paths) {
  const PostureSymmetries symmetries = find_palm_symmetries(coarse);
  double best = paths.front().value;
  std::vector<CandidatePath> continued = continued_paths(coarse, symmetries, options, best);
  for (const CandidatePath& path : continued) best = std::min(best, path.value);
  const double most = (1 + options.branch_share) * best;
  const auto good = std::ranges::find_if(
      continued, [&](const CandidatePath& path) { return path.value <= most; });
  const bool is_preferred = good == continued.begin() && good != continued.end();
  if (good != continued.end()) paths.insert(paths.begin(), std::move(*good));
  if (is_preferred) return;
  std::ranges::move(continued.begin(), good, std::back_inserter(paths));
  if (good == continued.end())
    std::ranges::swap(
        paths.front(),
        paths[choose_branch(*coarse.robot, paths, coarse.reference.posture, options.branch_share)]);
  const JointRows flipped = preferred_equivalent(symmetries, paths.front().q);
  if (flipped == paths.front().q) return;
  CandidatePath other = smoothed(coarse, flipped, options.movement_cost, options.movement_solver);
  if (other.value <= most) paths.insert(paths.begin(), std::move(other));
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
  std::vector<CandidatePath> paths = search_coarse_paths(coarse, options, seed);
  put_preferred_first(coarse, options, paths);
  paths.front() = solve_coarse_to_fine(problem, coarse, frames, paths.front().q,
                                       polishing_options(problem, options));
  for (int k = 1; k < std::ssize(paths); ++k) paths[k].q = interpolate(paths[k].q, frames);
  return paths;
}

CandidatePath path_through(const MappingProblem& problem, std::size_t frame,
                           const JointVector& posture, const MapOptions& options) {
  std::vector<std::size_t> frames = coarse_frames(problem.time, options.coarse_step_s);
  frame = std::min(frame, frames.back());
  const auto next = std::ranges::lower_bound(frames, frame);
  const auto key = static_cast<int>(next - frames.begin());
  if (*next != frame) frames.insert(next, frame);
  const RoundedProblem coarse(problem_at_frames(problem, frames));
  MappingScratch scratch;
  const IkBranch branch = track_branch(coarse.problem, key, posture, options.frame_solver, scratch);
  return solve_coarse_to_fine(problem, coarse.problem, frames, branch.q, options);
}

}  // namespace morphe::map
