#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "core/files/atomic_file.hpp"
#include "core/motion/input_error.hpp"
#include "core/robot/files/write_urdf.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/robot_setup.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/describe/robot_svg.hpp"
#include "pipeline/describe/robot_text.hpp"
#include "pipeline/describe/self_collision.hpp"
#include "pipeline/run/output_files.hpp"

namespace morphe::commands {

namespace fs = std::filesystem;

namespace {

CommandAction add_robot_arguments(CLI::App& app) {
  struct Arguments {
    std::string file, svg, urdf;
    bool json = false;
    int samples = 0;
  };
  const auto arguments = std::make_shared<Arguments>();
  add_input_option(app, "FILE", arguments->file, "Robot description or URDF");
  const CommandAction setup = add_robot_setup(app);
  app.add_option("--svg", arguments->svg, "SVG file for a drawing (front and side view)");
  app.add_option("--urdf", arguments->urdf, "URDF file to write the robot to");
  app.add_option("--self-collision", arguments->samples,
                 "Print the pairs of capsules that overlap always, never or sometimes in N random "
                 "positions")
      ->check(within({1, 1e8}));
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments, setup, &app] {
    if (app.got_subcommand("setup")) {
      const bool given = arguments->json || arguments->samples > 0 ||
                         !(arguments->svg + arguments->urdf + arguments->file).empty();
      expect_effect(!given, "FILE and the options before setup", "on it; give them after it");
      return setup();
    }
    if (arguments->file.empty()) throw InputError("robot: needs FILE or the subcommand setup");
    for (const std::string& out : {arguments->svg, arguments->urdf})
      files::expect_not_input(out, arguments->file);
    expect_exists(arguments->file);
    const run::OutputFiles outputs({arguments->svg, arguments->urdf});
    const robot::RobotDescription robot = read_robot(arguments->file);
    if (!arguments->svg.empty())
      files::write_atomically(arguments->svg, describe::robot_svg(robot.table));
    std::vector<std::string> unknown;
    if (!arguments->urdf.empty()) {
      robot::WrittenUrdf urdf = robot::urdf_of(robot, fs::path(arguments->urdf).parent_path());
      files::write_atomically(arguments->urdf, urdf.text);
      unknown = std::move(urdf.unknown);
    }
    if (arguments->samples > 0) {
      const describe::SelfCollision found =
          describe::sample_self_collision(robot.table, arguments->samples);
      fmt::print("{}", arguments->json ? describe::self_collision_json(robot.table, found) + "\n"
                                       : describe::self_collision_text(robot.table, found));
      return 0;
    }
    fmt::print("{}",
               arguments->json ? describe::robot_json(robot) + "\n" : describe::robot_text(robot));
    for (const std::string& sentence : unknown)
      if (!arguments->json) fmt::print("{}: {}\n", arguments->urdf, sentence);
    return 0;
  };
}

}  // namespace

Command robot_command() {
  return {"robot", "Check, print and draw a robot description",
          "  morphe robot configs/robots/pa10_dlr_hit2.yaml --svg outputs/robot.svg --urdf "
          "outputs/robot.urdf\n",
          add_robot_arguments};
}

}  // namespace morphe::commands
