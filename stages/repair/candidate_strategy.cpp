#include "stages/repair/candidate_strategy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace morphe::repair {
namespace {

/// Returns true if the findings contain one with the same cause at the same time, about as deep or
/// deeper.
bool fails_at_same_place(const std::vector<Finding>& findings, const Finding& place) {
  constexpr double kSameDepthRatio = 0.8;
  return std::ranges::any_of(findings, [&](const Finding& finding) {
    return finding.cause == place.cause && finding.subject == place.subject &&
           finding.other_body == place.other_body && finding.begin_s <= place.end_s &&
           place.begin_s <= finding.end_s && finding.excess >= kSameDepthRatio * place.excess;
  });
}

/// Returns true if so many candidates have failed at this place that no other is likely to succeed.
bool failed_too_often(const CandidateFindings& ends, const std::vector<Finding>& best) {
  constexpr int kMaxRepeatedFailures = 4;
  return std::ranges::count_if(ends, [&](const std::vector<Finding>& findings) {
           return fails_at_same_place(findings, *worst_finding(best));
         }) >= kMaxRepeatedFailures;
}

}  // namespace

RepairStrategy candidate_strategy(std::string name, std::vector<RepairStrategy> rungs,
                                  PathCheck check, NextCandidate courses, CandidateFindings& ends) {
  const auto make = [rungs = std::move(rungs), check = std::move(check),
                     courses = std::move(courses), &ends](const CheckedPath& from) {
    NextCandidate next = courses;
    bool improved = true;
    StrategyResult best{from};
    std::vector<RepairStep> steps;
    while (!best.candidate.findings.empty()) {
      if (failed_too_often(ends, best.candidate.findings)) {
        best.stop_reason = "stopped: four paths failed at the same place";
        break;
      }
      std::optional<JointPath> course = next(improved);
      if (!course) {
        best.stop_reason = steps.empty() ? "skipped (no other path)" : "no further path";
        break;
      }
      CheckedPath checked{std::move(*course), {}};
      checked.findings = check(checked.path);
      StrategyResult made = run_strategies(rungs, std::move(checked));
      ends.push_back(made.candidate.findings);
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
