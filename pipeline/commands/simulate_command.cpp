#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/files/atomic_file.hpp"
#include "core/files/sha256.hpp"
#include "core/motion/input_error.hpp"
#include "core/parallel/ordered_parallel_map.hpp"
#include "core/physics/model.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/plan_row.hpp"
#include "pipeline/commands/plans_file.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/commands/simulation_table.hpp"
#include "pipeline/commands/text_table.hpp"
#include "pipeline/commands/verdict.hpp"
#include "pipeline/run/output_folder.hpp"
#include "pipeline/run/status_line.hpp"
#include "stages/simulate/results.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

struct SimulateArguments {
  std::string plans, out, servos, integrator = "implicit";
  std::string load_directions{name_of(simulate::Directions::first)};
  std::string contacts{name_of(simulate::ContactSource::planned)};
  std::vector<double> friction_range, mass_range;
  simulate::SimulateOptions options;
  RowSelection choice;
  std::optional<std::uint64_t> seed;
  int jobs = 0;
  bool fresh = false, quiet = false, json = false, unverified = false;
};

struct SimulationTask {
  Plan plan;
  std::string name, key;
  fs::path file;
  std::optional<simulate::PlanResult> found;  ///< result of an earlier call
};

struct SimulationOutput {
  simulate::PlanResult result;
  std::string text;  ///< content of its file, "" if the file exists
  fs::path file;
};

std::vector<simulate::PlanResult> simulate_all(const SimulateArguments& arguments,
                                               const store::PlanReader& reader,
                                               const std::string& not_verified,
                                               run::OutputFolder& folder) {
  const robot::Robot robot(reader.robot());
  const std::string program = files::sha256_of_file("/proc/self/exe");
  std::vector<simulate::PlanResult> results;
  run::StatusLine status;
  std::size_t next = 0;
  parallel::OrderedParallelMap<SimulationTask, SimulationOutput> map;
  map.next = [&]() -> std::unique_ptr<SimulationTask> {
    while (next < reader.size()) {
      auto task = std::make_unique<SimulationTask>();
      task->name = reader.plan_paths()[next];
      task->plan = reader.read(next++);
      if (!arguments.choice.filters.empty() &&
          !is_selected(arguments.choice, row_of(robot, task->plan)))
        continue;
      task->key =
          simulate::result_key(robot, task->plan, arguments.options, program + not_verified);
      task->file = folder.path() / fmt::format("{}_{:03}.json", task->plan.demonstration,
                                               task->plan.movement.index);
      if (!arguments.fresh) task->found = simulate::read_result(task->file, task->key);
      return task;
    }
    return nullptr;
  };
  map.work = [&](const SimulationTask& task) {
    auto output = std::make_unique<SimulationOutput>();
    output->file = task.file;
    if (task.found) {
      output->result = *task.found;
    } else {
      output->result = simulate::simulate_plan(robot, task.plan, task.name, arguments.options);
      output->result.not_verified = not_verified;
      output->text = simulate::result_json(output->result, arguments.options, task.key);
    }
    return output;
  };
  map.write = [&](const SimulationOutput& output) {
    if (!output.text.empty()) files::write_atomically(output.file, output.text);
    folder.keep();
    results.push_back(output.result);
    if (!arguments.quiet && status.on_terminal())
      status.show(fmt::format("simulate: {} of {} plans", next, reader.size()));
  };
  parallel::run(map, threads_of(arguments.jobs));
  return results;
}

std::optional<simulate::Range> range_of(const std::vector<double>& ends) {
  if (ends.empty()) return std::nullopt;
  return simulate::Range{ends.front(), ends.back()};
}

