#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/plans_file.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/commands/verdict.hpp"
#include "pipeline/run/output_folder.hpp"
#include "stages/export/export_plans.hpp"
#include "stages/export/joint_group.hpp"
#include "stages/export/table/condition.hpp"
#include "stages/export/table/split.hpp"

namespace morphe::commands {
namespace {

/// Larger rates exceed those of arm controllers and increase the size of the files.
constexpr double kMaxRate_hz = 1e4;

struct ExportArguments {
  std::string plans, out, approach{name_of(exports::ApproachMode::apart)};
  std::string split{name_of(exports::SplitBy::none)};
  exports::ExportOptions options;
  bool unverified = false;
};

int execute(ExportArguments& arguments) {
  const std::filesystem::path plans = find_plans_file(arguments.plans);
  auto& motion = arguments.options.motion;
  motion.approach = *enum_from_name<exports::ApproachMode>(arguments.approach);
  arguments.options.split.by = *enum_from_name<exports::SplitBy>(arguments.split);
  if (!arguments.options.where.empty()) exports::Condition(arguments.options.where);  // throws
  run::OutputFolder folder(arguments.out);
  arguments.options.not_verified = expect_verified(plans, arguments.unverified, threads_of(0));
  const exports::ExportReport report =
      exports::export_plans(plans, folder.path(), arguments.options);
  folder.keep();
  for (const exports::SkippedPlan& skipped : report.skipped)
    fmt::print("{} skipped: {}\n", skipped.plan, skipped.reason);
  for (const std::string& file : report.files) fmt::print("{}\n", (folder.path() / file).string());
  if (arguments.unverified) fmt::print("note: the plans were not verified, which the index says\n");
  for (const std::string& note : report.notes) fmt::print("{}\n", note);
  if (!report.limit_use.empty()) fmt::print("{}\n", report.limit_use);
  if (!report.remark.empty()) fmt::print("note: {}\n", report.remark);
  const bool has_index = !report.files.empty() && report.files.back().starts_with("index_");
  fmt::print("{}{} written, {} skipped\n",
             count_with_noun(report.files.size() - (has_index ? 1 : 0), "file"),
             has_index ? " and the index" : "", count_with_noun(report.skipped.size(), "plan"));
  return 0;
}

CommandAction add_export_arguments(CLI::App& app) {
  const auto arguments = std::make_shared<ExportArguments>();
  exports::ExportOptions& options = arguments->options;
  app.add_option("FILE", arguments->plans, "plans.h5 or the folder of a run")->required();
  app.add_option("--format", options.format, "File format")
      ->required()
      ->check(one_of(exports::export_format_names()));
  app.add_option("--out", arguments->out, "Folder to write the files to")->required();
  app.add_option(
         "--group", options.groups,
         fmt::format("Joints per file: {}; several groups: one file each", exports::kGroupHelp))
      ->delimiter(',')
      ->type_name("GROUP")
      ->allow_extra_args(false);
  app.add_option("--rate,--fps", options.motion.rate_hz,
                 "Points or frames per second, on the certified curve (default: lerobot 30, "
                 "robomimic 20; otherwise the samples of the plan, and points between them until "
                 "cubic interpolation is within the limits)")
      ->check(within({1e-3, kMaxRate_hz, "Hz"}));
  app.add_option("--delay", options.motion.delay_s,
                 "Time that each motion waits in its first posture, s")
      ->check(within(bounds::kDuration));
  app.add_option("--approach", arguments->approach,
                 "Approach from home and retreat: separate files (apart), joined with the "
                 "trajectory (joined), or none")
      ->check(one_of({"apart", "joined", "none"}));
  app.add_option("--where", options.where,
                 "Only plans that satisfy a condition on the columns of the table, such as "
                 "'clearance > 2 mm and tempo < 1.8'");
  app.add_option("--split", arguments->split,
                 "Divide the plans for training and validation, those of one demonstration or "
                 "person on one side (default: robomimic demonstration, otherwise none)")
      ->check(one_of({"none", "demonstration", "person"}));
  app.add_option("--validation", options.split.validation_share,
                 "Share of the demonstrations or persons for validation (default: 0.1)")
      ->check(within({1e-6, 1 - 1e-6, ""}));
  app.add_flag("--replace", options.replace, "Replace existing files whose content differs");
  add_unverified_option(app, arguments->unverified, "export them marked as not verified");
  return [arguments] { return execute(*arguments); };
}

}  // namespace

Command export_command() {
  return {"export", "Write plans as CSV, ROS, robomimic or LeRobot files, or as a table",
          "  morphe export outputs/first --format csv --out outputs/csv\n"
          "  morphe export outputs/first --format table --out outputs/table\n"
          "  morphe export outputs/first --format lerobot --fps 30 --out outputs/training\n",
          add_export_arguments};
}

}  // namespace morphe::commands
