#include "stages/repair_movement.hpp"

#include <algorithm>
#include <utility>

#include "stages/check/check_path.hpp"
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
  const auto attempt = [&](const JointPath& from, const std::vector<Finding>& found,
                           double firmness, double band_share = 1) {
    MappingProblem clear = problem;
    clear.clearance.band_m *= band_share;
    JointPath changed = resolve_path(clear, from, found, options, firmness);
    const std::pair<double, double> left = badness(recheck(changed));
    if (left >= least) return;
    least = left;
    best = std::move(changed);
  };
  for (const double firmness : {10.0, 100.0, 1000.0}) {
    if (least > none) attempt(path, findings, firmness);
  }
  for (const JointRows& candidate : mapped.candidates) {
    if (least == none) break;
    JointPath other = path;
    other.position = candidate;
    std::fill(other.origin.begin(), other.origin.end(), Origin::resolved);
    attempt(other, recheck(other), 100.0);
  }
  // Tips that gave way to clearance nobody asked for come back to what is just free.
  if (least > none) attempt(JointPath(best), recheck(best), 10000.0, 0.2);
  return best;
}

/// The courses of a new search, one after the other, the best first, refined to every frame. The
/// search waits until the first is asked for.
class NewCourses {
 public:
  NewCourses(MappingProblem whole, const MapOptions& options, std::uint64_t seed)
      : problem_(std::move(whole)), options_(options), seed_(seed) {
    problem_.clearance.weight *= kFirm;
  }

  std::optional<JointPath> operator()() {
    if (next_ == 0) courses_ = search_movement(problem_, options_, seed_);
    if (next_ == courses_.size()) return std::nullopt;
    const JointRows& course = courses_[next_++].q;
    return JointPath{smooth_movement(problem_, course, options_).q,
                     std::vector<Origin>(problem_.frames(), Origin::resolved), problem_.time};
  }

 private:
  MappingProblem problem_;
  const MapOptions& options_;
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
  steps.new_course = NewCourses(whole, config.map, seed + 1);
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
