#include "pipeline/planning/infeasible_frame.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/math/seed.hpp"
#include "pipeline/planning/clearance_weights.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe::planning {
namespace {

constexpr std::size_t kFrames = 6;  ///< maximum number of frames per path
/// depth below which a frame may be feasible in another search [m]
constexpr double kNearlyFeasibleDepth_m = 5e-4;
constexpr int kCoarseEvaluations = 40;  ///< evaluations per start
/// the best results, solved to the requested accuracy
constexpr std::size_t kRefinedCandidateCount = 6;

/// Returns the frames nearest to the begin, middle and end of each finding, the worst finding
/// first.
std::vector<std::size_t> frames_of(std::vector<Finding> findings, const std::vector<double>& time) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.excess > b.excess; });
  std::vector<std::size_t> frames;
  for (const Finding& finding : findings) {
    for (const double share : {0.5, 0.0, 1.0}) {
      const double time_s = finding.begin_s + share * (finding.end_s - finding.begin_s);
      const auto next = std::ranges::lower_bound(time, time_s - 1e-9);
      const auto frame = std::min(time.size() - 1, static_cast<std::size_t>(next - time.begin()));
      if (std::ranges::find(frames, frame) == frames.end()) frames.push_back(frame);
      if (frames.size() == kFrames) return frames;
    }
  }
  return frames;
}

double attached_from(const collision::CollisionWorld& world) {
  if (world.target < 0) return kUnknown;
  const SceneObject& target = world.scene->objects[world.target];
  return target.attached_frame.empty() ? kUnknown : target.attach_s;
}

/// A posture evaluated for a frame.
struct TriedPosture {
  JointVector q;
  std::vector<Finding> findings;

  double badness() const {
    double sum = 0;
    for (const Finding& finding : findings) sum += finding.excess;
    return sum;
  }
};

/// A frame of the movement, with the check of postures for it.
struct FrameCheck {
  const map::MappingProblem& problem;
  std::size_t frame;
  const repair::PathCheck& check;

  std::vector<Finding> findings(const JointVector& q) const {
    return check({q.transpose(), {SampleOrigin::re_solved}, {problem.time[frame]}});
  }
};

bool tracks_goals(const std::vector<Finding>& findings) {
  return std::ranges::none_of(findings,
                              [](const Finding& f) { return f.cause == Cause::tracking; });
}

}  // namespace

std::optional<InfeasibleFrame> find_infeasible_frame(const map::MappingProblem& problem,
                                                     const repair::CheckedPath& checked,
                                                     const repair::PathCheck& check,
                                                     const map::MapOptions& options,
                                                     std::uint64_t seed,
                                                     std::vector<FeasiblePosture>& holds) {
  const map::MappingProblem firm_problem = with_clearance_weights(problem, {100}),
                            strongest_problem = with_clearance_weights(problem, kStrongestWeights),
                            no_clearance_problem = with_clearance_weights(problem, {0}),
                            decided_alone = with_clearance_weights(strongest_problem, {0});
  map::MappingScratch scratch;
  for (const std::size_t frame : frames_of(checked.findings, problem.time)) {
    if (problem.time[frame] >= attached_from(*problem.world)) continue;
    const FrameCheck moment{problem, frame, check};
    const auto look = [&](const JointVector& start, const solve::MinimiseOptions& solver) {
      const JointVector q = map::solve_frame(strongest_problem, frame, start, solver, scratch).x;
      return TriedPosture{q, moment.findings(q)};
    };
    const JointVector on_path = checked.path.position.row(frame);
    std::vector<TriedPosture> looked{look(on_path, options.frame_solver)};
    const auto held = [&] { return looked.back().findings.empty(); };
    if (held()) {
      holds.push_back({frame, looked.back().q});
      continue;
    }
    for (const solve::Minimum& start :
         map::search_frame(firm_problem, frame, 2 * options.starts, 2 * options.starts,
                           map::quick_stages(options.frame_solver),
                           math::seed_from(seed, "dead end", frame), scratch)) {
      looked.push_back(
          look(start.x, map::limit_evaluations(options.frame_solver, kCoarseEvaluations)));
      if (held()) break;
    }
    if (!held()) {
      std::ranges::stable_sort(looked, {}, &TriedPosture::badness);
      const std::size_t best = std::min(kRefinedCandidateCount, looked.size());
      for (std::size_t i = 0; i < best && !held(); ++i) {
        looked.push_back(look(looked[i].q, options.frame_solver));
      }
    }
    if (held()) {
      holds.push_back({frame, looked.back().q});
      continue;
    }
    const TriedPosture& best = *std::ranges::min_element(looked, {}, &TriedPosture::badness);
    if (best.badness() < kNearlyFeasibleDepth_m) continue;
    InfeasibleFrame end{Reason::unreachable, problem.time[frame], static_cast<int>(looked.size()),
                        *std::ranges::max_element(best.findings, {}, &Finding::excess)};
    for (const solve::Minimum& start :
         map::search_frame(no_clearance_problem, frame, options.starts, options.candidates,
                           map::quick_stages(options.frame_solver),
                           math::seed_from(seed, "dead end alone", frame), scratch)) {
      const JointVector q =
          map::solve_frame(decided_alone, frame, start.x, options.frame_solver, scratch).x;
      if (tracks_goals(moment.findings(q))) end.reason = Reason::goal_in_collision;
    }
    return end;
  }
  return std::nullopt;
}

repair::StrategyResult stop_if_infeasible(const map::MappingProblem& problem,
                                          const repair::CheckedPath& best,
                                          const repair::PathCheck& check,
                                          const map::MapOptions& options, std::uint64_t seed,
                                          std::vector<FeasiblePosture>& holds) {
  const std::optional<InfeasibleFrame> end =
      find_infeasible_frame(problem, best, check, options, seed, holds);
  if (!end) return {best, {}, false, "no infeasible frame found"};
  const std::string detail =
      fmt::format("at {:.3f} s the best of {} postures leaves {}", end->time_s, end->tried,
                  repair::excess_text(end->nearest));
  return {best, {end->reason, detail}, true};
}

}  // namespace morphe::planning
