#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/config/spelling_hint.hpp"
#include "core/files/sha256.hpp"
#include "core/motion/assumption_text.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/demonstration_file.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/commands/certificate_json.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/plans_file.hpp"
#include "pipeline/commands/posture_json.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/commands/verdict.hpp"
#include "pipeline/explain/collect_advice.hpp"
#include "pipeline/explain/posture_text.hpp"
#include "pipeline/explain/step_summary.hpp"
#include "pipeline/planning/run_config.hpp"
#include "pipeline/run/journal.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct ExplainArguments {
  std::string file, plan, dataset;
  bool try_advice = false, json = false, unverified = false;
};

/// A plans.h5 and the related files in its folder.
struct PlanSource {
  fs::path plans;
  store::PlanReader reader;
  robot::Robot robot;
  std::optional<planning::RunConfig> config;  ///< absent if the file lacks parts of it
  std::string why_no_config;
  std::unique_ptr<store::DemonstrationReader> recordings;  ///< set for --try

  explicit PlanSource(const fs::path& file) : plans(file), reader(file), robot(reader.robot()) {
    try {
      config = planning::stored_config(file);
    } catch (const InputError& error) {
      why_no_config = error.what();
    }
  }
};

void open_recordings(const ExplainArguments& arguments, PlanSource& source) {
  if (!arguments.try_advice) return;
  if (!source.config) throw InputError(fmt::format("explain --try: {}", source.why_no_config));
  fs::path dataset = arguments.dataset;
  if (dataset.empty()) dataset = source.plans.parent_path() / "demonstrations.h5";
  if (!fs::exists(dataset))
    throw InputError(
        fmt::format("explain --try: {} does not exist; give the run's recordings: --dataset F.h5",
                    dataset.string()));
  if (files::sha256_of_file(dataset) != source.reader.header().dataset_sha256)
    throw InputError(fmt::format("explain --try: {} is not the dataset from which {} was planned",
                                 dataset.string(), source.plans.string()));
  source.recordings = std::make_unique<store::DemonstrationReader>(dataset);
}

/// Returns the selected plans: the named one, those of a demonstration, or all infeasible and
/// partial ones.
std::vector<int> selected_plans(const ExplainArguments& arguments, const PlanSource& source) {
  std::vector<int> selected;
  const std::vector<std::string>& paths = source.reader.plan_paths();
  for (int k = 0; k < std::ssize(paths); ++k) {
    const bool named = paths[k] == arguments.plan || paths[k].starts_with(arguments.plan + "/");
    if (arguments.plan.empty() ? source.reader.read(k).reason != Reason::none : named)
      selected.push_back(k);
  }
  return selected;
}

/// Returns the planning time of the plan's demonstration by stage, "" if no journal has it.
std::string planning_time_text(const PlanSource& source, const Plan& plan) {
  const fs::path folder = source.plans.parent_path();
  if (!fs::exists(folder / run::Journal::kFile)) return "";
  const auto finished = run::Journal::read(folder)->find(plan.demonstration);
  if (!finished) return "";
  std::string text;
  for (const auto& [stage, seconds] : finished->summary.stage_cpu_s) {
    if (seconds < 0.001) continue;
    text += fmt::format("{}{} {:.0f} ms", text.empty() ? "" : ", ", stage, 1e3 * seconds);
  }
  return text.empty() ? "" : fmt::format("  {:<13} {} (for the whole recording)\n", "took", text);
}

std::string outcome_of(const Plan& plan) {
  if (!plan.has_trajectory())
    return fmt::format("infeasible, {}: {}", name_of(plan.reason), plan.detail);
  if (plan.delivered) return fmt::format("partial, {}: {}", name_of(plan.reason), plan.detail);
  return fmt::format("{}: tip error at most {:.1f} mm", name_of(plan.status()),
                     1e3 * plan.certificate.tip_error_max);
}

Json json_of(const PlanSource& source, const Plan& plan, const std::string& path,
             const std::vector<explain::TriedAdvice>& advice) {
  Json json{{"plan", path},
            {"status", name_of(plan.status())},
            {"reason", name_of(plan.reason)},
            {"detail", plan.detail},
            {"step_summary", explain::step_summary(source.reader.robot(), plan)},
            {"posture", posture_json(explain::posture_summary(source.robot, plan))},
            {"clearances", clearances_json(plan.certificate.clearance_by_kind)},
            {"assumptions", assumptions_json(all_assumptions(source.reader.header(), plan))},
            {"advice", Json::array()}};
  for (const explain::TriedAdvice& tried : advice) {
    Json entry{{"kind", name_of(tried.advice.kind)},
               {"settings", tried.advice.settings},
               {"sentence", tried.advice.sentence}};
    if (tried.plan)
      entry["trial"] = {{"status", name_of(tried.plan->status())},
                        {"reason", name_of(tried.plan->reason)},
                        {"detail", tried.plan->detail}};
    json["advice"].push_back(entry);
  }
  return json;
}

