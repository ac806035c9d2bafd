#include "stages/map/reachability.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include "core/math/seed.hpp"
#include "core/robot/damped_least_squares_ik.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;

constexpr int kMaxIkSteps = 12;  ///< iterations of damped least squares
/// Frames are judged in rounds, each twice as dense as the previous one: the middle of an
/// unreachable interval, at which the error is largest, is likely to prove the rest unreachable.
constexpr std::size_t kInitialStride = 16;
/// Divisor of the number of random starts near a frame found unreachable.
constexpr int kStartsReductionFactor = 8;

/// Returns the distance of one frame's goals from another's over the tips that have a goal in the
/// other; infinite if one of these has no goal in this frame.
double goal_distance(const robot::Robot& robot, const humanlike::FrameGoal& goal,
                     const humanlike::FrameGoal& other) {
  double squared = 0;
  for (std::size_t tip = 0; tip < goal.tip_position.size(); ++tip) {
    if (!is_known(other.tip_position[tip])) continue;
    if (!is_known(goal.tip_position[tip])) return std::numeric_limits<double>::infinity();
    double apart = (goal.tip_position[tip] - other.tip_position[tip]).norm();
    const double shares = std::abs(goal.tip_to_pad_share_of(tip) - other.tip_to_pad_share_of(tip));
    if (shares > 0) {  // the goals refer to different points of the link
      apart += shares * (robot.pads[tip].centre - robot.tips[tip].transform.translation()).norm();
    }
    squared += apart * apart;
  }
  return std::sqrt(squared);
}

/// A search for postures that reach the frames of a movement, with its results so far.
class ReachabilitySearch {
 public:
  ReachabilitySearch(const MappingProblem& problem, const ReachOptions& options, std::uint64_t seed)
      : problem_(problem), options_(options), seed_(seed), reached_(problem.frames()) {}

  /// Returns true if damped least squares brings the tips from a posture to their goals; the
  /// posture is then stored.
  bool try_reach(std::size_t frame, JointVector q) {
    if (robot::damped_least_squares_ik(*problem_.robot, problem_.goals[frame].tip_position,
                                       problem_.goals[frame].tip_to_pad_share, kMaxIkSteps,
                                       options_.tolerance_m, q,
                                       ik_scratch_) > options_.tolerance_m) {
      return false;
    }
    reached_[frame] = std::move(q);
    return true;
  }

  /// Tries the posture of the nearest frame whose goals are reached.
  bool try_reach_from_neighbour(std::size_t frame) {
    for (std::size_t away = 1; away <= kInitialStride; ++away) {
      // A value below 0 wraps around and exceeds the size.
      for (const std::size_t other : {frame - away, frame + away}) {
        if (other >= reached_.size() || reached_[other].size() == 0) continue;
        return try_reach(frame, reached_[other]);
      }
    }
    return false;
  }

  bool is_proven_out_of_reach(std::size_t frame) const {
    const humanlike::FrameGoal& goal = problem_.goals[frame];
    const double met = error_tolerance_m(frame);
    return std::ranges::any_of(out_of_reach_, [&](const OutOfReach& other) {
      return other.error_m - goal_distance(*problem_.robot, goal, problem_.goals[other.frame]) >
             met;
    });
  }

