#include "pipeline/commands/robot_setup.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iterator>
#include <memory>

#include "core/files/atomic_file.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/describe/robot_svg.hpp"
#include "pipeline/describe/robot_text.hpp"
#include "pipeline/setup/setup.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

struct SetupArguments {
  std::vector<std::string> inputs, packages;
  std::string out, name, hand;
  std::vector<double> mount;
  int capsules = 0;
};

bool is_urdf(const fs::path& file) {
  return file.extension() == ".urdf" || file.extension() == ".xml";
}

std::optional<std::string> text_of(const fs::path& file) {
  if (!fs::exists(file)) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

setup::PackagePaths package_paths_of(const std::vector<std::string>& packages) {
  setup::PackagePaths paths;
  for (const std::string& package : packages) {
    const std::size_t equals = package.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InputError(fmt::format("--package {}: must be NAME=DIR", package));
    paths.packages[package.substr(0, equals)] = package.substr(equals + 1);
  }
  return paths;
}

/// Writes a description and its picture, and prints the properties to be checked.
void write_description(const setup::SetupResult& result, const fs::path& out) {
  files::write_atomically(out, result.text);
  const robot::RobotDescription robot = robot::load_robot(out);
  fs::path picture = out;
  picture.replace_extension(".svg");
  files::write_atomically(picture, describe::robot_svg(robot.table, result.points));
  for (const std::string& note : result.notes) fmt::print("note: {}\n", note);
  for (const std::string& remark : describe::plausibility_notes(robot))
    fmt::print("note: {}\n", remark);
  for (const std::string& check : result.to_check) fmt::print("check: {}\n", check);
  fmt::print("{}: {}, {}, {}; {}\n", out.string(), count_with_noun(robot.table.joints(), "joint"),
             count_with_noun(robot.table.tips.size(), "tip"),
             count_with_noun(robot.table.capsules.size(), "capsule"), picture.string());
}

setup::SetupRequest request_for(const SetupArguments& arguments, const fs::path& urdf,
                                const fs::path& out) {
  setup::SetupRequest request;
  request.urdf = urdf;
  request.out = out;
  request.hand = arguments.hand;
  request.package_paths = package_paths_of(arguments.packages);
  if (arguments.capsules > 0) {
    setup::CapsuleBudget& budget = request.budget;
    budget.arm = budget.wrist = budget.palm = budget.finger = arguments.capsules;
  }
  return request;
}

int execute(const SetupArguments& arguments) {
  if (arguments.inputs.size() > 2) throw InputError("robot setup: needs an arm, a hand, or both");
  const fs::path out = arguments.out;
  for (const std::string& input : arguments.inputs) files::expect_not_input(out, input);
  std::vector<fs::path> descriptions;
  for (const std::string& input : arguments.inputs) {
    const bool alone = arguments.inputs.size() == 1;
    if (!is_urdf(input)) {
      if (alone) throw InputError(fmt::format("{}: is not a URDF", input));
      descriptions.emplace_back(input);
      continue;
    }
    const fs::path file =
        alone ? out : fs::absolute(out).parent_path() / (fs::path(input).stem().string() + ".yaml");
    setup::SetupRequest request = request_for(arguments, input, file);
    if (alone) request.name = arguments.name;
    if (!alone) request.hand.clear();
    write_description(setup::make_description(request, text_of(file)), file);
    descriptions.push_back(file);
  }
  if (descriptions.size() < 2) return 0;
  setup::MountRequest request{descriptions[0], descriptions[1], out, arguments.name, {}};
  const auto& m = arguments.mount;
  if (!m.empty()) request.mount = {{m[0], m[1], m[2]}, {m[3], m[4], m[5]}};
  write_description(setup::mount_hand(request, text_of(out)), out);
  return 0;
}

}  // namespace

CommandAction add_robot_setup(CLI::App& robot) {
  CLI::App& app = *robot.add_subcommand(
      "setup", "Create a robot description from a URDF, or from those of an arm and a hand");
  app.footer("Examples:\n  morphe robot setup outputs/robot.urdf --out outputs/new_robot.yaml\n");
  const auto arguments = std::make_shared<SetupArguments>();
  add_input_option(app, "URDF", arguments->inputs,
                   "URDF of an arm, a hand, or both in this order (robot descriptions work, too)")
      ->required();
  app.add_option("--out", arguments->out,
                 "Description to write (YAML); a drawing (SVG) is written next to it")
      ->required();
  app.add_option("--name", arguments->name, "The robot's name");
  app.add_option("--mount", arguments->mount,
                 "X Y Z ROLL PITCH YAW: the hand's base on the arm's flange (m, rad)")
      ->expected(6);
  app.add_option("--hand", arguments->hand, "Link from which the fingers branch");
  app.add_option("--package", arguments->packages, "NAME=DIR: folder of package://NAME")
      ->allow_extra_args(false);
  app.add_option("--capsules", arguments->capsules, "Maximum number of capsules per link")
      ->check(CLI::Range(1, 1000));
  return [arguments] { return execute(*arguments); };
}

robot::RobotDescription read_robot(const fs::path& file) {
  if (!is_urdf(file)) return robot::load_robot(file);
  setup::SetupRequest request;
  request.urdf = file;
  request.out = file.parent_path() / (file.stem().string() + ".yaml");
  const setup::SetupResult result = setup::make_description(request, std::nullopt);
  robot::RobotDescription robot = robot::parse_robot(result.text, request.out);
  robot.notes.insert(robot.notes.end(), result.notes.begin(), result.notes.end());
  for (const std::string& check : result.to_check) robot.notes.push_back("check " + check);
  return robot;
}

}  // namespace morphe::commands