std::string text_of(const PlanSource& source, const Plan& plan,
                    const std::vector<explain::TriedAdvice>& advice) {
  std::string text = explain::step_summary(source.reader.robot(), plan) +
                     explain::posture_text(plan, explain::posture_summary(source.robot, plan)) +
                     certified_line(plan) +
                     assumption_lines(all_assumptions(source.reader.header(), plan)) +
                     planning_time_text(source, plan);
  if (source.config) {
    const std::string words =
        map::standing_text(source.robot, source.config->loaded.options.placement);
    if (!words.empty()) text += fmt::format("  {:<13} the base {}\n", "placement", words);
  }
  const char* step = "try";
  for (const explain::TriedAdvice& tried : advice) {
    text += fmt::format("  {:<13} {}\n", step, explain::text_of(tried.advice));
    if (tried.plan) text += fmt::format("  {:<13}   tried: {}\n", "", outcome_of(*tried.plan));
    step = "";
  }
  return text;
}

int execute(const ExplainArguments& arguments) {
  expect_effect(arguments.try_advice || arguments.dataset.empty(), "--dataset", "without --try");
  Json all = Json::array();
  int shown = 0, tried = 0;
  std::vector<std::string> names;  // of plans and demonstrations, for a hint
  for (const fs::path& file : find_plans_files(arguments.file)) {
    PlanSource source(file);
    open_recordings(arguments, source);
    const Verdict verdict = arguments.unverified ? Verdict() : verdict_on(file, threads_of(0));
    if (arguments.unverified && !arguments.json) fmt::print("{}: {}\n", file.string(), kNotJudged);
    for (const std::string& path : source.reader.plan_paths()) {
      names.push_back(path);
      names.push_back(path.substr(0, path.rfind('/')));
    }
    for (const int k : selected_plans(arguments, source)) {
      const Plan plan = source.reader.read(k);
      const std::string& path = source.reader.plan_paths()[k];
      if (const std::string violation = verdict.violation_of(path); !violation.empty()) {
        if (arguments.json)
          all.push_back({{"plan", path}, {"status", kNotVerified}, {"violation", violation}});
        else
          fmt::print("{}{}\n  {:<13} rejected by verify: {}; --unverified prints what it says\n",
                     shown > 0 ? "\n" : "", path, kNotVerified, violation);
        ++shown;
        continue;
      }
      std::optional<Demonstration> recording;
      if (source.recordings) recording = source.recordings->read(plan.demonstration);
      std::vector<explain::TriedAdvice> advice;
      tried += plan.has_trajectory() ? 0 : 1;
      if (!plan.has_trajectory())
        advice =
            explain::collect_advice(source.robot, plan, source.config ? &*source.config : nullptr,
                                    recording ? &*recording : nullptr);
      if (arguments.json) {
        all.push_back(json_of(source, plan, path, advice));
      } else {
        fmt::print("{}{}", shown > 0 ? "\n" : "", text_of(source, plan, advice));
      }
      ++shown;
    }
  }
  if (shown == 0 && !arguments.plan.empty())
    throw InputError(
        fmt::format("{}: contains no plan '{}'{}; plan names have the form DEMONSTRATION/000",
                    arguments.file, arguments.plan, config::spelling_hint(arguments.plan, names)));
  if (arguments.try_advice && shown > 0 && tried == 0)
    fmt::print(stderr, "note: --try: none of these plans lacks a trajectory\n");
  if (arguments.json) fmt::print("{}\n", Json{{"plans", all}}.dump(2));
  if (shown == 0 && !arguments.json) fmt::print("no plan is infeasible\n");
  return 0;
}

CommandAction add_explain_arguments(CLI::App& app) {
  const auto arguments = std::make_shared<ExplainArguments>();
  app.add_option("FILE", arguments->file, "plans.h5 or the folder of a run")->required();
  app.add_option("PLAN", arguments->plan,
                 "A plan (DEMONSTRATION/000) or a demonstration (default: all infeasible plans)");
  app.add_flag(
      "--try", arguments->try_advice,
      "Plan each infeasible movement again with the advice, one by one, until one succeeds");
  app.add_option("--dataset", arguments->dataset,
                 "demonstrations.h5 for --try (default: the one in the run's folder)");
  add_unverified_option(app, arguments->unverified, "explain what the file says of them");
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] { return execute(*arguments); };
}

}  // namespace

Command explain_command() {
  return {"explain", "Explain the result of a movement, and what to try if it is infeasible",
          "  morphe explain outputs/first ADL001DR2/000\n", add_explain_arguments};
}

}  // namespace morphe::commands
