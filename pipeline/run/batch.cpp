#include "pipeline/run/batch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "core/parallel/ordered_parallel_map.hpp"

namespace morphe::run {
namespace {

void count_goals(const Plan& plan, BatchSummary& summary) {
  const JointRows& errors = plan.mapped.tip_error;
  for (Eigen::Index f = 0; f < errors.rows(); ++f) {
    for (Eigen::Index tip = 0; tip < errors.cols(); ++tip) {
      if (std::isnan(errors(f, tip))) continue;
      ++summary.goals;
      summary.out_of_reach += plan.goals.reachable(f, tip) ? 0 : 1;
    }
  }
}

double total_cpu_s(const BatchSummary& summary) {
  double sum_s = 0;
  for (const auto& [stage, cpu_s] : summary.stage_cpu_s) sum_s += cpu_s;
  return sum_s;
}

}  // namespace

BatchSummary summary_of(const DemonstrationOutcome& outcome) {
  BatchSummary summary;
  summary.demonstrations = 1;
  summary.failed = outcome.error.empty() ? 0 : 1;
  for (const Plan& plan : outcome.plans) {
    ++summary.movements;
    const Status status = plan.status();
    if (status == Status::executable) ++summary.executable;
    if (status == Status::executable && plan.repaired) ++summary.repaired;
    if (status == Status::approximate) ++summary.approximate;
    if (status == Status::partial) ++summary.partial;
    if (status == Status::infeasible) {
      ++summary.infeasible;
      ++summary.reasons[std::string(name_of(plan.reason))];
    }
    if (plan.mapped.position.rows() > 0) ++summary.mapped;
    summary.frames += plan.mapped.position.rows();
    count_goals(plan, summary);
    if (plan.branch.number)
      ++summary.branches[fmt::format("{}", fmt::join(plan.branch.words, ", "))];
  }
  summary.stage_cpu_s = outcome.stage_cpu_s;
  return summary;
}

void add(const BatchSummary& more, BatchSummary& sum) {
  sum.demonstrations += more.demonstrations;
  sum.movements += more.movements;
  sum.executable += more.executable;
  sum.approximate += more.approximate;
  sum.partial += more.partial;
  sum.infeasible += more.infeasible;
  sum.repaired += more.repaired;
  sum.failed += more.failed;
  for (const auto& [reason, count] : more.reasons) sum.reasons[reason] += count;
  for (const auto& [stage, seconds] : more.stage_cpu_s) sum.stage_cpu_s[stage] += seconds;
  sum.mapped += more.mapped;
  sum.frames += more.frames;
  sum.goals += more.goals;
  sum.out_of_reach += more.out_of_reach;
  for (const auto& [branch, plans] : more.branches) sum.branches[branch] += plans;
  sum.reused += more.reused;
}

DemonstrationOutcome attempt(const std::function<DemonstrationOutcome(const Demonstration&)>& plan,
                             const Demonstration& demonstration) {
  DemonstrationOutcome outcome;
  try {
    outcome = plan(demonstration);
  } catch (const std::bad_alloc&) {
    throw;
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
  const std::string partial =
      summary.partial > 0 ? fmt::format("{} partial, ", summary.partial) : "";
  std::string text =
      fmt::format("{}, {}: {} executable ({} repaired), {}{}{} infeasible{}",
                  count_with_noun(summary.demonstrations, "demonstration"),
                  count_with_noun(summary.movements, "movement"), summary.executable,
                  summary.repaired, approximate, partial, summary.infeasible, reasons);
  if (summary.failed > 0) text += fmt::format(", {} failed", summary.failed);
  if (summary.reused > 0) text += fmt::format("; {} reused from an earlier run", summary.reused);
  return text;
}

double frames_per_cpu_second(const BatchSummary& summary) {
  const double cpu_s = total_cpu_s(summary);
  return cpu_s > 0 ? static_cast<double>(summary.frames) / cpu_s : 0;
}

std::map<std::string, double> stage_ms_per_movement(const BatchSummary& summary) {
  std::map<std::string, double> ms;
  if (summary.mapped == 0) return ms;
  for (const auto& [stage, cpu_s] : summary.stage_cpu_s)
    ms[stage] = 1e3 * cpu_s / static_cast<double>(summary.mapped);
  return ms;
}

std::string speed_text(const BatchSummary& summary) {
  if (summary.mapped == 0) return "";
  using Stage = std::pair<std::string, double>;
  const std::map<std::string, double> by_name = stage_ms_per_movement(summary);
  std::vector<Stage> stages(by_name.begin(), by_name.end());
  std::ranges::stable_sort(stages, std::ranges::greater{}, &Stage::second);
  std::string text =
      fmt::format("{}; {:.0f} frames/s per core; {:.0f} ms per movement",
                  count_with_noun(summary.frames, "frame"), frames_per_cpu_second(summary),
                  1e3 * total_cpu_s(summary) / static_cast<double>(summary.mapped));
  const char* separator = ": ";
  for (const auto& [stage, ms] : stages)
    if (ms >= 0.5) text += fmt::format("{}{} {:.0f}", std::exchange(separator, ", "), stage, ms);
  return text;
}

std::string serialize_summary(const BatchSummary& s) {
  return nlohmann::json{{"demonstrations", s.demonstrations},
                        {"movements", s.movements},
                        {"executable", s.executable},
                        {"approximate", s.approximate},
                        {"partial", s.partial},
                        {"infeasible", s.infeasible},
                        {"repaired", s.repaired},
                        {"failed", s.failed},
                        {"reasons", s.reasons},
                        {"stage_cpu_s", s.stage_cpu_s},
                        {"mapped", s.mapped},
                        {"frames", s.frames},
                        {"goals", s.goals},
                        {"out_of_reach", s.out_of_reach},
                        {"branches", s.branches}}
      .dump();
}

BatchSummary deserialize_summary(const std::string& text) {
  BatchSummary s;
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    json.at("demonstrations").get_to(s.demonstrations);
    json.at("movements").get_to(s.movements);
    json.at("executable").get_to(s.executable);
    s.approximate = json.value("approximate", 0);  // absent in journals of earlier versions
    s.partial = json.value("partial", 0);          // absent there as well
    json.at("infeasible").get_to(s.infeasible);
    json.at("repaired").get_to(s.repaired);
    json.at("failed").get_to(s.failed);
    json.at("reasons").get_to(s.reasons);
    json.at("stage_cpu_s").get_to(s.stage_cpu_s);
    s.mapped = json.value("mapped", std::int64_t{0});  // absent there as well
    s.frames = json.value("frames", std::int64_t{0});
    json.at("goals").get_to(s.goals);
    json.at("out_of_reach").get_to(s.out_of_reach);
    s.branches = json.value("branches", s.branches);  // absent in journals of earlier versions
  } catch (const nlohmann::json::exception&) {
    throw InputError("is not a summary of a demonstration");
  }
  return s;
}

std::string summary_json(const BatchSummary& summary) {
  const nlohmann::ordered_json json{{"demonstrations", summary.demonstrations},
                                    {"movements", summary.movements},
                                    {"executable", summary.executable},
                                    {"approximate", summary.approximate},
                                    {"partial", summary.partial},
                                    {"infeasible", summary.infeasible},
                                    {"repaired", summary.repaired},
                                    {"failed", summary.failed},
                                    {"reasons", summary.reasons},
                                    {"stage_cpu_s", summary.stage_cpu_s},
                                    {"frames", summary.frames},
                                    {"frames_per_cpu_second", frames_per_cpu_second(summary)},
                                    {"stage_ms_per_movement", stage_ms_per_movement(summary)},
                                    {"branches", summary.branches},
                                    {"reused", summary.reused}};
  return json.dump(2);
}

}  // namespace morphe::run
