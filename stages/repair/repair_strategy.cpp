#include "stages/repair/repair_strategy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace morphe::repair {
namespace {

/// Returns the sums of the depths of the collisions and of all other findings [m or rad].
std::pair<double, double> total_depth(const std::vector<Finding>& findings) {
  std::pair<double, double> sum{0, 0};
  for (const Finding& finding : findings) {
    (is_collision(finding.cause) ? sum.first : sum.second) += finding.excess;
  }
  return sum;
}

/// Returns the rank of a cause in reports: collisions, limits, jumps, tips.
int order_of(Cause cause) {
  if (is_collision(cause)) return 0;
  return cause == Cause::joint_limit ? 1 : cause == Cause::jump ? 2 : 3;
}

/// Returns the failure that corresponds to the worst remaining finding.
PlanningFailure refusal_of(const std::vector<Finding>& remaining) {
  constexpr std::array kReasons{Reason::no_path, Reason::joint_limit, Reason::jump,
                                Reason::tracking};
  const Finding* worst = worst_finding(remaining);
  if (!worst) return {};
  return {kReasons.at(order_of(worst->cause)), sentence(*worst)};
}

/// Returns the name of the body, fingertip or joint.
std::string subject_of(const Finding& finding) {
  const bool joint = finding.cause == Cause::joint_limit || finding.cause == Cause::jump;
  return (joint ? "joint " : "") + finding.subject;
}

/// Returns "4.0 mm too close to cup".
std::string excess_of(const Finding& finding) {
  if (finding.cause == Cause::joint_limit)
    return fmt::format("{:.4f} rad beyond its limit", finding.excess);
  if (finding.cause == Cause::jump)
    return fmt::format("{:.4f} rad beyond the largest allowed step", finding.excess);
  const double excess_mm = kMillimetresPerMetre * finding.excess;
  if (finding.cause == Cause::tracking)
    return fmt::format("{:.1f} mm beyond its tolerance", excess_mm);
  return fmt::format("{:.1f} mm too close to {}", excess_mm, finding.other_body);
}

/// Returns "1.200–1.300 s", or "at 1.200 s" for one frame.
std::string interval_of(const Finding& finding) {
  const std::string begin = fmt::format("{:.3f}", finding.begin_s),
                    end = fmt::format("{:.3f}", finding.end_s);
  return begin == end ? "at " + begin + " s" : begin + "–" + end + " s";
}

}  // namespace

bool is_better(const std::vector<Finding>& a, const std::vector<Finding>& b) {
  return total_depth(a) < total_depth(b);
}

const Finding* worst_finding(const std::vector<Finding>& findings) {
  const auto worst = std::ranges::min_element(findings, {}, [](const Finding& finding) {
    return std::pair(order_of(finding.cause), -finding.excess);
  });
  return worst == findings.end() ? nullptr : &*worst;
}

bool is_nearly_free(const std::vector<Finding>& findings) {
  constexpr double kMaxNearlyFreeDepth = 0.01;
  return std::ranges::all_of(findings,
                             [](const Finding& f) { return f.excess <= kMaxNearlyFreeDepth; });
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
  const std::vector<Finding>& left = made.candidate.findings;
  step.finding_count = static_cast<std::int32_t>(left.size());
  std::tie(step.collision_depth_sum, step.other_depth_sum) = total_depth(left);
  if (const Finding* worst = worst_finding(left)) step.worst_finding = sentence(*worst);
  step.accepted = kept;
  step.stop_reason = made.failure ? made.failure.detail : made.stop_reason;
  return step;
}

StrategyResult run_strategies(const std::vector<RepairStrategy>& ladder, CheckedPath start) {
  StrategyResult best{std::move(start)};
  std::vector<RepairStep> steps;
  for (const RepairStrategy& rung : ladder) {
    if (best.candidate.findings.empty() || best.give_up) break;
    StrategyResult made = rung.make(best.candidate);
    const bool kept = is_better(made.candidate.findings, best.candidate.findings);
    steps.push_back(make_repair_step(rung.name, best.candidate, made, kept));
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

RepairStrategy only_if_nearly_free(RepairStrategy rung) {
  return {rung.name, [make = std::move(rung.make)](const CheckedPath& best) {
            if (is_nearly_free(best.findings)) return make(best);
            return StrategyResult{best, {}, false, "skipped (an error exceeds 10 mm or 0.01 rad)"};
          }};
}

Outcome<RepairResult> repair_path(const std::vector<RepairStrategy>& ladder, CheckedPath start) {
  const bool clean = start.findings.empty() || start.path.position.rows() == 0;
  StrategyResult made =
      clean ? StrategyResult{std::move(start)} : run_strategies(ladder, std::move(start));
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

std::string excess_text(const Finding& finding) {
  return subject_of(finding) + " " + excess_of(finding);
}

std::string sentence(const Finding& finding) {
  return fmt::format("{} is {}, {}", subject_of(finding), excess_of(finding), interval_of(finding));
}

}  // namespace morphe::repair
