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

namespace morphe::commands {
namespace {

/// Larger rates exceed those of arm controllers and increase the size of the files.
constexpr double kMaxRate_hz = 1e4;

struct ExportArguments {
  std::string plans, out, approach{name_of(exports::ApproachMode::apart)};
  exports::ExportOptions options;
  bool unverified = false;
};

int execute(ExportArguments& arguments) {
  const std::filesystem::path plans = find_plans_file(arguments.plans);
  auto& motion = arguments.options.motion;
  if (std::isnan(motion.delay_s)) throw InputError("--delay: must be a number of seconds");
  if (std::isnan(motion.rate_hz)) throw InputError("--rate: must be a number of points per second");
  motion.approach = *enum_from_name<exports::ApproachMode>(arguments.approach);
  run::OutputFolder folder(arguments.out);
  arguments.options.not_verified = expect_verified(plans, arguments.unverified, threads_of(0));
  const exports::ExportReport report =
      exports::export_plans(plans, folder.path(), arguments.options);
  folder.keep();
  for (const exports::SkippedPlan& skipped : report.skipped)
    fmt::print("{} skipped: {}\n", skipped.plan, skipped.reason);
  for (const std::string& file : report.files) fmt::print("{}\n", (folder.path() / file).string());
  if (arguments.unverified) fmt::print("note: the plans were not verified, which the index says\n");
  if (!report.limit_use.empty()) fmt::print("{}\n", report.limit_use);
  if (!report.remark.empty()) fmt::print("note: {}\n", report.remark);
  fmt::print("{} and the index written, {} skipped\n",
             count_with_noun(report.files.size() - 1, "file"),
             count_with_noun(report.skipped.size(), "plan"));
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
      ->allow_extra_args(false);
  app.add_option("--rate", options.motion.rate_hz,
                 "Points per second, on the certified curve (default: the samples of the plan, and "
                 "points between them until cubic interpolation is within the limits)")
      ->check(CLI::Range(1e-3, kMaxRate_hz));
  app.add_option("--delay", options.motion.delay_s,
                 "Time that each motion waits in its first posture, s")
      ->check(CLI::Range(0.0, 3600.0));
  app.add_option("--approach", arguments->approach,
                 "Approach from home and retreat: separate files (apart), joined with the "
                 "trajectory (joined), or none")
      ->check(one_of({"apart", "joined", "none"}));
  app.add_flag("--replace", options.replace, "Replace existing files whose content differs");
  add_unverified_option(app, arguments->unverified, "export them marked as not verified");
  return [arguments] { return execute(*arguments); };
}

}  // namespace

Command export_command() {
  return {"export", "Write executable plans as CSV, ROS or robomimic files",
          "  morphe export outputs/first --format csv --out outputs/csv\n"
          "  morphe export outputs/first --format robomimic --out outputs/training\n",
          add_export_arguments};
}

}  // namespace morphe::commands
