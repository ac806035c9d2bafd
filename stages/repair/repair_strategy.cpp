#include "stages/repair/repair_strategy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/motion/finding_text.hpp"
#include "stages/repair/constants.hpp"

namespace morphe::repair {
namespace {

/// Returns the sums of the depths of the collisions and of all other findings [m].
std::pair<double, double> total_depth(const std::vector<Finding>& findings) {
  std::pair<double, double> sum{0, 0};
  for (const Finding& finding : findings)
    (is_collision(finding.cause) ? sum.first : sum.second) += finding.excess_m();
  return sum;
}

int report_rank(Cause cause) {
  if (is_collision(cause)) return 0;
  return cause == Cause::joint_limit ? 1 : cause == Cause::jump ? 2 : 3;
}

PlanningFailure refusal_of(const std::vector<Finding>& remaining) {
  constexpr std::array kReasons{Reason::no_path, Reason::joint_limit, Reason::jump,
                                Reason::tracking};
  const Finding* worst = worst_finding(remaining);
  if (!worst) return {};
  return {kReasons.at(report_rank(worst->cause)), sentence(*worst)};
}

}  // namespace

bool is_better(const std::vector<Finding>& a, const std::vector<Finding>& b) {
  return total_depth(a) < total_depth(b);
}

const Finding* worst_finding(const std::vector<Finding>& findings) {
  const auto worst = std::ranges::min_element(findings, {}, [](const Finding& finding) {
    return std::pair(report_rank(finding.cause), -finding.excess_m());
  });
  return worst == findings.end() ? nullptr : &*worst;
}

bool is_nearly_free(const std::vector<Finding>& findings) {
  return std::ranges::all_of(findings, [](const auto& f) { return f.excess <= kNearlyFreeExcess; });
}

RepairStep make_repair_step(std::string name, const CheckedPath& from, const StrategyResult& made,
                            bool kept) {
  RepairStep step;
  step.name = std::move(name);
  const JointRows &before = from.path.position, &after = made.candidate.path.position;
  for (Eigen::Index row = 0; row < after.rows() && after.rows() == before.rows(); ++row) {
    const double change = (after.row(row) - before.row(row)).cwiseAbs().maxCoeff();
    if (!(change > 0)) continue;
    const double time_s = from.path.demonstration_time[row];
    if (std::isnan(step.begin_s)) step.begin_s = time_s;
    step.end_s = time_s;
    step.max_joint_change = std::max(step.max_joint_change, change);
  }
  const std::vector<Finding>& remaining = made.candidate.findings;
  step.finding_count = static_cast<std::int32_t>(remaining.size());
  std::tie(step.collision_depth_sum, step.other_depth_sum) = total_depth(remaining);
  if (const Finding* worst = worst_finding(remaining)) step.worst_finding = sentence(*worst);
  step.accepted = kept;
  step.stop_reason = made.failure ? made.failure.detail : made.stop_reason;
  return step;
}

StrategyResult run_strategies(const std::vector<RepairStrategy>& strategies, CheckedPath start) {
  StrategyResult best{std::move(start)};
  std::vector<RepairStep> steps;
  for (const RepairStrategy& strategy : strategies) {
    if (best.candidate.findings.empty() || best.give_up) break;
    StrategyResult made = strategy.make(best.candidate);
    const bool kept = is_better(made.candidate.findings, best.candidate.findings);
    steps.push_back(make_repair_step(strategy.name, best.candidate, made, kept));
    for (RepairStep& attempt : made.attempts) {
      attempt.level = 1;
      steps.push_back(std::move(attempt));
    }
    if (kept) {
      best = std::move(made);
    } else if (made.failure) {
      made.candidate = std::move(best.candidate);
      best = std::move(made);
    }
  }
  best.attempts = std::move(steps);
  best.stop_reason.clear();
  return best;
}

RepairStrategy only_if_nearly_free(RepairStrategy strategy) {
  return {strategy.name, [make = std::move(strategy.make)](const CheckedPath& best) {
            if (is_nearly_free(best.findings)) return make(best);
            return StrategyResult{best, {}, false, "skipped (an error exceeds 10 mm or 0.01 rad)"};
          }};
}

Outcome<RepairResult> repair_path(const std::vector<RepairStrategy>& strategies, CheckedPath path) {
  const bool clean = path.findings.empty() || path.path.position.rows() == 0;
  StrategyResult made =
      clean ? StrategyResult{std::move(path)} : run_strategies(strategies, std::move(path));
  const std::vector<Finding>& remaining = made.candidate.findings;
  if (!made.failure) made.failure = refusal_of(remaining);
  const bool repaired = !clean && remaining.empty();
  return {{std::move(made.candidate.path), repaired, std::move(made.candidate.findings),
           std::move(made.attempts)},
          std::move(made.failure)};
}

std::string no_path_message(const RepairOptions& options) {
  return fmt::format("no collision-free path in {} attempts of {} iterations", options.attempts,
                     options.max_iterations);
}

}  // namespace morphe::repair