  /// Searches from random starts, fewer of them if a neighbour's search failed. Returns true if the
  /// goals are reached.
  bool search_posture(std::size_t frame, const JointVector& near) {
    constexpr double kSameValueTolerance = 1e-4;  // relative
    // Number of descents to the least value after which it is accepted as the minimum.
    constexpr int kMinRepeatedMinima = 8;
    // Relative to the least value, after the first steps of a descent.
    constexpr double kAbandonValueRatio = 2;
    const MappingProblem plain = tip_position_problem(problem_, frame);
    solve::MinimiseOptions first_steps = options_.solver, as_exact = options_.solver;
    first_steps.relative_tolerance = std::max(first_steps.relative_tolerance, 1e-2);
    as_exact.relative_tolerance = std::max(as_exact.relative_tolerance, 1e-4 * kSameValueTolerance);
    const double tip_weight = plain.objective.get<humanlike::TipPosition>().weight;
    const double met = tip_weight * error_tolerance_m(frame) * error_tolerance_m(frame);
    std::mt19937_64 random(math::seed_from(seed_, "frame", frame));
    std::vector<JointVector> starts{near};
    int random_starts = options_.starts;
    if (const OutOfReach* neighbour = nearest_out_of_reach(frame)) {
      starts.push_back(neighbour->q);
      random_starts /= kStartsReductionFactor;
    }
    for (int i = 0; i < random_starts; ++i) starts.push_back(random_start(*problem_.robot, random));
    solve::Minimum best;
    best.value = std::numeric_limits<double>::infinity();
    int repeats = 0;
    for (std::size_t i = 0; i < starts.size() && repeats < kMinRepeatedMinima; ++i) {
      solve::Minimum minimum = solve_frame(plain, 0, starts[i], first_steps, scratch_);
      if (minimum.value > kAbandonValueRatio * best.value) continue;
      minimum = solve_frame(plain, 0, minimum.x, as_exact, scratch_);
      if (minimum.value <= met && try_reach(frame, minimum.x)) return true;
      if (minimum.value < (1 - kSameValueTolerance) * best.value) repeats = 0;
      if (minimum.value < (1 + kSameValueTolerance) * best.value) ++repeats;
      if (minimum.value < best.value) best = std::move(minimum);
    }
    out_of_reach_.push_back({frame, std::sqrt(best.value / tip_weight), best.x});
    return false;
  }

 private:
  /// Returns the largest error of a frame whose tips all reach their goals: the root of the sum of
  /// squares.
  double error_tolerance_m(std::size_t frame) const {
    return std::sqrt(static_cast<double>(problem_.goals[frame].goal_tip_count())) *
           options_.tolerance_m;
  }

  struct OutOfReach {
    std::size_t frame;
    double error_m;  ///< least error found by a search
    JointVector q;   ///< posture of that error
  };

  const OutOfReach* nearest_out_of_reach(std::size_t frame) const {
    const OutOfReach* nearest = nullptr;
    std::size_t least = kInitialStride;
    for (const OutOfReach& other : out_of_reach_) {
      const std::size_t away = other.frame > frame ? other.frame - frame : frame - other.frame;
      if (away > least || (away == least && nearest)) continue;
      least = away;
      nearest = &other;
    }
    return nearest;
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
  MappingProblem plain = problem_at_frames(problem, {frame});
  plain.goals.front().weights = {};
  plain.clearance.weight = 0;
  plain.objective = {};
  plain.objective.get<humanlike::TipPosition>() = problem.objective.get<humanlike::TipPosition>();
  return plain;
}

std::vector<bool> reachable_frames(const MappingProblem& problem, const JointRows& near,
                                   const ReachOptions& options, std::uint64_t seed) {
  ReachabilitySearch judge(problem, options, seed);
  const auto near_at = [&](std::size_t frame) -> JointVector {
    return near.row(frame).transpose();
  };
  std::vector<bool> reachable(problem.frames());
  // From a mapped posture damped least squares nearly always reaches the goals, at a fraction of
  // the cost of a solve.
  for (std::size_t f = 0; f < problem.frames(); ++f) reachable[f] = judge.try_reach(f, near_at(f));
  std::vector<bool> judged = reachable;
  for (std::size_t stride = kInitialStride; stride > 0; stride /= 2) {
    for (std::size_t f = 0; f < problem.frames(); f += stride) {
      if (judged[f]) continue;
      judged[f] = true;
      reachable[f] = judge.try_reach_from_neighbour(f) ||
                     (!judge.is_proven_out_of_reach(f) && judge.search_posture(f, near_at(f)));
    }
  }
  // The posture found for one frame may reach the goals of frames judged before it.
  const auto spread = [&](std::size_t f) {
    reachable[f] = reachable[f] || judge.try_reach_from_neighbour(f);
  };
  for (std::size_t f = 0; f < problem.frames(); ++f) spread(f);
  for (std::size_t f = problem.frames(); f-- > 0;) spread(f);
  return reachable;
}

}  // namespace morphe::map
