#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "core/files/atomic_file.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/demonstration_file.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/import_summary.hpp"
#include "pipeline/commands/place_report.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/place/place.hpp"
#include "pipeline/place/reachability_map.hpp"
#include "pipeline/run/output_files.hpp"
#include "pipeline/run/status_line.hpp"
#include "stages/import/import.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

struct PlaceArguments {
  std::string config, dataset, out, reach_map, mount, fix;
  std::vector<std::string> settings;
  place::PlaceOptions options;
  double tilt_deg = 0;
  int jobs = 0;
  bool quiet = false, json = false;
};

std::vector<Demonstration> read_dataset(const PlaceArguments& arguments,
                                        const planning::LoadedConfig& config) {
  const fs::path file = arguments.dataset.empty() ? config.dataset : fs::path(arguments.dataset);
  if (file.empty())
    throw InputError(
        fmt::format("{}: dataset: is missing (give it here, or --dataset)", arguments.config));
  expect_exists(file);
  std::vector<Demonstration> demonstrations;
  if (fs::is_directory(file) || !is_demonstrations_file(file)) {
    imports::ImportRequest request;
    request.paths = {file};
    request.keep_going = true;
    const imports::ImportResult imported = imports::import_recordings(
        request,
        [&](Demonstration&& demonstration) { demonstrations.push_back(std::move(demonstration)); });
    fmt::print(stderr, "{}", import_summary_text(imported));
    return demonstrations;
  }
  const store::DemonstrationReader reader(file);
  for (std::size_t k = 0; k < reader.size(); ++k) demonstrations.push_back(reader.read(k));
  return demonstrations;
}

place::FixedCoordinates parse_fix_option(const std::string& list) {
  place::FixedCoordinates fixed;
  for (const std::string& word : CLI::detail::split(list, ',')) {
    if (word.empty()) continue;
    bool* const coordinate = word == "x"          ? &fixed.x
                             : word == "y"        ? &fixed.y
                             : word == "z"        ? &fixed.z
                             : word == "rotation" ? &fixed.rotation
                                                  : nullptr;
    if (!coordinate)
      throw InputError(fmt::format("--fix {}: must be one of x, y, z, rotation", list));
    *coordinate = true;
  }
  return fixed;
}

place::PlaceOptions options_of(const PlaceArguments& arguments,
                               const planning::LoadedConfig& config) {
  place::PlaceOptions options = arguments.options;
  options.seed = config.options.seed;
  options.standing = robot::standing_of(config.robot);
  options.jobs = threads_of(arguments.jobs);
  options.fixed = parse_fix_option(arguments.fix);
  if (!arguments.mount.empty())
    options.mount = enum_from_name<place::MountDirection>(arguments.mount).value();
  options.max_tilt_rad = arguments.tilt_deg * kRadPerDegree;
  if (const std::string error = validation_error(options); !error.empty())
    throw InputError("place: --" + error);
  const bool is_any = options.mount == place::MountDirection::any;
  const bool turns = !options.fixed.rotation;
  expect_effect(arguments.tilt_deg == 0 || (turns && !is_any), "--tilt",
                turns ? "with --mount any" : "with --fix rotation");
  expect_effect(arguments.mount.empty() || turns, "--mount", "with --fix rotation");
  return options;
}

/// Returns a callback that updates a line on a terminal, else prints a line after each tenth.
place::ProgressCallback progress(bool quiet, run::StatusLine& status) {
  return [quiet, &status](const std::string& stage, int finished, int total) {
    if (quiet) return;
    const std::string text = fmt::format("place: {} {} of {}", stage, finished, total);
    if (status.on_terminal()) return status.show(text);
    if (finished * 10 / total != (finished - 1) * 10 / total) status.print(text);
  };
}

/// Returns a config that extends the given one and contains only the section `placement`.
std::string config_text(const PlaceArguments& arguments, const place::PlacementResult& best) {
  const fs::path folder = fs::absolute(arguments.out).parent_path();
  const fs::path base =
      fs::weakly_canonical(arguments.config).lexically_relative(fs::weakly_canonical(folder));
  return fmt::format("# Placed by morphe place.\nextends: {}\n{}", base.generic_string(),
                     placement_yaml(best.placement));
}

