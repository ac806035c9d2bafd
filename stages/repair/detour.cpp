#include "stages/repair/detour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/math/seed.hpp"
#include "stages/repair/plan_interval.hpp"

namespace morphe::repair {
namespace {

constexpr const char* kNoPathMessage =
    "no detour found, or no collision-free sample at which it could begin or end";

bool collides(const std::vector<Finding>& findings) {
  return std::ranges::any_of(findings, is_collision, &Finding::cause);
}

/// Returns the intervals around all collisions; those that overlap are merged.
std::vector<Interval> intervals_of(const collision::CollisionWorld& world,
                                   const CheckedPath& checked, int attempt,
                                   const RepairOptions& options) {
  std::vector<std::pair<double, double>> spans;  // [s]
  for (const Finding& finding : checked.findings)
    if (is_collision(finding.cause)) spans.emplace_back(finding.begin_s, finding.end_s);
  std::ranges::sort(spans);

  const auto around = [&](const std::pair<double, double>& span) {
    return interval_around(world, checked.path, span.first, span.second,
                           options.widen_samples * (attempt + 1), options.extra_clearance);
  };
  std::vector<std::pair<double, double>> covered;
  std::vector<Interval> intervals;
  for (std::pair<double, double> span : spans) {
    std::optional<Interval> interval = around(span);
    while (interval && !intervals.empty() && intervals.back().last > interval->first) {
      span = {covered.back().first, std::max(covered.back().second, span.second)};
      interval = around(span);
      if (!interval) break;  // earlier intervals remain unchanged
      covered.pop_back();
      intervals.pop_back();
    }
    if (!interval) continue;
    covered.push_back(span);
    intervals.push_back(std::move(*interval));
  }
  return intervals;
}
bool plan_around(const DetourContext& context, const collision::CollisionWorld& world, int attempt,
                 CheckedPath& checked) {
  bool planned = false;
  const std::uint64_t seed = math::seed_from(context.seed, "attempt", attempt);
  int number = 0;
  for (const Interval& interval : intervals_of(world, checked, attempt, context.options)) {
    const std::uint64_t interval_seed = math::seed_from(seed, "interval", number++);
    planned |= plan_interval(interval, context.options, attempt, interval_seed, checked.path);
  }
  return planned;
}

PlanningFailure end_in_collision(const collision::CollisionWorld& world, const JointPath& path) {
  collision::CollisionScratch scratch;
  for (const Eigen::Index row : {Eigen::Index{0}, path.position.rows() - 1}) {
    const JointVector q = path.position.row(row);
    const double time_s = path.demonstration_time[row];
    const collision::PairSeparation pair = collision::least_slack(world, q, time_s, scratch);
    if (pair.slack() >= 0) continue;
    return {
        row == 0 ? Reason::start_in_collision : Reason::goal_in_collision,
        fmt::format("{} is {:.1f} mm too close to {} at the {} ({:.3f} s)",
                    collision::first_body_name(world, pair), kMillimetresPerMetre * -pair.slack(),
                    collision::second_body_name(world, pair), row == 0 ? "start" : "goal", time_s)};
  }
  return {};
}

}  // namespace

StrategyResult detour(const DetourContext& context, const CheckedPath& start) {
  StrategyResult made{start};
  if (!collides(start.findings)) {
    made.stop_reason = "skipped (no collision left)";
    return made;
  }
  collision::CollisionWorld world = context.world;  // the attached object moves with this path
  collision::attach_target(start.path.demonstration_time, start.path.position, world);
  made.failure = end_in_collision(world, start.path);
  if (made.failure) return made;
  CheckedPath& best = made.candidate;
  for (int attempt = 0; attempt < context.options.attempts && !best.findings.empty(); ++attempt) {
    // A detour that is free but has other findings is planned again from its starting path.
    CheckedPath candidate = collides(best.findings) ? best : start;
    const std::string name = fmt::format("attempt {}", attempt + 1);
    if (!plan_around(context, world, attempt, candidate)) {
      made.attempts.push_back(
          make_repair_step(name, candidate, {candidate, {}, false, kNoPathMessage}, false));
      continue;
    }
    candidate.findings = context.check(candidate.path);
    // A detour reduces the tracking accuracy; the mapping may recover it from the detour's posture.
    const std::vector<SampleOrigin> origin = candidate.path.origin;
    candidate = run_strategies(context.tracking_recovery, std::move(candidate)).candidate;
    for (int k = 0; k < std::ssize(origin); ++k)
      if (origin[k] == SampleOrigin::planned) candidate.path.origin[k] = SampleOrigin::planned;
    const bool improved = is_better(candidate.findings, best.findings);
    made.attempts.push_back(make_repair_step(name, best, {candidate}, improved));
    if (improved) best = std::move(candidate);
  }
  return made;
}

RepairStrategy detour_if_only_collisions(const DetourContext& context) {
  return {"detour", [&context](const CheckedPath& best) {
            if (std::ranges::all_of(best.findings, is_collision, &Finding::cause))
              return detour(context, best);
            return StrategyResult{best, {}, false, "skipped (a detour removes only collisions)"};
          }};
}

StrategyResult detour_from_mapped(const CheckedPath& mapped, const DetourContext& context,
                                  const CheckedPath& best) {
  if (collides(best.findings)) return {best, {}, false, "skipped (the path still collides)"};
  StrategyResult made = detour(context, mapped);
  made.failure = {};  // a mapped path that ends in a collision says nothing against `best`
  return made;
}

}  // namespace morphe::repair
