#include "pipeline/planning/dead_end.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/math/seed.hpp"
#include "pipeline/planning/firmness.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe::planning {
namespace {

constexpr std::size_t kFrames = 6;    ///< looked at for one path
constexpr double kNearly = 5e-4;      ///< nearer to good enough: another search may do [m]
constexpr int kFirstLook = 40;        ///< evaluations from each start
constexpr std::size_t kToTheEnd = 6;  ///< the best of what these found, solved as exactly as asked

/// Frames nearest to the beginning, middle and end of each finding, the worst finding first.
std::vector<std::size_t> frames_of(std::vector<Finding> findings, const std::vector<double>& time) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.depth > b.depth; });
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
  if (world.target < 0) return kNotSeen;
  const SceneObject& target = world.scene->objects[static_cast<std::size_t>(world.target)];
  return target.attached_frame.empty() ? kNotSeen : target.attach_s;
}

/// A posture that was looked at for a frame.
struct Looked {
  JointVector q;
  std::vector<Finding> findings;

  double badness() const {
    double sum = 0;
    for (const Finding& finding : findings) sum += finding.depth;
    return sum;
  }
};

/// One frame of the movement, and how bad the best posture for it is.
struct Moment {
  const map::MappingProblem& problem;
  std::size_t frame;
  const repair::Check& check;

  std::vector<Finding> findings(const JointVector& q) const {
    return check({q.transpose(), {Origin::resolved}, {problem.time[frame]}});
  }
};

bool tracked(const std::vector<Finding>& findings) {
  return std::ranges::none_of(findings,
                              [](const Finding& f) { return f.cause == Cause::tracking; });
}

}  // namespace

std::optional<DeadEnd> find_dead_end(const map::MappingProblem& problem,
                                     const repair::Checked& checked, const repair::Check& check,
                                     const map::MapOptions& options, std::uint64_t seed,
                                     std::vector<Hold>& holds) {
  const map::MappingProblem firm_problem = as_firm(problem, {100}),
                            decided = as_firm(problem, kFirmest), alone = as_firm(problem, {0}),
                            decided_alone = as_firm(decided, {0});
  map::MappingScratch scratch;
  for (const std::size_t frame : frames_of(checked.findings, problem.time)) {
    if (problem.time[frame] >= attached_from(*problem.world)) continue;
    const Moment moment{problem, frame, check};
    const auto look = [&](const JointVector& start, const solve::MinimiseOptions& solver) {
      const JointVector q = map::solve_frame(decided, frame, start, solver, scratch).x;
      return Looked{q, moment.findings(q)};
    };
    const JointVector on_path = checked.path.position.row(static_cast<Eigen::Index>(frame));
    std::vector<Looked> looked{look(on_path, options.solver)};
    const auto held = [&] { return looked.back().findings.empty(); };
    if (held()) {
      holds.push_back({frame, looked.back().q});
      continue;
    }
    for (const solve::Minimum& start : map::search_frame(
             firm_problem, frame, 2 * options.starts, 2 * options.starts,
             map::quick(options.solver), math::seed_from(seed, "dead end", frame), scratch)) {
      looked.push_back(look(start.x, map::limited(options.solver, kFirstLook)));
      if (held()) break;
    }
    if (!held()) {
      std::ranges::stable_sort(looked, {}, &Looked::badness);
      const std::size_t best = std::min(kToTheEnd, looked.size());
      for (std::size_t i = 0; i < best && !held(); ++i) {
        looked.push_back(look(looked[i].q, options.solver));
      }
    }
    if (held()) {
      holds.push_back({frame, looked.back().q});
      continue;
    }
    const Looked& best = *std::ranges::min_element(looked, {}, &Looked::badness);
    if (best.badness() < kNearly) continue;
    DeadEnd end{Reason::unreachable, problem.time[frame], static_cast<int>(looked.size()),
                *std::ranges::max_element(best.findings, {}, &Finding::depth)};
    for (const solve::Minimum& start : map::search_frame(
             alone, frame, options.starts, options.candidates, map::quick(options.solver),
             math::seed_from(seed, "dead end alone", frame), scratch)) {
      const JointVector q =
          map::solve_frame(decided_alone, frame, start.x, options.solver, scratch).x;
      if (tracked(moment.findings(q))) end.reason = Reason::goal_in_collision;
    }
    return end;
  }
  return std::nullopt;
}

repair::Made stop_at_dead_end(const map::MappingProblem& problem, const repair::Checked& best,
                              const repair::Check& check, const map::MapOptions& options,
                              std::uint64_t seed, std::vector<Hold>& holds) {
  const std::optional<DeadEnd> end = find_dead_end(problem, best, check, options, seed, holds);
  if (!end) return {best, {}, false, "none: single postures are free wherever it looked"};
  const std::string detail = fmt::format("the best of {} postures for {:.3f} s has {}", end->tried,
                                         end->time_s, repair::sentence(end->nearest));
  return {best, {end->reason, detail}, true};
}

}  // namespace morphe::planning
