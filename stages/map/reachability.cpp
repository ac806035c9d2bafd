#include "stages/map/reachability.hpp"

#include <algorithm>
#include <random>

#include "core/math/seed.hpp"
#include "core/robot/damped_least_squares_ik.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/constants.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe::map {
namespace {

/// Returns the distance of a frame's goals from those of another frame: the root of the sum of
/// squares over the tips with a goal in the other; infinite if one of these has no goal here.
double goal_distance(const robot::Robot& robot, const humanlike::FrameGoal& goal,
                     const humanlike::FrameGoal& other) {
  double squared = 0;
  for (int tip = 0; tip < std::ssize(goal.tip_position); ++tip) {
    if (!is_known(other.tip_position[tip])) continue;
    if (!is_known(goal.tip_position[tip])) return kInfinity;
    double distance = (goal.tip_position[tip] - other.tip_position[tip]).norm();
    const double share = std::abs(goal.tip_to_pad_share_of(tip) - other.tip_to_pad_share_of(tip));
    if (share > 0) {  // the goals refer to different points of the link
      distance += share * (robot.pads[tip].centre - robot.tips[tip].transform.translation()).norm();
    }
    squared += distance * distance;
  }
  return std::sqrt(squared);
}

class ReachabilitySearch {
 public:
  ReachabilitySearch(const MappingProblem& problem, const ReachOptions& options, std::uint64_t seed)
      : problem_(problem), options_(options), seed_(seed), reached_(problem.frames()) {}

  /// Returns true if damped least squares from q brings the tips to their goals; stores the result.
  bool try_reach(int frame, JointVector q) {
    const humanlike::FrameGoal& goal = problem_.goals[frame];
    const double error_m =
        robot::damped_least_squares_ik(*problem_.robot, goal.tip_position, goal.tip_to_pad_share,
                                       kMaxIkSteps, options_.tolerance_m, q, ik_scratch_);
    if (error_m > options_.tolerance_m) return false;
    reached_[frame] = std::move(q);
    return true;
  }

  /// Tries the posture of the nearest frame whose goals are reached, kInitialStride frames off at
  /// most. Returns false without one.
  bool try_reach_from_neighbour(int frame) {
    for (int distance = 1; distance <= kInitialStride; ++distance) {
      for (const int other : {frame - distance, frame + distance}) {
        if (other < 0 || other >= std::ssize(reached_) || reached_[other].size() == 0) continue;
        return try_reach(frame, reached_[other]);
      }
    }
    return false;
  }

  bool is_proven_out_of_reach(int frame) const {
    const humanlike::FrameGoal& goal = problem_.goals[frame];
    return std::ranges::any_of(out_of_reach_, [&](const OutOfReach& other) {
      const double distance = goal_distance(*problem_.robot, goal, problem_.goals[other.frame]);
      return other.error_m - distance > error_tolerance_m(frame);
    });
  }

