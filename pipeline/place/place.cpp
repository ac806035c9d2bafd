#include "pipeline/place/place.hpp"

#include <algorithm>

#include "core/math/seed.hpp"
#include "core/motion/input_error.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/place/constants.hpp"
#include "pipeline/place/reachability_grid.hpp"
#include "pipeline/place/refine.hpp"

namespace morphe::place {
namespace {

std::vector<BasePlacement> sample_placements(const ReachabilityGrid& grid, Side side,
                                             const std::vector<TrialMovement>& trials,
                                             const BasePlacement& configured,
                                             const PlaceOptions& options) {
  struct Sample {
    BasePlacement pose;
    double outside = 0;
  };
  std::vector<Sample> samples;
  math::RandomStream random(options.seed, "places");
  for (int k = 0; k < options.samples; ++k) {
    Sample sample{random_base_placement(configured, options, random), 0};
    if (!is_base_allowed(trials, sample.pose, grid.shoulder(), side, options)) continue;
    for (const TrialMovement& trial : trials)
      sample.outside += grid.share_out_of_reach(trial, sample.pose);
    samples.push_back(std::move(sample));
  }
  if (samples.empty())
    throw InputError("place: no placement of the base satisfies the constraints");
  std::ranges::stable_sort(samples, {}, &Sample::outside);
  if (std::ssize(samples) > options.candidates) samples.resize(options.candidates);
  std::vector<BasePlacement> poses;
  for (const Sample& sample : samples) poses.push_back(sample.pose);
  return poses;
}

/// Returns the results of `evaluate` for all poses, by increasing cost. Uses several threads.
std::vector<Candidate> evaluate_all(
    const std::vector<BasePlacement>& poses, const PlaceOptions& options,
    const ProgressCallback& report, const char* stage,
    const std::function<Candidate(const BasePlacement&, std::uint64_t)>& evaluate) {
  const int count = static_cast<int>(poses.size());
  std::vector<Candidate> candidates;
  int evaluated = 0;
  parallel::ordered_for_each<Candidate>(
      count, options.jobs, [&](std::uint64_t k) { return evaluate(poses[k], k); },
      [&](const Candidate& candidate) {
        candidates.push_back(candidate);
        report(stage, ++evaluated, count);
      });
  std::ranges::stable_sort(candidates, {}, &Candidate::cost);
  return candidates;
}

std::vector<BasePlacement> poses_of(const std::vector<Candidate>& candidates) {
  std::vector<BasePlacement> poses;
  for (const Candidate& candidate : candidates) poses.push_back(candidate.pose);
  return poses;
}

bool is_similar(const BasePlacement& a, const BasePlacement& b) {
  return (a.shoulder_offset - b.shoulder_offset).norm() < kSamePlace_m &&
         angle_between(a.world_from_base, b.world_from_base) < kSimilarAngle_rad;
}
std::vector<Candidate> remove_similar(const std::vector<Candidate>& candidates, int max_count) {
  std::vector<Candidate> kept;
  for (const Candidate& candidate : candidates) {
    const bool has_similar = std::ranges::any_of(
        kept, [&](const Candidate& other) { return is_similar(other.pose, candidate.pose); });
    if (!has_similar && std::ssize(kept) < max_count) kept.push_back(candidate);
  }
  return kept;
}
std::vector<const TrialMovement*> select_trials(const std::vector<TrialMovement>& trials,
                                                std::size_t max_count) {
  std::vector<const TrialMovement*> selected;
  const std::size_t count = std::min(max_count, trials.size());
  for (std::size_t k = 0; k < count; ++k)
    selected.push_back(&trials[(2 * k + 1) * trials.size() / (2 * count)]);
  return selected;
}

std::vector<Candidate> screen_candidates(const planning::PlanningInputs& planner,
                                         const std::vector<BasePlacement>& poses,
                                         const std::vector<TrialMovement>& trials,
                                         const PlaceOptions& options,
                                         const ProgressCallback& report) {
  const std::vector<const TrialMovement*> one_trial = select_trials(trials, 1),
                                          more_trials = select_trials(trials, kScreeningTrialCount);
  std::vector<Candidate> all = evaluate_all(
      poses, options, report, "candidates", [&](const BasePlacement& pose, std::uint64_t k) {
        return evaluate_placement(planner, pose, one_trial, kScreeningEffort,
                                  math::seed_from(options.seed, "one", k));
      });
  const auto count = std::ssize(all);
  all.resize(std::max(std::min<std::ptrdiff_t>(count, options.refine), count / kScreeningDivisor));
  return evaluate_all(
      poses_of(all), options, report, "better", [&](const BasePlacement& pose, std::uint64_t k) {
        return evaluate_placement(planner, pose, more_trials, kSecondScreeningEffort,
                                  math::seed_from(options.seed, "few", k));
      });
}

}  // namespace

std::vector<PlacementResult> find_placements(const planning::PlanningInputs& planner,
                                             const std::vector<TrialMovement>& trials,
                                             const PlaceOptions& options,
                                             const ProgressCallback& report) {
  const BasePlacement configured = base_placement_of(planner.config.placement);
  const ReachabilityGrid grid(planner.robot, options.seed);
  const std::vector<BasePlacement> poses =
      sample_placements(grid, planner.robot.side, trials, configured, options);
  const auto refine_all = [&](const std::vector<Candidate>& starts, const CompassSteps& steps,
                              const char* stage) {
    return evaluate_all(poses_of(starts), options, report, stage,
                        [&](const BasePlacement& pose, std::uint64_t k) {
                          return refine(planner, pose, steps, configured, trials, grid.shoulder(),
                                        options, math::seed_from(options.seed, stage, k));
                        });
  };
  const std::vector<Candidate> roughly = refine_all(
      remove_similar(screen_candidates(planner, poses, trials, options, report), options.refine),
      kRoughSteps, "refined roughly");
  const std::vector<Candidate> finely =
      refine_all(remove_similar(roughly, std::max(options.plan, options.refine / 2)), kFineSteps,
                 "refined finely");
  const std::vector<Candidate> best = remove_similar(finely, options.plan);
  const int count = static_cast<int>(best.size());
  int planned = 0;
  std::vector<PlacementResult> results;
  for (const Candidate& c : best) {
    results.push_back(plan_with_placement(planner, trials, placement_of(c.pose), options.jobs));
    results.back().search_measures = c.measures;
    report("planned", ++planned, count);
  }
  std::ranges::stable_sort(results, {}, plan_cost);
  return results;
}

}  // namespace morphe::place
