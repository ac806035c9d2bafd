#include "stages/repair_movement.hpp"

#include <algorithm>
#include <utility>

#include "stages/check/check_path.hpp"
#include "stages/dead_end.hpp"
#include "stages/map/movement_search.hpp"

namespace morphe {
namespace {

using Recheck = decltype(RepairSteps::recheck);

constexpr double kFirm = 100;  ///< times the clearance term of the mapping
/// A repaired path keeps this much more than the margin where it can: the curve through it is
/// smoothed, and certified to a tenth of a millimetre [m].
constexpr double kRoom = 2e-4;

/// How bad findings are: contacts count before everything else.
std::pair<double, double> badness(const std::vector<Finding>& findings) {
  std::pair<double, double> sum{0, 0};
  for (const Finding& finding : findings) {
    const bool contact =
        finding.cause == "self" || finding.cause == "object" || finding.cause == "table";
    (contact ? sum.first : sum.second) += finding.depth;
  }
  return sum;
}

/// The least change of the mapping first: the path itself re-solved against the whole scene, the
/// clearance term made firmer until tips give way to it; then the other courses that the mapping
/// kept. The first without findings, or the one with the least of them.
JointPath resolve_with_candidates(const MappingProblem& problem, const MapResult& mapped,
                                  const JointPath& path, const std::vector<Finding>& findings,
                                  const MapOptions& options, const Recheck& recheck) {
  JointPath best = path;
  std::pair<double, double> least = badness(findings);
  const std::pair<double, double> none{0, 0};
  struct Step {
    double clearance, band_share = 1, tips = 1;  ///< times what the mapping gives them
  };
  const auto attempt = [&](const JointPath& from, const std::vector<Finding>& found,
                           const Step& step) {
    MappingProblem clear = problem;
    clear.clearance.band_m *= step.band_share;
    clear.objective.tip_position.weight *= step.tips;
    JointPath changed = resolve_path(clear, from, found, options, step.clearance);
    const std::pair<double, double> left = badness(recheck(changed));
    if (left >= least) return;
    least = left;
    best = std::move(changed);
  };
  for (const double firmness : {10.0, 100.0, 1000.0}) {
    if (least > none) attempt(path, findings, {firmness});
  }
  for (const JointRows& candidate : mapped.candidates) {
    if (least == none) break;
    JointPath other = path;
    other.position = candidate;
    std::fill(other.origin.begin(), other.origin.end(), Origin::resolved);
    attempt(other, recheck(other), {100.0});
  }
  // Tips that gave way to clearance nobody asked for come back to what is just free; at last tips
  // and freedom alone decide.
  for (const Step& step : {Step{10000, 0.2}, Step{30000, 0.2, 30}}) {
    if (least > none) attempt(JointPath(best), recheck(best), step);
  }
  return best;
}

/// Other courses, one after the other, refined to every frame: those through the postures that hold
/// goals at which the path failed, then those of new searches, the best of each first. A search
/// waits until its first is asked for.
class NewCourses {
 public:
  NewCourses(const MappingProblem& whole, const MapOptions& options, const std::vector<Hold>& holds,
             int searches, std::uint64_t seed)
      : problem_(whole), options_(options), holds_(holds), searches_(searches), seed_(seed) {
    problem_.clearance.weight *= kFirm;
  }

  std::optional<JointPath> operator()() {
    if (next_hold_ < holds_.size()) {
      const Hold& hold = holds_[next_hold_++];
      return path_of(course_through(problem_, hold.frame, hold.q, options_).q);
    }
    if (next_ == courses_.size()) {
      if (searches_-- <= 0) return std::nullopt;
      seed_ += 100;  // past those of its key frames
      courses_ = search_movement(problem_, options_, seed_);
      next_ = 0;
    }
    return path_of(smooth_movement(problem_, courses_[next_++].q, options_).q);
  }

 private:
  JointPath path_of(JointRows q) const {
    return {std::move(q), std::vector<Origin>(problem_.frames(), Origin::resolved), problem_.time};
  }

  MappingProblem problem_;
  const MapOptions& options_;
  const std::vector<Hold>& holds_;
  std::size_t next_hold_ = 0;
  int searches_;  ///< left
  std::uint64_t seed_;
  std::vector<Course> courses_;
  std::size_t next_ = 0;
};

}  // namespace

RepairResult repair_movement(const Planner& planner, const PlacedMovement& placed,
                             const CollisionWorld& world, const Plan& plan, const MapResult& mapped,
                             std::uint64_t seed) {
  const PipelineConfig& config = planner.config;
  MappingProblem whole = placed.problem;
  whole.world = &world;
  const auto judge = [&](const CollisionWorld& judged, const JointPath& path) {
    return check_path(judged, plan.goals, plan.movement, path, config.check);
  };
  CollisionWorld roomy = world;
  roomy.tolerances.margin += kRoom;
  RepairSteps steps;
  steps.recheck = [&](const JointPath& path) { return judge(roomy, path); };
  steps.resolve = [&](const JointPath& path, const std::vector<Finding>& findings) {
    return resolve_with_candidates(whole, mapped, path, findings, config.map, steps.recheck);
  };
  std::vector<Hold> holds;
  if (mode_of(config.map) != MapMode::joint_to_joint) {  // which does not ask for tips
    steps.dead_end = [&](const JointPath& path, const std::vector<Finding>& findings) {
      const auto judge_moment = [&](const JointPath& moment) { return judge(world, moment); };
      return find_dead_end(whole, path, findings, judge_moment, config.map, seed, holds);
    };
  }
  steps.new_course = NewCourses(whole, config.map, holds, config.repair.searches, seed);
  RepairResult result = repair_path(world, planner.capsule_reach, plan.path, plan.findings, steps,
                                    config.repair, seed);
  if (!result.reason.empty() && judge(world, result.path).empty()) {
    result.reason.clear();
    result.detail.clear();
    result.remaining.clear();
    result.repaired = true;
  }
  return result;
}

}  // namespace morphe
