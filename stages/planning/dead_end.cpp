#include "stages/planning/dead_end.hpp"

#include <algorithm>

#include "stages/map/frame_search.hpp"

namespace morphe::planning {
namespace {

using Judge = std::function<std::vector<Finding>(const JointPath&)>;

constexpr std::size_t kFrames = 6;  ///< looked at for one path
constexpr double kNearly = 5e-4;    ///< nearer to good enough: another search may do [m]

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

double sum_of_depths(const std::vector<Finding>& findings) {
  double sum = 0;
  for (const Finding& finding : findings) sum += finding.depth;
  return sum;
}

/// One frame of the movement, and how bad the best posture for it is.
struct Moment {
  const map::MappingProblem& problem;
  std::size_t frame;
  const Judge& judge;

  std::vector<Finding> findings(const JointVector& q) const {
    return judge({q.transpose(), {Origin::resolved}, {problem.time[frame]}});
  }
};

/// Tips and freedom alone decide; a little more than what is asked for is kept clear.
map::MappingProblem stiff(const map::MappingProblem& problem) {
  map::MappingProblem result = problem;
  result.clearance.weight *= 30000;
  result.clearance.band_m *= 0.2;
  result.objective.get<humanlike::TipPosition>().weight *= 30;
  return result;
}

map::MappingProblem scaled(const map::MappingProblem& problem, double clearance) {
  map::MappingProblem result = problem;
  result.clearance.weight *= clearance;
  return result;
}

bool tracked(const std::vector<Finding>& findings) {
  return std::ranges::none_of(findings,
                              [](const Finding& f) { return f.cause == Cause::tracking; });
}

}  // namespace

std::optional<repair::DeadEnd> find_dead_end(const map::MappingProblem& problem,
                                             const JointPath& path,
                                             const std::vector<Finding>& findings,
                                             const Judge& judge, const map::MapOptions& options,
                                             std::uint64_t seed, std::vector<Hold>& holds) {
  const map::MappingProblem firm = scaled(problem, 100), alone = scaled(problem, 0),
                            decided = stiff(problem);
  map::MappingScratch scratch;
  for (const std::size_t frame : frames_of(findings, problem.time)) {
    if (problem.time[frame] >= attached_from(*problem.world)) continue;
    const Moment moment{problem, frame, judge};
    repair::DeadEnd end{Reason::unreachable, problem.time[frame], 0, {}};
    double least = std::numeric_limits<double>::infinity();
    bool held = false;
    const auto attempt = [&](const JointVector& start) {
      const JointVector q = map::solve_frame(decided, frame, start, options.solver, scratch).x;
      const std::vector<Finding> left = moment.findings(q);
      ++end.tried;
      if (left.empty()) {
        holds.push_back({frame, q});
        held = true;
      } else if (const double sum = sum_of_depths(left); sum < least) {
        least = sum;
        end.nearest = *std::ranges::max_element(left, {}, &Finding::depth);
      }
    };
    attempt(path.position.row(static_cast<Eigen::Index>(frame)).transpose());
    if (held) continue;
    for (const solve::Minimum& start :
         map::search_frame(firm, frame, 2 * options.starts, 2 * options.starts,
                           map::quick(options.solver), seed + frame, scratch)) {
      attempt(start.x);
      if (held) break;
    }
    if (held || least < kNearly) continue;
    for (const solve::Minimum& start :
         map::search_frame(alone, frame, options.starts, options.candidates,
                           map::quick(options.solver), seed + frame, scratch)) {
      const JointVector q =
          map::solve_frame(scaled(decided, 0), frame, start.x, options.solver, scratch).x;
      if (tracked(moment.findings(q))) end.reason = Reason::goal_in_collision;
    }
    return end;
  }
  return std::nullopt;
}

}  // namespace morphe::planning