int execute(SimulateArguments& arguments) {
  if (physics::engine_version().empty())
    throw InputError(
        "simulate: this build has no MuJoCo: install libmujoco-dev, then configure and build "
        "again");
  arguments.options.load_directions =
      *enum_from_name<simulate::Directions>(arguments.load_directions);
  arguments.options.contacts = *enum_from_name<simulate::ContactSource>(arguments.contacts);
  arguments.options.friction_range = range_of(arguments.friction_range);
  arguments.options.mass_range = range_of(arguments.mass_range);
  arguments.options.euler = arguments.integrator == "euler";
  if (const std::string error = validation_error(arguments.options); !error.empty())
    throw InputError("simulate: --" + error);
  check_selection(arguments.choice);
  const bool varies = arguments.options.rollouts > 1;
  arguments.options.seed = arguments.seed.value_or(arguments.options.seed);
  for (const auto& [is_given, option] :
       {std::pair(!arguments.friction_range.empty(), "--friction-range"),
        std::pair(!arguments.mass_range.empty(), "--mass-range"),
        std::pair(arguments.seed.has_value(), "--seed")})
    expect_effect(varies || !is_given, option, "on the first rollout; give --rollouts 2 or more");
  const fs::path plans = find_plans_file(arguments.plans);
  const store::PlanReader reader(plans);
  check_filters(arguments.choice, reader.plan_paths());
  if (!arguments.servos.empty())
    arguments.options.servos = simulate::read_servos(arguments.servos, reader.robot());
  run::OutputFolder folder(arguments.out);
  const std::string not_verified =
      expect_verified(plans, arguments.unverified, threads_of(arguments.jobs));
  const std::vector<simulate::PlanResult> results =
      simulate_all(arguments, reader, not_verified, folder);
  std::string table = simulate::csv_header();
  for (const simulate::PlanResult& result : results) table += simulate::csv_rows(result);
  files::write_atomically(folder.path() / "simulation.csv", table);
  folder.keep();
  if (!not_verified.empty() && !arguments.json)
    fmt::print("{}: {}\n", plans.string(), not_verified);
  fmt::print("{}", arguments.json ? simulation_json(results)
                                  : simulation_table(results, arguments.options, terminal_width()));
  return 0;
}

CommandAction add_simulate_arguments(CLI::App& app) {
  const auto arguments = std::make_shared<SimulateArguments>();
  simulate::SimulateOptions& options = arguments->options;
  app.add_option("FILE", arguments->plans, "plans.h5 or the folder of a run")->required();
  app.add_option("--out", arguments->out, "Folder to write the results to")->required();
  app.add_option("--rollouts", options.rollouts,
                 "Rollouts per plan; all but the first are varied (default: 16)");
  app.add_option(
         "--load-directions", arguments->load_directions,
         "Rollouts in which the weight is also applied in six directions: none, first, every")
      ->check(one_of({"none", "first", "every"}));
  app.add_option("--friction", options.friction,
                 "Friction coefficient between fingers and target (default: 0.8)");
  app.add_option("--torsional-friction", options.torsional_friction_m,
                 "Torsional friction between fingers and target, a length in m (default: 0.002)");
  app.add_option("--mass", options.mass_kg, "Mass of the target, kg (default: 0.3)");
  app.add_option("--friction-range", arguments->friction_range,
                 "FROM TO: range of the friction in all rollouts but the first")
      ->expected(2);
  app.add_option("--mass-range", arguments->mass_range,
                 "FROM TO: range of the mass in all rollouts but the first, kg")
      ->expected(2);
  app.add_option("--contacts", arguments->contacts,
                 "planned: contacts and grasp force of the plan, if it has them; nearest: nearest "
                 "points of the fingers with goals")
      ->check(one_of({"planned", "nearest"}));
  app.add_option("--thumb-force", options.force_N,
                 "Force of the thumb for nearest contacts, N (default: 8)");
  app.add_option("--hand-stiffness", options.hand_stiffness,
                 "Stiffness of the finger servos, N m/rad (default: 10)");
  app.add_option("--hand-torque-limit", options.hand_torque_limit,
                 "Torque limit of the finger motors, N m (default: 1)");
  app.add_option("--servos", arguments->servos,
                 "YAML file with stiffness, velocity_gain, armature, damping and torque_limit of "
                 "single joints")
      ->type_name("FILE");
  app.add_option("--density", options.density,
                 "Density of the robot's capsules, kg/m^3 (default: 1000)");
  app.add_option("--time-step", options.step_s, "Time step of the simulation, s (default: 0.002)");
  app.add_option("--integrator", arguments->integrator, "Integrator: implicit or euler")
      ->check(one_of({"implicit", "euler"}));
  app.add_option("--seed", arguments->seed, "Random seed of the variations (default: 1)");
  app.add_option(
         "--only", arguments->choice.filters,
         "Only plans with this status, reason or name (with * and ?); if repeated, all must match")
      ->type_name("WHAT")
      ->allow_extra_args(false);
  add_jobs_option(app, arguments->jobs);
  app.add_flag("--fresh", arguments->fresh, "Simulate again even if the result already exists");
  app.add_flag("--quiet", arguments->quiet, "Show no progress");
  add_unverified_option(app, arguments->unverified, "simulate them; the results say so");
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] { return execute(*arguments); };
}

}  // namespace

Command simulate_command() {
  return {"simulate", "Simulate whether the grasps of a plans.h5 hold",
          "  morphe simulate outputs/first --out outputs/physics --only ADL001DR2 --rollouts 2\n",
          add_simulate_arguments};
}

}  // namespace morphe::commands
