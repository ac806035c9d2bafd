#include "pipeline/place/place.hpp"

#include <algorithm>
#include <numeric>

#include "core/math/seed.hpp"
#include "core/motion/input_error.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/place/reachability_grid.hpp"
#include "pipeline/place/refine.hpp"

namespace morphe::place {
namespace {

const SearchEffort kScreeningEffort{6, 2, 4}, kSecondScreeningEffort{8, 2, 6};
const CompassSteps kRoughSteps{0.12, 24 * kRadPerDegree, 2}, kFineSteps{0.03, 6 * kRadPerDegree, 2};
constexpr std::size_t kScreeningTrialCount = 3;

/// Placements that differ by less than both values are considered equal.
constexpr double kSamePlace_m = 0.06, kSimilarAngle_rad = 15 * kRadPerDegree;

std::vector<BasePlacement> sample_placements(const ReachabilityGrid& reach, Side side,
                                             const std::vector<TrialMovement>& trials,
                                             const BasePlacement& configured,
                                             const PlaceOptions& options) {
  struct Sample {
    BasePlacement base_placement;
    double outside = 0;
  };
  std::vector<Sample> samples;
  math::RandomStream random(options.seed, "places");
  for (int k = 0; k < options.samples; ++k) {
    Sample sample{random_base_placement(configured, options, random), 0};
    if (!is_base_allowed(trials, sample.base_placement, reach.shoulder(), side, options)) continue;
    for (const TrialMovement& trial : trials)
      sample.outside += reach.share_out_of_reach(trial, sample.base_placement);
    samples.push_back(std::move(sample));
  }
  if (samples.empty())
    throw InputError("place: no placement of the base satisfies the constraints");
  std::ranges::stable_sort(samples, {}, &Sample::outside);
  std::vector<BasePlacement> stands;
  for (const Sample& sample : samples) {
    if (stands.size() < static_cast<std::size_t>(options.candidates)) {
      stands.push_back(sample.base_placement);
    }
  }
  return stands;
}

/// Evaluates all candidates on several threads and returns them in order.
std::vector<Candidate> evaluate_all(std::size_t count, const PlaceOptions& options,
                                    const ProgressCallback& report, const char* what,
                                    const std::function<Candidate(std::size_t)>& work) {
  std::vector<Candidate> out;
  parallel::ordered_for_each<Candidate>(
      static_cast<int>(count), options.jobs, [&](std::uint64_t k) { return work(k); },
      [&](const Candidate& candidate) {
        out.push_back(candidate);
        report(what, static_cast<int>(out.size()), static_cast<int>(count));
      });
  return out;
}

void sort_by_cost(std::vector<Candidate>& candidates) {
  std::ranges::stable_sort(candidates, {}, &Candidate::cost);
}

bool is_similar(const BasePlacement& a, const BasePlacement& b) {
  return (a.shoulder_offset - b.shoulder_offset).norm() < kSamePlace_m &&
         angle_between(a.world_from_base, b.world_from_base) < kSimilarAngle_rad;
}

/// Returns the first `most` distinct candidates.
std::vector<Candidate> remove_similar(const std::vector<Candidate>& row, int most) {
  std::vector<Candidate> kept;
  for (const Candidate& candidate : row) {
    const bool known = std::ranges::any_of(
        kept, [&](const Candidate& other) { return is_similar(other.stand, candidate.stand); });
    if (!known && kept.size() < static_cast<std::size_t>(most)) kept.push_back(candidate);
  }
  return kept;
}

/// Selects at most `most` of the trials, evenly distributed.
std::vector<const TrialMovement*> select_trials(const std::vector<TrialMovement>& trials,
                                                std::size_t most) {
  std::vector<const TrialMovement*> few;
  const std::size_t count = std::min(most, trials.size());
  for (std::size_t k = 0; k < count; ++k) {
    few.push_back(&trials[(2 * k + 1) * trials.size() / (2 * count)]);
  }
  return few;
}

std::vector<Candidate> screen_candidates(const planning::PlanningInputs& planner,
                                         const std::vector<BasePlacement>& stands,
                                         const std::vector<TrialMovement>& trials,
                                         const PlaceOptions& options,
                                         const ProgressCallback& report) {
  const std::vector<const TrialMovement*> one = select_trials(trials, 1),
                                          few = select_trials(trials, kScreeningTrialCount);
  std::vector<Candidate> all =
      evaluate_all(stands.size(), options, report, "candidates", [&](std::size_t k) {
        return evaluate_placement(planner, stands[k], one, kScreeningEffort,
                                  math::seed_from(options.seed, "one", k));
      });
  sort_by_cost(all);
  all.resize(
      std::max(std::min(all.size(), static_cast<std::size_t>(options.refine)), all.size() / 3));
  std::vector<Candidate> better =
      evaluate_all(all.size(), options, report, "better", [&](std::size_t k) {
        return evaluate_placement(planner, all[k].stand, few, kSecondScreeningEffort,
                                  math::seed_from(options.seed, "few", k));
      });
  sort_by_cost(better);
  return better;
}

}  // namespace

std::vector<PlacementResult> find_placements(const planning::PlanningInputs& planner,
                                             const std::vector<TrialMovement>& trials,
                                             const PlaceOptions& options,
                                             const ProgressCallback& report) {
  const BasePlacement configured = base_placement_of(planner.config.placement);
  const ReachabilityGrid reach(planner.robot, options.seed);
  const std::vector<BasePlacement> stands =
      sample_placements(reach, planner.robot.side, trials, configured, options);
  const auto refined = [&](const std::vector<Candidate>& starts, const CompassSteps& steps,
                           const char* what) {
    std::vector<Candidate> better =
        evaluate_all(starts.size(), options, report, what, [&](std::size_t k) {
          return refine(planner, starts[k].stand, steps, configured, trials, reach.shoulder(),
                        options, math::seed_from(options.seed, what, k));
        });
    sort_by_cost(better);
    return better;
  };
  const std::vector<Candidate> roughly = refined(
      remove_similar(screen_candidates(planner, stands, trials, options, report), options.refine),
      kRoughSteps, "refined roughly");
  const std::vector<Candidate> finely =
      refined(remove_similar(roughly, std::max(options.plan, options.refine / 2)), kFineSteps,
              "refined finely");
  std::vector<PlacementResult> found;
  const std::vector<Candidate> best = remove_similar(finely, options.plan);
  for (const Candidate& candidate : best) {
    found.push_back(
        plan_with_placement(planner, trials, placement_of(candidate.stand), options.jobs));
    found.back().search_measures = candidate.measures;
    report("planned", static_cast<int>(found.size()), static_cast<int>(best.size()));
  }
  std::ranges::stable_sort(
      found, {}, [](const PlacementResult& f) { return cost_of(f.plan_summary.measures); });
  return found;
}

}  // namespace morphe::place