int execute(const PlaceArguments& arguments) {
  for (const std::string& out : {arguments.out, arguments.reach_map})
    files::expect_not_input(out, arguments.config);
  const run::OutputFiles outputs({arguments.out, arguments.reach_map});
  const planning::LoadedConfig config = planning::load_config(arguments.config, arguments.settings);
  const place::PlaceOptions options = options_of(arguments, config);
  const planning::PlanningInputs planner{config.options, config.robot};
  const std::vector<place::TrialMovement> trials =
      place::make_trials(planner, read_dataset(arguments, config), options);
  run::StatusLine status;
  const place::ProgressCallback report = progress(arguments.json || arguments.quiet, status);
  const std::vector<place::PlacementResult> placements =
      place::find_placements(planner, trials, options, report);
  const place::PlacementResult configured =
      place::plan_with_placement(planner, trials, config.options.placement, options.jobs);
  if (!arguments.out.empty())
    files::write_atomically(arguments.out, config_text(arguments, placements.front()));
  if (!arguments.reach_map.empty())
    files::write_atomically(arguments.reach_map,
                            place::svg_of(place::reachability_map(
                                planner, trials, placements.front(), options, report)));
  status.clear();
  if (arguments.json) {
    fmt::print("{}\n", place_json(options.standing, configured, placements));
    return 0;
  }
  fmt::print("{}\n{}\n", place_table_head(), place_row("configured", options.standing, configured));
  for (std::size_t k = 0; k < placements.size(); ++k)
    fmt::print("{}\n", place_row(std::to_string(k + 1), options.standing, placements[k]));
  fmt::print("\n{}{}", placement_yaml(placements.front().placement),
             place_notes(options, configured, placements));
  if (!arguments.out.empty() && !(arguments.settings.empty() && arguments.dataset.empty()))
    fmt::print("note: {} does not contain --set and --dataset; pass them to run, too\n",
               arguments.out);
  return 0;
}

CommandAction add_place_arguments(CLI::App& app) {
  const auto arguments = std::make_shared<PlaceArguments>();
  place::PlaceOptions& options = arguments->options;
  add_input_option(app, "CONFIG", arguments->config, "Pipeline config (YAML)")->required();
  add_input_option(
      app, "--dataset", arguments->dataset,
      "Folder of recordings, recording, manifest or demonstrations.h5 to use instead of "
      "the config's");
  app.add_option("--out", arguments->out,
                 "Config to write (YAML); it extends CONFIG with the best placement");
  app.add_option("--reach-map", arguments->reach_map,
                 "SVG file for a reachability map around the best placement");
  app.add_option(
         "--mount", arguments->mount,
         "Direction of the base's z axis: floor (up, the default; a robot with a body also "
         "faces the person's way), ceiling (down), wall (horizontal), side (left or right), "
         "any")
      ->check(one_of({"any", "floor", "ceiling", "wall", "side"}));
  app.add_option("--tilt", arguments->tilt_deg, "Largest tilt from that direction, degrees");
  app.add_option(
      "--fix", arguments->fix,
      "Parts of the config's placement that are kept: x, y, z, rotation, separated by commas");
  app.add_option("--person-clearance", options.person_clearance_m,
                 "Minimum distance of the base from the middle of the person, m");
  app.add_option("--movements", options.movements,
                 "Maximum number of movements on which placements are tried");
  app.add_option("--candidates", options.candidates,
                 "Number of placements for which the movements are mapped");
  app.add_option("--refine", options.refine, "Number of placements to refine");
  app.add_option("--plan", options.plan, "Number of placements to plan completely and print");
  add_jobs_option(app, arguments->jobs);
  app.add_option("--set", arguments->settings, "Change a value of the config, such as seed=2")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  app.add_flag("--quiet", arguments->quiet, "Print no progress");
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] { return execute(*arguments); };
}

}  // namespace

Command place_command() {
  return {"place", "Find the best placement of a robot's base for a dataset",
          "  morphe place configs/pipelines/iiwa14_allegro.yaml --mount side --out "
          "outputs/placed.yaml --reach-map outputs/placed.svg\n",
          add_place_arguments};
}

}  // namespace morphe::commands
