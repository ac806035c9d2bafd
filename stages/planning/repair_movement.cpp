#include "stages/planning/repair_movement.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "stages/check/check_path.hpp"
#include "stages/map/movement_search.hpp"
#include "stages/map/resolve_path.hpp"
#include "stages/planning/dead_end.hpp"

namespace morphe::planning {
namespace {

using Recheck = decltype(repair::RepairSteps::recheck);

constexpr double kFirmCourse = 100;  ///< times the clearance term of the mapping
/// A repaired path keeps this much more than the margin where it can: the curve through it is
/// smoothed, and certified to a tenth of a millimetre [m].
constexpr double kRoom = 2e-4;

/// How bad findings are: contacts count before everything else.
std::pair<double, double> badness(const std::vector<Finding>& findings) {
  std::pair<double, double> sum{0, 0};
  for (const Finding& finding : findings) {
    (is_collision(finding.cause) ? sum.first : sum.second) += finding.depth;
  }
  return sum;
}

struct Judged {
  JointPath path;
  std::vector<Finding> findings;
};

/// What a re-solve gives: times what the mapping gives them.
struct Firmness {
  double clearance, band_share = 1, tips = 1;
  int iterations = 1;
  double relative_value = 100;  ///< whether it gets free is soon seen
};
/// The clearance term firmer and firmer until tips give way to it; then, for tips that gave way to
/// clearance nobody asked for, just free; at last tips and freedom alone decide, to the last tenth
/// of a millimetre.
constexpr std::array<Firmness, 2> kGentle{{{10}, {100}}};
constexpr std::array<Firmness, 3> kFirm{{{1000}, {10000, 0.2}, {30000, 0.2, 30, 2, 1}}};

/// The least change of the mapping: the path re-solved near its findings against the whole scene.
Judged climb(std::span<const Firmness> ladder, const map::MappingProblem& whole,
             const map::MapOptions& options, const Recheck& recheck, Judged best) {
  for (const Firmness& step : ladder) {
    if (best.findings.empty()) break;
    const bool tips_alone = badness(best.findings).first == 0;
    if (tips_alone && step.band_share == 1) continue;
    map::MapOptions as_exact = options;
    as_exact.movement.iterations *= step.iterations;
    as_exact.movement.relative_value *= step.relative_value;
    map::MappingProblem firm = whole;
    firm.clearance.band_m *= step.band_share;
    firm.objective.get<humanlike::TipPosition>().weight *= step.tips;
    Judged changed{map::resolve_path(firm, best.path, best.findings, as_exact, step.clearance), {}};
    changed.findings = recheck(changed.path);
    if (badness(changed.findings) < badness(best.findings)) best = std::move(changed);
  }
  return best;
}

/// The same for the other courses that the mapping kept: the first without findings, or the least
/// bad of them all and the path.
Judged climb_candidates(const map::MappingProblem& whole, const map::MapOptions& options,
                        const Recheck& recheck, const std::vector<JointRows>& candidates,
                        Judged best) {
  for (const JointRows& candidate : candidates) {
    if (best.findings.empty()) break;
    Judged other{best.path, {}};
    other.path.position = candidate;
    std::ranges::fill(other.path.origin, Origin::resolved);
    other.findings = recheck(other.path);
    other = climb(kGentle, whole, options, recheck, std::move(other));
    if (repair::worth_insisting(other.findings)) {
      other = climb(kFirm, whole, options, recheck, std::move(other));
    }
    if (badness(other.findings) < badness(best.findings)) best = std::move(other);
  }
  return best;
}

/// Other courses, one after the other, refined to every frame: those through the postures that hold
/// goals at which the path failed, then those of new searches, the best of each first. A search
/// waits until its first is asked for, and is the last if no course of it came nearer.
class NewCourses {
 public:
  NewCourses(const map::MappingProblem& whole, const map::MapOptions& options,
             const std::vector<Hold>& holds, int searches, std::uint64_t seed)
      : problem_(whole), options_(options), holds_(holds), searches_(searches), seed_(seed) {
    problem_.clearance.weight *= kFirmCourse;
  }

  std::optional<JointPath> operator()(bool nearer) {
    nearer_ = nearer_ || nearer;
    if (next_hold_ < holds_.size()) {
      const Hold& hold = holds_[next_hold_++];
      return path_of(map::course_through(problem_, hold.frame, hold.q, options_).q);
    }
    if (next_ == courses_.size()) {
      if (searches_-- <= 0 || !nearer_) return std::nullopt;
      nearer_ = false;
      seed_ += 100;  // past those of its key frames
      courses_ = map::search_movement(problem_, options_, seed_);
      next_ = 0;
    }
    return path_of(map::smooth_movement(problem_, courses_[next_++].q, options_).q);
  }

 private:
  JointPath path_of(JointRows q) const {
    return {std::move(q), std::vector<Origin>(problem_.frames(), Origin::resolved), problem_.time};
  }

  map::MappingProblem problem_;
  const map::MapOptions& options_;
  const std::vector<Hold>& holds_;
  std::size_t next_hold_ = 0;
  int searches_;        ///< left
  bool nearer_ = true;  ///< a course of the last search was the best so far
  std::uint64_t seed_;
  std::vector<map::Course> courses_;
  std::size_t next_ = 0;
};

}  // namespace

repair::RepairResult repair_movement(const Planner& planner, const PlacedMovement& placed,
                                     const collision::CollisionWorld& world, const Plan& plan,
                                     const map::MapResult& mapped, std::uint64_t seed) {
  const PipelineConfig& config = planner.config;
  map::MappingProblem whole = placed.problem;
  whole.world = &world;
  const auto judge = [&](const collision::CollisionWorld& judged, const JointPath& path) {
    return check::check_path(judged, plan.goals, plan.movement, path, config.check);
  };
  collision::CollisionWorld roomy = world;
  roomy.tolerances.margin += kRoom;
  repair::RepairSteps steps;
  steps.recheck = [&](const JointPath& path) { return judge(roomy, path); };
  steps.resolve = [&](const JointPath& path, const std::vector<Finding>& findings) {
    return climb(kGentle, whole, config.map, steps.recheck, {path, findings}).path;
  };
  steps.insist = [&](const JointPath& path, const std::vector<Finding>& findings) {
    return climb(kFirm, whole, config.map, steps.recheck, {path, findings}).path;
  };
  steps.candidates = [&](const JointPath& path, const std::vector<Finding>& findings) {
    return climb_candidates(whole, config.map, steps.recheck, mapped.candidates, {path, findings})
        .path;
  };
  std::vector<Hold> holds;
  if (config.map.mode != map::MapMode::joint_to_joint) {  // which does not ask for tips
    steps.dead_end = [&](const JointPath& path, const std::vector<Finding>& findings) {
      const auto judge_moment = [&](const JointPath& moment) { return judge(world, moment); };
      return find_dead_end(whole, path, findings, judge_moment, config.map, seed, holds);
    };
  }
  steps.new_course = NewCourses(whole, config.map, holds, config.repair.searches, seed);
  repair::RepairResult result = repair::repair_path(world, planner.capsule_reach, plan.path,
                                                    plan.findings, steps, config.repair, seed);
  if (result.reason != Reason::none && judge(world, result.path).empty()) {
    result.reason = Reason::none;
    result.detail.clear();
    result.remaining.clear();
    result.repaired = true;
  }
  return result;
}

}  // namespace morphe::planning
