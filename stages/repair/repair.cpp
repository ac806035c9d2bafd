#include "stages/repair/repair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <utility>

#include "stages/repair/plan_interval.hpp"

namespace morphe::repair {
namespace {

struct Judged {
  JointPath path;
  std::vector<Finding> findings;
};

bool collides(const std::vector<Finding>& findings) {
  return std::ranges::any_of(findings, is_collision, &Finding::cause);
}

bool less(const std::vector<Finding>& a, const std::vector<Finding>& b) {
  const auto rank = [](const std::vector<Finding>& findings) {
    double depth = 0;
    for (const Finding& finding : findings) depth += finding.depth;
    return std::tuple(std::ranges::count_if(findings, is_collision, &Finding::cause),
                      findings.size(), depth);
  };
  return rank(a) < rank(b);
}

/// The same things wrong at the same times, and about as much.
bool alike(const std::vector<Finding>& a, const std::vector<Finding>& b) {
  constexpr double kAsMuch = 0.2;
  return std::ranges::equal(a, b, [](const Finding& x, const Finding& y) {
    return x.cause == y.cause && x.first == y.first && x.second == y.second &&
           x.begin_s <= y.end_s && y.begin_s <= x.end_s &&
           std::abs(x.depth - y.depth) <= kAsMuch * std::max(x.depth, y.depth);
  });
}

std::string sentence(const Finding& finding) {
  const std::string pair =
      finding.second.empty() ? finding.first : finding.first + " – " + finding.second;
  return fmt::format("{}: {} from {:.3f} s to {:.3f} s, {:.4f} {} too much", name_of(finding.cause),
                     pair, finding.begin_s, finding.end_s, finding.depth,
                     finding.cause == Cause::limit || finding.cause == Cause::jump ? "rad" : "m");
}

/// Intervals around all collisions; those that overlap become one.
std::vector<Interval> intervals_of(const collision::CollisionWorld& world, const Judged& judged,
                                   int attempt, const RepairOptions& options) {
  std::vector<std::pair<double, double>> spans;  // [s]
  for (const Finding& finding : judged.findings)
    if (is_collision(finding.cause)) spans.emplace_back(finding.begin_s, finding.end_s);
  std::sort(spans.begin(), spans.end());

  const auto around = [&](const std::pair<double, double>& span) {
    return interval_around(world, judged.path, span.first, span.second,
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
bool plan_around(const collision::CollisionWorld& world, const JointRows& reach,
                 const RepairOptions& options, int attempt, std::uint64_t seed, Judged& judged) {
  bool planned = false;
  std::uint64_t number = 0;
  for (const Interval& interval : intervals_of(world, judged, attempt, options)) {
    const std::uint64_t own = seed + 1000 * static_cast<std::uint64_t>(attempt) + 100 * number++;
    planned |= plan_interval(interval, reach, options, attempt, own, judged.path);
  }
  return planned;
}

/// Takes what a step gives if it leaves less to repair.
void take_if_less(const decltype(RepairSteps::resolve)& step, const RepairSteps& steps,
                  Judged& judged) {
  if (!step || judged.findings.empty()) return;
  Judged candidate{step(judged.path, judged.findings), {}};
  candidate.findings = steps.recheck(candidate.path);
  if (less(candidate.findings, judged.findings)) judged = std::move(candidate);
}

void resolve_and_insist(const RepairSteps& steps, Judged& judged) {
  take_if_less(steps.resolve, steps, judged);
  if (worth_insisting(judged.findings)) take_if_less(steps.insist, steps, judged);
}

Reason end_in_collision(const collision::CollisionWorld& world, const JointPath& path,
                        std::string& detail) {
  const Eigen::Index last = path.position.rows() - 1;
  collision::CollisionScratch scratch;
  for (const Eigen::Index row : {Eigen::Index{0}, last}) {
    const JointVector q = path.position.row(row);
    const double time_s = path.demonstration_time[static_cast<std::size_t>(row)];
    const collision::PairSeparation pair = collision::least_slack(world, q, time_s, scratch);
    if (pair.slack() >= 0) continue;
    detail = fmt::format("{} – {} at the {} ({:.3f} s): {:.4f} m too close",
                         collision::first_name(world, pair), collision::second_name(world, pair),
                         row == 0 ? "start" : "goal", time_s, -pair.slack());
    return row == 0 ? Reason::start_in_collision : Reason::goal_in_collision;
  }
  return Reason::none;
}

/// Plans around the collisions that are left, more widely in each attempt. A path that collides at
/// one of its ends is left as it is, with the reason.
void detour(const collision::CollisionWorld& around, const JointRows& reach,
            const RepairSteps& steps, const RepairOptions& options, std::uint64_t seed,
            Judged& best, RepairResult& result) {
  if (!collides(best.findings)) return;
  collision::CollisionWorld world = around;  // what the hand carries moves as this path takes it
  collision::carry_target(best.path.demonstration_time, best.path.position, world);
  result.reason = end_in_collision(world, best.path, result.detail);
  if (result.reason != Reason::none) return;
  const Judged base = best;
  for (int attempt = 0; attempt < options.attempts && !best.findings.empty(); ++attempt) {
    // A detour that is free but worse in other ways is planned again from where it began.
    Judged candidate = collides(best.findings) ? best : base;
    if (!plan_around(world, reach, options, attempt, seed, candidate)) continue;
    candidate.findings = steps.recheck(candidate.path);
    // A detour costs tracking; the mapping may win it back from where the detour leads.
    const std::vector<Origin> origin = candidate.path.origin;
    resolve_and_insist(steps, candidate);
    for (std::size_t k = 0; k < origin.size(); ++k)
      if (origin[k] == Origin::planned) candidate.path.origin[k] = Origin::planned;
    if (less(candidate.findings, best.findings)) best = std::move(candidate);
  }
}

/// The reason and detail of what is left: collisions first.
void conclude(const RepairOptions& options, RepairResult& result) {
  const auto worst_of = [&](const auto& counts) {
    const Finding* worst = nullptr;
    for (const Finding& finding : result.remaining) {
      if (counts(finding.cause) && (!worst || finding.depth > worst->depth)) worst = &finding;
    }
    return worst;
  };
  if (const Finding* worst = worst_of(is_collision)) {
    result.reason = Reason::no_path;
    result.detail = fmt::format("{}; no free path in {} attempts of {} iterations",
                                sentence(*worst), options.attempts, options.iterations);
    return;
  }
  constexpr std::array<std::pair<Cause, Reason>, 3> kOthers{{{Cause::limit, Reason::limit},
                                                             {Cause::jump, Reason::jump},
                                                             {Cause::tracking, Reason::tracking}}};
  for (const auto& [cause, reason] : kOthers) {
    const Finding* worst = worst_of([&](Cause one) { return one == cause; });
    if (!worst) continue;
    result.reason = reason;
    result.detail = sentence(*worst);
    return;
  }
}

RepairResult stopped(const DeadEnd& end, Judged best) {
  RepairResult result;
  result.path = std::move(best.path);
  result.remaining = std::move(best.findings);
  result.reason = end.reason;
  result.detail = fmt::format("the best of {} postures for {:.3f} s has {}", end.tried, end.time_s,
                              sentence(end.nearest));
  return result;
}

}  // namespace

bool worth_insisting(const std::vector<Finding>& findings) {
  constexpr double kMost = 0.01;  // [m], of jumps and limits [rad]
  return std::ranges::all_of(findings, [](const Finding& f) { return f.depth <= kMost; });
}

std::string why_invalid(const RepairOptions& options) {
  if (options.attempts < 0) return "attempts must not be negative";
  if (options.iterations < 1) return "iterations must be at least 1";
  if (options.widen_samples < 1) return "widen_samples must be at least 1";
  if (!(options.range > 0)) return "range must be positive";
  if (options.shortcut_attempts < 0) return "shortcut_attempts must not be negative";
  if (options.draw_attempts < 0) return "draw_attempts must not be negative";
  if (options.searches < 0) return "searches must not be negative";
  if (!(options.extra_clearance >= 0)) return "extra_clearance must not be negative";
  return "";
}

RepairResult repair_path(const collision::CollisionWorld& around, const JointRows& reach,
                         JointPath path, std::vector<Finding> findings, const RepairSteps& given,
                         const RepairOptions& options, std::uint64_t seed) {
  RepairSteps steps = given;
  if (options.method == Method::rrt_connect) {
    steps = {};
    steps.recheck = given.recheck;
  }
  RepairResult result;
  const bool clean = findings.empty() || path.position.rows() == 0;
  Judged best{std::move(path), std::move(findings)};
  if (!clean) {
    const Judged mapped = best;
    take_if_less(steps.resolve, steps, best);
    if (steps.dead_end && !best.findings.empty()) {
      if (const std::optional<DeadEnd> end = steps.dead_end(best.path, best.findings)) {
        return stopped(*end, std::move(best));
      }
    }
    take_if_less(steps.insist, steps, best);
    take_if_less(steps.candidates, steps, best);
    detour(around, reach, steps, options, seed, best, result);
    if (!best.findings.empty() && !collides(best.findings)) {
      // Free, but not where it should be: the way around may begin from the mapped path as well.
      Judged other = mapped;
      RepairResult of_other;
      detour(around, reach, steps, options, seed, other, of_other);
      if (less(other.findings, best.findings)) best = std::move(other);
    }
  }
  constexpr int kOftenEnough = 4;  // courses that end with the same findings: no other will do
  int ended_there = 0;
  bool nearer = true;
  while (!best.findings.empty() && steps.new_course && ended_there < kOftenEnough) {
    std::optional<JointPath> course = steps.new_course(nearer);
    if (!course) break;
    Judged other{std::move(*course), {}};
    other.findings = steps.recheck(other.path);
    resolve_and_insist(steps, other);
    RepairResult of_other;
    const bool detour_may_do = std::ranges::all_of(other.findings, is_collision, &Finding::cause);
    if (detour_may_do) detour(around, reach, steps, options, seed, other, of_other);
    nearer = less(other.findings, best.findings);
    const bool same = alike(other.findings, best.findings);
    if (same) ++ended_there;
    if (!nearer) continue;
    if (!same) ended_there = 0;
    best = std::move(other);
    result = of_other;
  }
  result.path = std::move(best.path);
  result.remaining = std::move(best.findings);
  if (result.reason == Reason::none) conclude(options, result);
  result.repaired = !clean && result.remaining.empty();
  return result;
}

}  // namespace morphe::repair
