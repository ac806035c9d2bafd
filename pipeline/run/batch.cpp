#include "pipeline/run/batch.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "pipeline/motion/counted.hpp"
#include "pipeline/parallel/ordered_map.hpp"

namespace morphe::run {
namespace {

/// Tip goals of the mapped frames, and how many of them the robot cannot reach.
void count_goals(const Plan& plan, BatchSummary& summary) {
  const JointRows& errors = plan.mapped.position_error;
  for (Eigen::Index f = 0; f < errors.rows(); ++f) {
    for (Eigen::Index tip = 0; tip < errors.cols(); ++tip) {
      if (std::isnan(errors(f, tip))) continue;
      ++summary.goals;
      if (!plan.goals.reachable(static_cast<std::size_t>(f), static_cast<std::size_t>(tip)))
        ++summary.out_of_reach;
    }
  }
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
    count_goals(plan, summary);
  }
  summary.stage_seconds = outcome.stage_seconds;
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
  for (const auto& [stage, seconds] : more.stage_seconds) sum.stage_seconds[stage] += seconds;
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
  parallel::OrderedMap<Demonstration, DemonstrationOutcome> map;
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

std::string summary_text_for_people(const BatchSummary& summary) {
  std::string reasons;
  for (const auto& [reason, count] : summary.reasons)
    reasons += fmt::format("{}{} {}", reasons.empty() ? " (" : ", ", reason, count);
  if (!reasons.empty()) reasons += ")";
  const std::string approximate =
      summary.approximate > 0 ? fmt::format("{} approximate, ", summary.approximate) : "";
  std::string text = fmt::format("{}, {}: {} executable ({} repaired), {}{} infeasible{}",
                                 counted(summary.demonstrations, "demonstration"),
                                 counted(summary.movements, "movement"), summary.executable,
                                 summary.repaired, approximate, summary.infeasible, reasons);
  if (summary.failed > 0) text += fmt::format(", {} failed", summary.failed);
  if (summary.reused > 0) text += fmt::format("; {} finished before", summary.reused);
  return text;
}

std::string stage_seconds_text(const BatchSummary& summary) {
  std::string text;
  for (const auto& [stage, seconds] : summary.stage_seconds)
    text += fmt::format("{}{} {:.2f} s", text.empty() ? "steps, over all threads: " : ", ", stage,
                        seconds);
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
                                    {"stage_seconds", summary.stage_seconds},
                                    {"reused", summary.reused}};
  return json.dump(2);
}

}  // namespace morphe::run