  /// Returns true if a search reaches the goals; else stores their least error. Uses fewer starts,
  /// and the posture of that search, if the search of a frame nearby has failed.
  bool search_posture(int frame, const JointVector& mapped) {
    const MappingProblem tips_only = tip_position_problem(problem_, frame);
    solve::MinimiseOptions first_steps = options_.solver, precise = options_.solver;
    first_steps.relative_tolerance = std::max(first_steps.relative_tolerance, kFirstStepsTolerance);
    precise.relative_tolerance = std::max(precise.relative_tolerance, 1e-4 * kSameValueTolerance);
    const double tip_weight = tips_only.objective.get<humanlike::TipPosition>().weight;
    const double met_value = tip_weight * error_tolerance_m(frame) * error_tolerance_m(frame);
    std::mt19937_64 random(math::seed_from(seed_, "frame", frame));
    std::vector<JointVector> starts{mapped};
    int random_starts = options_.starts;
    if (const OutOfReach* neighbour = nearest_out_of_reach(frame)) {
      starts.push_back(neighbour->q);
      random_starts /= kStartsDivisor;
    }
    for (int i = 0; i < random_starts; ++i) starts.push_back(random_start(*problem_.robot, random));
    solve::Minimum best;
    best.value = kInfinity;
    int repeats = 0;
    for (int i = 0; i < std::ssize(starts) && repeats < kMinRepeatedMinima; ++i) {
      solve::Minimum minimum = solve_frame(tips_only, 0, starts[i], first_steps, scratch_);
      if (minimum.value > kAbandonValueRatio * best.value) continue;
      minimum = solve_frame(tips_only, 0, minimum.x, precise, scratch_);
      if (minimum.value <= met_value && try_reach(frame, minimum.x)) return true;
      if (minimum.value < (1 - kSameValueTolerance) * best.value) repeats = 0;
      if (minimum.value < (1 + kSameValueTolerance) * best.value) ++repeats;
      if (minimum.value < best.value) best = std::move(minimum);
    }
    out_of_reach_.push_back({frame, std::sqrt(best.value / tip_weight), best.x});
    return false;
  }

 private:
  /// Returns the largest root of the sum of squares of the tip errors at which all goals are met.
  double error_tolerance_m(int frame) const {
    return std::sqrt(static_cast<double>(problem_.goals[frame].goal_tip_count())) *
           options_.tolerance_m;
  }

  struct OutOfReach {
    int frame;
    double error_m;  ///< least error found by a search
    JointVector q;   ///< posture of that error
  };

  const OutOfReach* nearest_out_of_reach(int frame) const {
    const auto distance = [&](const OutOfReach& other) { return std::abs(other.frame - frame); };
    const auto nearest = std::ranges::min_element(out_of_reach_, {}, distance);
    const bool is_close = nearest != out_of_reach_.end() && distance(*nearest) <= kInitialStride;
    return is_close ? &*nearest : nullptr;
  }

  const MappingProblem& problem_;
  const ReachOptions& options_;
  std::uint64_t seed_;
  std::vector<JointVector> reached_;  ///< postures that reach a frame's goals; empty if unknown
  std::vector<OutOfReach> out_of_reach_;
  robot::IkScratch ik_scratch_;
  MappingScratch scratch_;
};

}  // namespace

MappingProblem tip_position_problem(const MappingProblem& problem, std::size_t frame) {
  MappingProblem part = problem_at_frames(problem, {frame});
  part.goals.front().weights = {};
  part.clearance.weight = 0;
  part.objective = {};
  part.objective.get<humanlike::TipPosition>() = problem.objective.get<humanlike::TipPosition>();
  return part;
}

std::vector<bool> reachable_frames(const MappingProblem& problem, const JointRows& path,
                                   const ReachOptions& options, std::uint64_t seed) {
  ReachabilitySearch search(problem, options, seed);
  const std::ptrdiff_t frames = std::ssize(problem.time);
  std::vector<bool> reachable(frames);
  // From a mapped posture damped least squares nearly always reaches the goals, at little cost.
  for (int f = 0; f < frames; ++f) reachable[f] = search.try_reach(f, path.row(f).transpose());
  std::vector<bool> judged = reachable;
  for (int stride = kInitialStride; stride > 0; stride /= 2) {
    for (int f = 0; f < frames; f += stride) {
      if (judged[f]) continue;
      judged[f] = true;
      reachable[f] =
          search.try_reach_from_neighbour(f) ||
          (!search.is_proven_out_of_reach(f) && search.search_posture(f, path.row(f).transpose()));
    }
  }
  // The posture found for one frame may reach the goals of frames judged before it.
  const auto spread = [&](int f) {
    reachable[f] = reachable[f] || search.try_reach_from_neighbour(f);
  };
  for (int f = 0; f < frames; ++f) spread(f);
  for (int f = static_cast<int>(frames) - 1; f >= 0; --f) spread(f);
  return reachable;
}

}  // namespace morphe::map
