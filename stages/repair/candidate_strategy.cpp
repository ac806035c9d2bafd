#include "stages/repair/candidate_strategy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "stages/repair/constants.hpp"

namespace morphe::repair {
namespace {

bool fails_at_same_place(const std::vector<Finding>& findings, const Finding& worst) {
  return std::ranges::any_of(findings, [&](const Finding& finding) {
    return finding.cause == worst.cause && finding.subject == worst.subject &&
           finding.other_body == worst.other_body && finding.begin_s <= worst.end_s &&
           worst.begin_s <= finding.end_s && finding.excess >= kSameExcessRatio * worst.excess;
  });
}

bool failed_too_often(const CandidateFindings& tried, const std::vector<Finding>& best) {
  return std::ranges::count_if(tried, [&](const std::vector<Finding>& findings) {
           return fails_at_same_place(findings, *worst_finding(best));
         }) >= kMaxRepeatedFailures;
}

}  // namespace

RepairStrategy candidate_strategy(std::string name, std::vector<RepairStrategy> strategies,
                                  PathCheck check, NextCandidate candidates,
                                  CandidateFindings& tried) {
  const auto make = [strategies = std::move(strategies), check = std::move(check),
                     candidates = std::move(candidates), &tried](const CheckedPath& start) {
    NextCandidate next = candidates;
    bool improved = true;
    StrategyResult best{start};
    std::vector<RepairStep> steps;
    while (!best.candidate.findings.empty()) {
      if (failed_too_often(tried, best.candidate.findings)) {
        best.stop_reason = "stopped: four paths failed at the same place";
        break;
      }
      std::optional<JointPath> path = next(improved);
      if (!path) {
        best.stop_reason = steps.empty() ? "skipped (no other path)" : "no further path";
        break;
      }
      CheckedPath checked{std::move(*path), {}};
      checked.findings = check(checked.path);
      StrategyResult made = run_strategies(strategies, std::move(checked));
      tried.push_back(made.candidate.findings);
      improved = is_better(made.candidate.findings, best.candidate.findings);
      steps.push_back(make_repair_step(fmt::format("path {}", steps.size() + 1), best.candidate,
                                       made, improved));
      if (improved) best = std::move(made);
    }
    best.attempts = std::move(steps);
    return best;
  };
  return {std::move(name), make};
}

}  // namespace morphe::repair
