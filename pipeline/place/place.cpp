#include "pipeline/place/place.hpp"

#include <algorithm>
#include <numeric>

#include "core/math/seed.hpp"
#include "core/motion/input_error.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/place/reach.hpp"
#include "pipeline/place/refine.hpp"

namespace morphe::place {
namespace {

const Effort kFirst{6, 2, 4}, kSecond{8, 2, 6};
const Steps kRough{0.12, 24 * kDegree, 2}, kFine{0.03, 6 * kDegree, 2};
constexpr std::size_t kFewTrials = 3;

/// Places that differ by less than both are one.
constexpr double kSamePlace_m = 0.06, kSameTurn = 15 * kDegree;

std::vector<Stand> within_reach(const Reach& reach, Side side, const std::vector<Trial>& trials,
                                const Stand& configured, const PlaceOptions& options) {
  struct Sample {
    Stand stand;
    double outside = 0;
  };
  std::vector<Sample> samples;
  math::RandomStream random(options.seed, "places");
  for (int k = 0; k < options.samples; ++k) {
    Sample sample{random_stand(configured, options, random), 0};
    if (!base_is_free(trials, sample.stand, reach.shoulder(), side, options)) continue;
    for (const Trial& trial : trials) sample.outside += reach.share_outside(trial, sample.stand);
    samples.push_back(std::move(sample));
  }
  if (samples.empty()) throw InputError("place: the constraints leave no place for the base");
  std::ranges::stable_sort(samples, {}, &Sample::outside);
  std::vector<Stand> stands;
  for (const Sample& sample : samples) {
    if (stands.size() < static_cast<std::size_t>(options.candidates)) {
      stands.push_back(sample.stand);
    }
  }
  return stands;
}

/// All of them, in their order, on several threads.
std::vector<Candidate> map_all(std::size_t count, const PlaceOptions& options, const Report& report,
                               const char* what,
                               const std::function<Candidate(std::size_t)>& work) {
  std::vector<Candidate> out;
  parallel::for_each<Candidate>(
      static_cast<int>(count), options.jobs,
      [&](std::uint64_t k) { return work(static_cast<std::size_t>(k)); },
      [&](const Candidate& candidate) {
        out.push_back(candidate);
        report(what, static_cast<int>(out.size()), static_cast<int>(count));
      });
  return out;
}

void by_cost(std::vector<Candidate>& candidates) {
  std::ranges::stable_sort(candidates, {}, &Candidate::cost);
}

bool alike(const Stand& a, const Stand& b) {
  return (a.shoulder_offset - b.shoulder_offset).norm() < kSamePlace_m &&
         angle_between(a.world_from_base, b.world_from_base) < kSameTurn;
}

/// The first `most` of a row that differ.
std::vector<Candidate> distinct(const std::vector<Candidate>& row, int most) {
  std::vector<Candidate> kept;
  for (const Candidate& candidate : row) {
    const bool known = std::ranges::any_of(
        kept, [&](const Candidate& other) { return alike(other.stand, candidate.stand); });
    if (!known && kept.size() < static_cast<std::size_t>(most)) kept.push_back(candidate);
  }
  return kept;
}

/// Evenly at most so many of the trials.
std::vector<const Trial*> few_trials(const std::vector<Trial>& trials, std::size_t most) {
  std::vector<const Trial*> few;
  const std::size_t count = std::min(most, trials.size());
  for (std::size_t k = 0; k < count; ++k) {
    few.push_back(&trials[(2 * k + 1) * trials.size() / (2 * count)]);
  }
  return few;
}

std::vector<Candidate> screened(const planning::Planner& planner, const std::vector<Stand>& stands,
                                const std::vector<Trial>& trials, const PlaceOptions& options,
                                const Report& report) {
  const std::vector<const Trial*> one = few_trials(trials, 1), few = few_trials(trials, kFewTrials);
  std::vector<Candidate> all =
      map_all(stands.size(), options, report, "candidates", [&](std::size_t k) {
        return try_stand(planner, stands[k], one, kFirst, math::seed_from(options.seed, "one", k));
      });
  by_cost(all);
  all.resize(
      std::max(std::min(all.size(), static_cast<std::size_t>(options.refined)), all.size() / 3));
  std::vector<Candidate> better =
      map_all(all.size(), options, report, "better", [&](std::size_t k) {
        return try_stand(planner, all[k].stand, few, kSecond,
                         math::seed_from(options.seed, "few", k));
      });
  by_cost(better);
  return better;
}

}  // namespace

std::vector<Found> place(const planning::Planner& planner, const std::vector<Trial>& trials,
                         const PlaceOptions& options, const Report& report) {
  const Stand configured = stand_of(planner.config.placement);
  const Reach reach(planner.robot, options.seed);
  const std::vector<Stand> stands =
      within_reach(reach, planner.robot.side, trials, configured, options);
  const auto refined = [&](const std::vector<Candidate>& starts, const Steps& steps,
                           const char* what) {
    std::vector<Candidate> better =
        map_all(starts.size(), options, report, what, [&](std::size_t k) {
          return refine(planner, starts[k].stand, steps, configured, trials, reach.shoulder(),
                        options, math::seed_from(options.seed, what, k));
        });
    by_cost(better);
    return better;
  };
  const std::vector<Candidate> roughly =
      refined(distinct(screened(planner, stands, trials, options, report), options.refined), kRough,
              "refined roughly");
  const std::vector<Candidate> finely = refined(
      distinct(roughly, std::max(options.planned, options.refined / 2)), kFine, "refined finely");
  std::vector<Found> found;
  const std::vector<Candidate> best = distinct(finely, options.planned);
  for (const Candidate& candidate : best) {
    found.push_back(plan_at(planner, trials, placement_of(candidate.stand), options.jobs));
    found.back().tried = candidate.measures;
    report("planned", static_cast<int>(found.size()), static_cast<int>(best.size()));
  }
  std::ranges::stable_sort(found, {}, [](const Found& f) { return cost_of(f.planned.measures); });
  return found;
}

}  // namespace morphe::place
