#include "pipeline/run/batch.hpp"

#include <nlohmann/json.hpp>

#include "pipeline/run/ordered_map.hpp"

namespace morphe {
namespace {

void count(const DemonstrationOutcome& outcome, BatchSummary& summary) {
  ++summary.demonstrations;
  if (!outcome.error.empty()) ++summary.failed;
  for (const Plan& plan : outcome.plans) {
    ++summary.movements;
    if (plan.executable()) {
      ++summary.executable;
    } else {
      ++summary.infeasible;
      ++summary.reasons[plan.reason];
    }
    if (plan.certificate.repaired) ++summary.repaired;
  }
  for (const auto& [stage, seconds] : outcome.stage_seconds) {
    summary.stage_seconds[stage] += seconds;
  }
}

}  // namespace

BatchSummary run_batch(const Batch& batch, int jobs) {
  BatchSummary summary;
  OrderedMap<Demonstration, DemonstrationOutcome> map;
  map.next = batch.next;
  map.work = [&](const Demonstration& demonstration) {
    auto outcome = std::make_unique<DemonstrationOutcome>();
    try {
      *outcome = batch.plan(demonstration);
    } catch (const std::exception& error) {
      outcome->error = error.what();
    }
    outcome->demonstration = demonstration.name;
    return outcome;
  };
  map.write = [&](const DemonstrationOutcome& outcome) {
    count(outcome, summary);
    batch.write(outcome);
  };
  run(map, jobs);
  return summary;
}

std::string summary_json(const BatchSummary& summary) {
  const nlohmann::ordered_json json{{"demonstrations", summary.demonstrations},
                                    {"movements", summary.movements},
                                    {"executable", summary.executable},
                                    {"infeasible", summary.infeasible},
                                    {"repaired", summary.repaired},
                                    {"failed", summary.failed},
                                    {"reasons", summary.reasons},
                                    {"stage_seconds", summary.stage_seconds}};
  return json.dump(2);
}

}  // namespace morphe
