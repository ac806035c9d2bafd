#include "stages/repair/detour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/math/seed.hpp"
#include "stages/repair/plan_interval.hpp"

namespace morphe::repair {
namespace {

constexpr const char* kNoWay = "no way was found, or no free sample to begin or end one at";

bool collides(const std::vector<Finding>& findings) {
  return std::ranges::any_of(findings, is_collision, &Finding::cause);
}

/// Intervals around all collisions; those that overlap become one.
std::vector<Interval> intervals_of(const collision::CollisionWorld& world, const Checked& checked,
                                   int attempt, const RepairOptions& options) {
  std::vector<std::pair<double, double>> spans;  // [s]
  for (const Finding& finding : checked.findings)
    if (is_collision(finding.cause)) spans.emplace_back(finding.begin_s, finding.end_s);
  std::sort(spans.begin(), spans.end());

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
      if (!interval) break;  // what was found before stays as it is
      covered.pop_back();
      intervals.pop_back();
    }
    if (!interval) continue;
    covered.push_back(span);
    intervals.push_back(std::move(*interval));
  }
  return intervals;
}

/// Plans around all collisions; false if nothing could be planned.
bool plan_around(const Surroundings& around, const collision::CollisionWorld& world, int attempt,
                 Checked& checked) {
  bool planned = false;
  const std::uint64_t seed =
      math::seed_from(around.seed, "attempt", static_cast<std::size_t>(attempt));
  std::size_t number = 0;
  for (const Interval& interval : intervals_of(world, checked, attempt, around.options)) {
    const std::uint64_t own = math::seed_from(seed, "interval", number++);
    planned |= plan_interval(interval, around.options, attempt, own, checked.path);
  }
  return planned;
}

Refusal end_in_collision(const collision::CollisionWorld& world, const JointPath& path) {
  const Eigen::Index last = path.position.rows() - 1;
  collision::CollisionScratch scratch;
  for (const Eigen::Index row : {Eigen::Index{0}, last}) {
    const JointVector q = path.position.row(row);
    const double time_s = path.demonstration_time[static_cast<std::size_t>(row)];
    const collision::PairSeparation pair = collision::least_slack(world, q, time_s, scratch);
    if (pair.slack() >= 0) continue;
    return {row == 0 ? Reason::start_in_collision : Reason::goal_in_collision,
            fmt::format("{} – {} at the {} ({:.3f} s): {:.4f} m too close",
                        collision::first_name(world, pair), collision::second_name(world, pair),
                        row == 0 ? "start" : "goal", time_s, -pair.slack())};
  }
  return {};
}

}  // namespace

Made detour(const Surroundings& around, const Checked& from) {
  Made made{from};
  if (!collides(from.findings)) {
    made.ended = "nothing is in the way";
    return made;
  }
  collision::CollisionWorld world =
      around.world;  // what the hand carries moves as this path takes it
  collision::carry_target(from.path.demonstration_time, from.path.position, world);
  made.refusal = end_in_collision(world, from.path);
  if (made.refusal) return made;
  Checked& best = made.checked;
  for (int attempt = 0; attempt < around.options.attempts && !best.findings.empty(); ++attempt) {
    // A detour that is free but worse in other ways is planned again from where it began.
    Checked candidate = collides(best.findings) ? best : from;
    const std::string name = fmt::format("attempt {}", attempt + 1);
    if (!plan_around(around, world, attempt, candidate)) {
      made.steps.push_back(step_of(name, candidate, {candidate, {}, false, kNoWay}, false));
      continue;
    }
    candidate.findings = around.check(candidate.path);
    // A detour costs tracking; the mapping may win it back from where the detour leads.
    const std::vector<Origin> origin = candidate.path.origin;
    candidate = climb(around.win_back, std::move(candidate)).checked;
    for (std::size_t k = 0; k < origin.size(); ++k)
      if (origin[k] == Origin::planned) candidate.path.origin[k] = Origin::planned;
    const bool nearer = less_bad(candidate.findings, best.findings);
    made.steps.push_back(step_of(name, best, {candidate}, nearer));
    if (nearer) best = std::move(candidate);
  }
  return made;
}

Rung detour_where_all_collide(const Surroundings& around) {
  return {"detour", [&around](const Checked& best) {
            if (std::ranges::all_of(best.findings, is_collision, &Finding::cause)) {
              return detour(around, best);
            }
            return Made{best, {}, false, "not tried: a way around cures collisions alone"};
          }};
}

Made detour_from(const Checked& mapped, const Surroundings& around, const Checked& best) {
  if (collides(best.findings)) return {best, {}, false, "not tried: the path collides as it is"};
  Made made = detour(around, mapped);
  made.refusal = {};
  return made;
}

}  // namespace morphe::repair
