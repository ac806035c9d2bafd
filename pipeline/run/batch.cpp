#include "pipeline/run/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/motion/count_with_noun.hpp"
#include "core/parallel/ordered_parallel_map.hpp"

namespace morphe::run {
namespace {

/// Counts the fingertip goals of the mapped frames, and those that the robot cannot reach.
void count_goals(const Plan& plan, BatchSummary& summary) {
  const JointRows& errors = plan.mapped.tip_error;
  for (Eigen::Index f = 0; f < errors.rows(); ++f) {
    for (Eigen::Index tip = 0; tip < errors.cols(); ++tip) {
      if (std::isnan(errors(f, tip))) continue;
      ++summary.goals;
      if (!plan.goals.reachable(f, tip)) ++summary.out_of_reach;
    }
  }
}

double total_cpu_s(const BatchSummary& summary) {
  double sum = 0;
  for (const auto& [stage, seconds] : summary.stage_cpu_s) sum += seconds;
  return sum;
}

}  // namespace

BatchSummary summary_of(const DemonstrationOutcome& outcome) {
  BatchSummary summary;
  summary.demonstrations = 1;
  summary.failed = outcome.error.empty() ? 0 : 1;
  for (const Plan& plan : outcome.plans) {
    ++summary.movements;
    switch (plan.status()) {
      case Status::executable:
        ++summary.executable;
        summary.repaired += plan.certificate.repaired ? 1 : 0;
        break;
      case Status::approximate:
        ++summary.approximate;
        break;
      case Status::infeasible:
        ++summary.infeasible;
        ++summary.reasons[std::string(name_of(plan.reason))];
        break;
    }
    if (plan.mapped.position.rows() > 0) ++summary.mapped;
    summary.frames += plan.mapped.position.rows();
    count_goals(plan, summary);
  }
  summary.stage_cpu_s = outcome.stage_cpu_s;
  return summary;
}

void add(const BatchSummary& more, BatchSummary& sum) {
  sum.demonstrations += more.demonstrations;
  sum.movements += more.movements;
  sum.executable += more.executable;
  sum.approximate += more.approximate;
  sum.infeasible += more.infeasible;
  sum.repaired += more.repaired;
  sum.failed += more.failed;
  for (const auto& [reason, count] : more.reasons) sum.reasons[reason] += count;
  for (const auto& [stage, seconds] : more.stage_cpu_s) sum.stage_cpu_s[stage] += seconds;
  sum.mapped += more.mapped;
  sum.frames += more.frames;
  sum.goals += more.goals;
  sum.out_of_reach += more.out_of_reach;
  sum.reused += more.reused;
}

DemonstrationOutcome attempt(const std::function<DemonstrationOutcome(const Demonstration&)>& plan,
                             const Demonstration& demonstration) {
  DemonstrationOutcome outcome;
  try {
    outcome = plan(demonstration);
  } catch (const std::exception& error) {
    outcome = {};
    outcome.error = error.what();
  }
  outcome.demonstration = demonstration.name;
  return outcome;
}

BatchSummary run_batch(const Batch& batch, int jobs) {
  BatchSummary summary;
  parallel::OrderedParallelMap<Demonstration, DemonstrationOutcome> map;
  map.next = batch.next;
  map.work = [&](const Demonstration& demonstration) {
    return std::make_unique<DemonstrationOutcome>(attempt(batch.plan, demonstration));
  };
  map.write = [&](const DemonstrationOutcome& outcome) {
    add(summary_of(outcome), summary);
    batch.write(outcome);
  };
  parallel::run(map, jobs);
  return summary;
}

std::string summary_sentence(const BatchSummary& summary) {
  std::string reasons;
  for (const auto& [reason, count] : summary.reasons)
    reasons += fmt::format("{}{} {}", reasons.empty() ? " (" : ", ", reason, count);
  if (!reasons.empty()) reasons += ")";
  const std::string approximate =
      summary.approximate > 0 ? fmt::format("{} approximate, ", summary.approximate) : "";
  std::string text = fmt::format("{}, {}: {} executable ({} repaired), {}{} infeasible{}",
                                 count_with_noun(summary.demonstrations, "demonstration"),
                                 count_with_noun(summary.movements, "movement"), summary.executable,
                                 summary.repaired, approximate, summary.infeasible, reasons);
  if (summary.failed > 0) text += fmt::format(", {} failed", summary.failed);
  if (summary.reused > 0) text += fmt::format("; {} reused from an earlier run", summary.reused);
  return text;
}

double frames_per_cpu_second(const BatchSummary& summary) {
  const double seconds = total_cpu_s(summary);
  return seconds > 0 ? static_cast<double>(summary.frames) / seconds : 0;
}

std::map<std::string, double> stage_ms_per_movement(const BatchSummary& summary) {
  std::map<std::string, double> ms;
  if (summary.mapped == 0) return ms;
  for (const auto& [stage, seconds] : summary.stage_cpu_s)
    ms[stage] = 1e3 * seconds / static_cast<double>(summary.mapped);
  return ms;
}

std::string speed_text(const BatchSummary& summary) {
  if (summary.mapped == 0) return "";
  const std::map<std::string, double> by_stage = stage_ms_per_movement(summary);
  std::vector<std::pair<std::string, double>> steps(by_stage.begin(), by_stage.end());
  std::ranges::stable_sort(steps, std::ranges::greater{}, &std::pair<std::string, double>::second);
  std::string text =
      fmt::format("{}; {:.0f} frames/s per core; {:.0f} ms per movement",
                  count_with_noun(summary.frames, "frame"), frames_per_cpu_second(summary),
                  1e3 * total_cpu_s(summary) / static_cast<double>(summary.mapped));
  const char* before = ": ";
  for (const auto& [stage, ms] : steps) {
    if (ms < 0.5) continue;
    text += fmt::format("{}{} {:.0f}", std::exchange(before, ", "), stage, ms);
  }
  return text;
}

std::string summary_json(const BatchSummary& summary) {
  const nlohmann::ordered_json json{{"demonstrations", summary.demonstrations},
                                    {"movements", summary.movements},
                                    {"executable", summary.executable},
                                    {"approximate", summary.approximate},
                                    {"infeasible", summary.infeasible},
                                    {"repaired", summary.repaired},
                                    {"failed", summary.failed},
                                    {"reasons", summary.reasons},
                                    {"stage_cpu_s", summary.stage_cpu_s},
                                    {"frames", summary.frames},
                                    {"frames_per_cpu_second", frames_per_cpu_second(summary)},
                                    {"stage_ms_per_movement", stage_ms_per_movement(summary)},
                                    {"reused", summary.reused}};
  return json.dump(2);
}

}  // namespace morphe::run
