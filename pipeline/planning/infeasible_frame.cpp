#include "pipeline/planning/infeasible_frame.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/math/seed.hpp"
#include "core/motion/finding_text.hpp"
#include "pipeline/planning/constants.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe::planning {
namespace {

/// Returns at most kMaxFramesPerPath frames: at middle, begin and end of findings, the worst first.
std::vector<std::size_t> frames_of(std::vector<Finding> findings, const std::vector<double>& time) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.excess_m() > b.excess_m(); });
  std::vector<std::size_t> frames;
  for (const Finding& finding : findings) {
    for (const double share : {0.5, 0.0, 1.0}) {
      const double time_s = finding.begin_s + share * (finding.end_s - finding.begin_s);
      const auto next = std::ranges::lower_bound(time, time_s - 1e-9);
      const auto frame = std::min(time.size() - 1, static_cast<std::size_t>(next - time.begin()));
      if (std::ranges::find(frames, frame) == frames.end()) frames.push_back(frame);
      if (std::ssize(frames) == kMaxFramesPerPath) return frames;
    }
  }
  return frames;
}

/// Returns the time from which the target is attached; NaN if it never is, which compares as later.
double attach_time(const collision::CollisionWorld& world) {
  if (world.target < 0) return kUnknown;
  const SceneObject& target = world.scene->objects[world.target];
  return target.attached_frame.empty() ? kUnknown : target.attach_s;
}

/// A posture and its findings in a frame.
struct TriedPosture {
  JointVector q;
  std::vector<Finding> findings;

  double excess_sum_m() const {
    double sum = 0;
    for (const Finding& finding : findings) sum += finding.excess_m();
    return sum;
  }
  /// Returns the worst finding for which `counts` is true, or null.
  template <class Counts>
  const Finding* worst(const Counts& counts) const {
    const Finding* worst = nullptr;
    for (const Finding& finding : findings) {
      if (counts(finding) && (!worst || finding.excess_m() > worst->excess_m())) worst = &finding;
    }
    return worst;
  }
};

/// Checks postures in one frame of the movement.
struct FrameCheck {
  const map::MappingProblem& problem;
  std::size_t frame;
  const repair::PathCheck& check;

  std::vector<Finding> findings(const JointVector& q) const {
    return check({q.transpose(), {SampleOrigin::re_solved}, {problem.time[frame]}});
  }
};

const Finding* tip_error(const TriedPosture& posture) {
  return posture.worst([](const Finding& f) { return f.cause == Cause::tracking; });
}
const Finding* other_fault(const TriedPosture& posture) {
  return posture.worst([](const Finding& f) { return f.cause != Cause::tracking; });
}

/// Returns the posture with the least summed excess of those for which `allowed` is true, or null.
template <class Allowed>
const TriedPosture* best_of(const std::vector<TriedPosture>& tried, const Allowed& allowed) {
  const TriedPosture* best = nullptr;
  for (const TriedPosture& posture : tried) {
    if (allowed(posture) && (!best || posture.excess_sum_m() < best->excess_sum_m()))
      best = &posture;
  }
  return best;
}

/// Decides the reason by all postures that were tried, none of which is free of findings, and keeps
/// the findings that show it.
InfeasibleFrame infeasible_frame(double time_s, const std::vector<TriedPosture>& tried) {
  InfeasibleFrame frame{Reason::unreachable, time_s, static_cast<int>(tried.size()), {}, {}};
  const auto meets_goals = [](const TriedPosture& posture) { return !tip_error(posture); };
  const auto is_clear = [](const TriedPosture& posture) { return !other_fault(posture); };
  if (const TriedPosture* const meeting = best_of(tried, meets_goals)) {
    frame.reason = Reason::goal_in_collision;
    frame.worst_finding = *other_fault(*meeting);
    if (const TriedPosture* const clear = best_of(tried, is_clear))
      frame.tip_error_if_clear = *tip_error(*clear);
    return frame;
  }
  frame.worst_finding = *tip_error(*std::ranges::min_element(
      tried, {}, [](const TriedPosture& posture) { return tip_error(posture)->excess_m(); }));
  return frame;
}

}  // namespace

