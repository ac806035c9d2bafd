#include "pipeline/commands/shared_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>
#include <thread>

#include "core/config/spelling_hint.hpp"
#include "core/files/data_files.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "core/motion/key_bounds.hpp"
#include "pipeline/run/startable_threads.hpp"
#include "stages/import/folders/given_options.hpp"
#include "stages/import/folders/recording_formats.hpp"

namespace morphe::commands {
namespace {

constexpr double kMaxJobs = 10'000;

}  // namespace

CLI::Validator input_file() {
  return {[](std::string& file) {
            file = files::resolve_data_file(file).string();
            return std::string();
          },
          ""};
}

void expect_exists(const std::filesystem::path& named) {
  if (!std::filesystem::exists(named))
    throw InputError(
        fmt::format("{}: cannot be read{}", named.string(), config::file_spelling_hint(named)));
}

void add_jobs_option(CLI::App& app, int& jobs) {
  app.add_option("--jobs", jobs, "Number of threads (default: 0, one per core)")
      ->check(within({0, kMaxJobs}));
}

int threads_of(int jobs) {
  const int wanted = jobs > 0 ? jobs : std::max<int>(1, std::thread::hardware_concurrency());
  int error = 0;
  const int threads = 1 + run::startable_threads(wanted - 1, error);
  if (jobs > 0 && error != 0)
    throw InputError(
        fmt::format("--jobs {}: only {} can be started: {}: give a smaller number, or raise the "
                    "limits of processes and memory (ulimit -u, ulimit -v)",
                    jobs, count_with_noun(threads, "thread"), std::strerror(error)));
  return threads;
}

void add_unverified_option(CLI::App& app, bool& unverified, const char* effect) {
  app.add_flag("--unverified", unverified, fmt::format("Do not verify the plans: {}", effect));
}

void add_row_options(CLI::App& app, RowSelection& choice) {
  std::string keys = "name";
  for (const PlanFigure& figure : plan_figures()) keys += fmt::format(", {}", figure.key);
  app.add_option("--sort", choice.sort_key, "The worst rows first: " + keys)->type_name("KEY");
  app.add_option(
         "--only", choice.filters,
         "Only plans with this status (executable, repaired, approximate, partial, infeasible), "
         "reason or name (with * and ?); if repeated, all must match")
      ->type_name("WHAT")
      ->allow_extra_args(false);
}

void expect_effect(bool has_effect, const std::string& option, const std::string& reason) {
  if (!has_effect) throw InputError(fmt::format("{} has no effect {}", option, reason));
}

void expect_no_import_options(const imports::ImportRequest& request,
                              const std::filesystem::path& file) {
  const std::vector<std::string> options = imports::given_options(request);
  expect_effect(options.empty(), fmt::format("{}", fmt::join(options, ", ")),
                fmt::format("on {}, whose demonstrations have been imported; give the recordings",
                            file.string()));
}

void expect_printed_rows(const RowSelection& choice, bool json, bool quiet) {
  if (!json && !quiet) return;
  const std::string reason =
      fmt::format("with {}, which prints no table", json ? "--json" : "--quiet");
  expect_effect(choice.sort_key.empty(), "--sort", reason);
  expect_effect(choice.filters.empty(), "--only", reason);
}

void add_import_options(CLI::App& app, imports::ImportRequest& request) {
  request.keep_going = true;
  add_input_option(app, "--static-trial", request.static_trial,
                   "Recording of the static trial (default: found among the recordings)");
  app.add_option("--format", request.format,
                 "Format of the recordings (default: recognised from their content)")
      ->check(one_of(imports::import_format_names()));
  add_input_option(app, "--names", request.name_map,
                   "YAML file that maps the names in the recording to Morphe's names");
  app.add_option("--axes", request.conventions.axes,
                 "Axes of the recording that point right, forward and up, such as 'x y z'");
  app.add_option_function<std::string>(
         "--forward",
         [&request](const std::string& source) {
           request.conventions.forward = *enum_from_name<imports::ForwardSource>(source);
           request.forward_given = true;
         },
         "Forward direction: where the body faces (body, the default), or as recorded (recorded)")
      ->check(one_of({"body", "recorded"}));
  app.add_option("--unit", request.conventions.unit,
                 "Unit of lengths: m, cm, mm, in, ft or metres per unit")
      ->type_name("UNIT");
  app.add_option("--rate", request.conventions.rate_hz, "Frames per second")
      ->check(within(bounds::kRate));
  app.add_option("--joint-order", request.conventions.joint_order,
                 "Order of the hand joints in a clip, such as openpose or mano");
  app.add_option_function<std::string>(
         "--hand",
         [&request](const std::string& hand) {
           request.hand = enum_from_name<imports::HandSelection>(hand);
         },
         "Reaching hand: right, left or both (one demonstration per hand; default: determined from "
         "the motion)")
      ->check(one_of({"right", "left", "both"}));
}

}  // namespace morphe::commands
