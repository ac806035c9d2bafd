#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <memory>

#include "pipeline/motion/input_error.hpp"
#include "pipeline/robot/files/write_urdf.hpp"
#include "stages/commands/commands.hpp"
#include "stages/commands/input_file.hpp"
#include "stages/describe/draw.hpp"
#include "stages/describe/report.hpp"
#include "stages/describe/self_collision.hpp"

namespace morphe::commands {
namespace {

void write_text(const std::string& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw InputError(fmt::format("{}: cannot be written", file));
}

}  // namespace

Command robot_command(CLI::App& app) {
  struct Arguments {
    std::string file, svg, urdf;
    bool json = false;
    int samples = 0;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("FILE", arguments->file, "Robot description")->required()->transform(input_file());
  app.add_option("--svg", arguments->svg, "SVG file for a drawing, front and side view");
  app.add_option("--urdf", arguments->urdf, "URDF file to write the robot to");
  app.add_option(
         "--self-collision", arguments->samples,
         "Print which pairs of capsules overlap always, never or sometimes in N random positions")
      ->check(CLI::Range(1, 100'000'000));
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] {
    const robot::RobotDescription robot = robot::load_robot(arguments->file);
    if (!arguments->svg.empty()) write_text(arguments->svg, describe::svg_of(robot.table));
    if (!arguments->urdf.empty()) write_text(arguments->urdf, robot::urdf_of(robot.table));
    if (arguments->samples > 0) {
      const describe::SelfCollision found =
          describe::sample_self_collision(robot.table, arguments->samples);
      fmt::print("{}", arguments->json ? describe::self_collision_json(robot.table, found) + "\n"
                                       : describe::self_collision_text(robot.table, found));
      return 0;
    }
    fmt::print("{}",
               arguments->json ? describe::robot_json(robot) + "\n" : describe::robot_text(robot));
    return 0;
  };
}

}  // namespace morphe::commands