std::optional<InfeasibleFrame> find_infeasible_frame(const map::MappingProblem& problem,
                                                     const repair::CheckedPath& checked,
                                                     const repair::PathCheck& check,
                                                     const map::MapOptions& options,
                                                     std::uint64_t seed,
                                                     std::vector<FeasiblePosture>& postures) {
  const map::MappingProblem search_problem = with_clearance_weights(problem, {100}),
                            strongest_problem = with_clearance_weights(problem, kStrongestWeights),
                            no_clearance_problem = with_clearance_weights(problem, {0}),
                            tips_only_problem = with_clearance_weights(strongest_problem, {0});
  map::MappingScratch scratch;
  for (const std::size_t frame : frames_of(checked.findings, problem.time)) {
    if (problem.time[frame] >= attach_time(*problem.world)) continue;
    const FrameCheck frame_check{problem, frame, check};
    const auto try_posture = [&](const JointVector& start, const solve::MinimiseOptions& solver) {
      const JointVector q = map::solve_frame(strongest_problem, frame, start, solver, scratch).x;
      return TriedPosture{q, frame_check.findings(q)};
    };
    const JointVector on_path = checked.path.position.row(frame);
    std::vector<TriedPosture> tried{try_posture(on_path, options.frame_solver)};
    const auto found = [&] { return tried.back().findings.empty(); };
    if (found()) {
      postures.push_back({frame, tried.back().q});
      continue;
    }
    for (const solve::Minimum& start :
         map::search_frame(search_problem, frame, 2 * options.starts, 2 * options.starts,
                           map::quick_stages(options.frame_solver),
                           math::seed_from(seed, "dead end", frame), scratch)) {
      tried.push_back(
          try_posture(start.x, map::limit_evaluations(options.frame_solver, kCoarseEvaluations)));
      if (found()) break;
    }
    if (!found()) {
      std::ranges::stable_sort(tried, {}, &TriedPosture::excess_sum_m);
      const std::ptrdiff_t refined_count =
          std::min<std::ptrdiff_t>(kRefinedCandidateCount, std::ssize(tried));
      for (int i = 0; i < refined_count && !found(); ++i) {
        tried.push_back(try_posture(tried[i].q, options.frame_solver));
      }
    }
    if (found()) {
      postures.push_back({frame, tried.back().q});
      continue;
    }
    const TriedPosture& nearest = *std::ranges::min_element(tried, {}, &TriedPosture::excess_sum_m);
    if (nearest.excess_sum_m() < kNearlyFeasibleDepth_m) continue;
    for (const solve::Minimum& start :
         map::search_frame(no_clearance_problem, frame, options.starts, options.candidates,
                           map::quick_stages(options.frame_solver),
                           math::seed_from(seed, "dead end alone", frame), scratch)) {
      const JointVector q =
          map::solve_frame(tips_only_problem, frame, start.x, options.frame_solver, scratch).x;
      tried.push_back({q, frame_check.findings(q)});
      if (found()) break;
    }
    if (!found()) return infeasible_frame(problem.time[frame], tried);
    postures.push_back({frame, tried.back().q});
  }
  return std::nullopt;
}

std::string detail_of(const InfeasibleFrame& frame) {
  if (frame.reason == Reason::unreachable)
    return fmt::format("at {:.2f} s the best of {} postures, with or without obstacles, leaves {}",
                       frame.time_s, frame.posture_count, excess_text(frame.worst_finding));
  std::string detail =
      fmt::format("at {:.2f} s, of {} postures, the best that reaches the goals has {}",
                  frame.time_s, frame.posture_count, excess_text(frame.worst_finding));
  if (frame.tip_error_if_clear)
    detail += fmt::format("; the best without a collision leaves {}",
                          excess_text(*frame.tip_error_if_clear));
  return detail;
}

repair::StrategyResult stop_if_infeasible(const map::MappingProblem& problem,
                                          const repair::CheckedPath& best,
                                          const repair::PathCheck& check,
                                          const map::MapOptions& options, std::uint64_t seed,
                                          std::vector<FeasiblePosture>& postures) {
  const std::optional<InfeasibleFrame> fault =
      find_infeasible_frame(problem, best, check, options, seed, postures);
  if (!fault) return {best, {}, false, "no infeasible frame found"};
  return {best, {fault->reason, detail_of(*fault)}, true};
}

}  // namespace morphe::planning
