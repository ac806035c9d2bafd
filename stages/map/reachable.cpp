#include "stages/map/reachable.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include "core/math/seed.hpp"
#include "core/robot/pull_tips.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;

constexpr int kPullSteps = 12;  ///< steps
/// Frames are judged in rounds, each twice as dense as the one before: the middle of a stretch out
/// of reach, where the error is largest, is likely to prove the rest.
constexpr std::size_t kSparsest = 16;
constexpr int kShorter = 8;  ///< search beside a frame that one has found to be out of reach

/// How far one frame's goals are from another's, over the tips that the other asks for; infinite if
/// this one does not ask for all of them.
double goals_apart(const robot::Robot& robot, const humanlike::FrameGoal& goal,
                   const humanlike::FrameGoal& other) {
  double squared = 0;
  for (std::size_t tip = 0; tip < goal.tip_position.size(); ++tip) {
    if (!seen(other.tip_position[tip])) continue;
    if (!seen(goal.tip_position[tip])) return std::numeric_limits<double>::infinity();
    double apart = (goal.tip_position[tip] - other.tip_position[tip]).norm();
    const double shares = std::abs(goal.pad_share_of(tip) - other.pad_share_of(tip));
    if (shares > 0) {  // they ask for different points of the link
      apart += shares * (robot.pads[tip].centre - robot.tips[tip].transform.translation()).norm();
    }
    squared += apart * apart;
  }
  return std::sqrt(squared);
}

/// What is known of a movement's frames so far.
class Judge {
 public:
  Judge(const MappingProblem& problem, const ReachOptions& options, std::uint64_t seed)
      : problem_(problem), options_(options), seed_(seed), reached_(problem.frames()) {}

  /// Whether the tips can be drawn from a posture to their goals: if so, it is remembered.
  bool drawn(std::size_t frame, JointVector q) {
    if (robot::pull_tips(*problem_.robot, problem_.goals[frame].tip_position,
                         problem_.goals[frame].pad_share, kPullSteps, options_.tolerance_m, q,
                         draw_) > options_.tolerance_m) {
      return false;
    }
    reached_[frame] = std::move(q);
    return true;
  }

  /// From the nearest frame whose goals are reached.
  bool drawn_from_neighbour(std::size_t frame) {
    for (std::size_t away = 1; away <= kSparsest; ++away) {
      for (const std::size_t other : {frame - away, frame + away}) {  // below 0: beyond any size
        if (other >= reached_.size() || reached_[other].size() == 0) continue;
        return drawn(frame, reached_[other]);
      }
    }
    return false;
  }

  bool proven_out_of_reach(std::size_t frame) const {
    const humanlike::FrameGoal& goal = problem_.goals[frame];
    const double met = met_m(frame);
    return std::ranges::any_of(out_of_reach_, [&](const OutOfReach& other) {
      return other.error_m - goals_apart(*problem_.robot, goal, problem_.goals[other.frame]) > met;
    });
  }

  /// By a search; a shorter one where a neighbour's had no success.
  bool found(std::size_t frame, const JointVector& near) {
    constexpr double kSameValue = 1e-4;  // relative
    constexpr int kOftenEnough = 8;      // descents that end in the least value: it is the least
    constexpr double kHopeless = 2;      // times the least, after the first steps of a descent
    const MappingProblem plain = tips_alone(problem_, frame);
    solve::MinimiseOptions first_steps = options_.solver, as_exact = options_.solver;
    first_steps.relative_value = std::max(first_steps.relative_value, 1e-2);
    as_exact.relative_value = std::max(as_exact.relative_value, 1e-4 * kSameValue);
    const double tip_weight = plain.objective.get<humanlike::TipPosition>().weight;
    const double met = tip_weight * met_m(frame) * met_m(frame);
    std::mt19937_64 random(math::seed_from(seed_, "frame", frame));
    std::vector<JointVector> starts{near};
    int random_starts = options_.starts;
    if (const OutOfReach* neighbour = nearest_out_of_reach(frame)) {
      starts.push_back(neighbour->q);
      random_starts /= kShorter;
    }
    for (int i = 0; i < random_starts; ++i) starts.push_back(random_start(*problem_.robot, random));
    solve::Minimum best;
    best.value = std::numeric_limits<double>::infinity();
    int ended_there = 0;
    for (std::size_t i = 0; i < starts.size() && ended_there < kOftenEnough; ++i) {
      solve::Minimum minimum = solve_frame(plain, 0, starts[i], first_steps, scratch_);
      if (minimum.value > kHopeless * best.value) continue;
      minimum = solve_frame(plain, 0, minimum.x, as_exact, scratch_);
      if (minimum.value <= met && drawn(frame, minimum.x)) return true;
      if (minimum.value < (1 - kSameValue) * best.value) ended_there = 0;
      if (minimum.value < (1 + kSameValue) * best.value) ++ended_there;
      if (minimum.value < best.value) best = std::move(minimum);
    }
    out_of_reach_.push_back({frame, std::sqrt(best.value / tip_weight), best.x});
    return false;
  }

 private:
  /// The greatest error of a frame whose tips all meet their goals: root of the sum of squares.
  double met_m(std::size_t frame) const {
    return std::sqrt(static_cast<double>(problem_.goals[frame].tips_seen())) * options_.tolerance_m;
  }

  struct OutOfReach {
    std::size_t frame;
    double error_m;  ///< the least that a search found
    JointVector q;   ///< where
  };

  const OutOfReach* nearest_out_of_reach(std::size_t frame) const {
    const OutOfReach* nearest = nullptr;
    std::size_t least = kSparsest;
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
  std::vector<JointVector> reached_;  ///< postures that reach a frame's goals; empty: none known
  std::vector<OutOfReach> out_of_reach_;
  robot::PullScratch draw_;
  MappingScratch scratch_;
};

}  // namespace

MappingProblem tips_alone(const MappingProblem& problem, std::size_t frame) {
  MappingProblem plain = on_frames(problem, {frame});
  plain.goals.front().weights = {};
  plain.clearance.weight = 0;
  plain.objective = {};
  plain.objective.get<humanlike::TipPosition>() = problem.objective.get<humanlike::TipPosition>();
  return plain;
}

std::vector<bool> reachable_frames(const MappingProblem& problem, const JointRows& near,
                                   const ReachOptions& options, std::uint64_t seed) {
  Judge judge(problem, options, seed);
  const auto near_at = [&](std::size_t frame) -> JointVector {
    return near.row(static_cast<Index>(frame)).transpose();
  };
  std::vector<bool> reachable(problem.frames());
  // From a mapped posture tips are nearly always drawn to their goals, at a fraction of a solve.
  for (std::size_t f = 0; f < problem.frames(); ++f) reachable[f] = judge.drawn(f, near_at(f));
  std::vector<bool> judged = reachable;
  for (std::size_t stride = kSparsest; stride > 0; stride /= 2) {
    for (std::size_t f = 0; f < problem.frames(); f += stride) {
      if (judged[f]) continue;
      judged[f] = true;
      reachable[f] = judge.drawn_from_neighbour(f) ||
                     (!judge.proven_out_of_reach(f) && judge.found(f, near_at(f)));
    }
  }
  // What one frame's search found may reach the goals of frames judged before it.
  const auto spread = [&](std::size_t f) {
    reachable[f] = reachable[f] || judge.drawn_from_neighbour(f);
  };
  for (std::size_t f = 0; f < problem.frames(); ++f) spread(f);
  for (std::size_t f = problem.frames(); f-- > 0;) spread(f);
  return reachable;
}

}  // namespace morphe::map
