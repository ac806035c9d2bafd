#include "pipeline/commands/robot_setup.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>

#include "core/files/atomic_file.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "core/robot/files/urdf_joints.hpp"
#include "pipeline/commands/setup_inputs.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/commands/text_table.hpp"
#include "pipeline/describe/robot_svg.hpp"
#include "pipeline/describe/robot_text.hpp"
#include "pipeline/run/status_line.hpp"
#include "pipeline/setup/setup.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

struct SetupArguments {
  std::vector<std::string> inputs, packages, limits;
  std::string out, name, hand, arm, elbow;
  std::vector<double> mount;
  int capsules = 0;
  int jobs = 0;
};

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

/// The sentences that one call of setup has printed: what holds for a part holds for the whole.
struct PrintedSentences {
  std::set<std::string> known;

  void print(const char* kind, const std::string& sentence) {
    if (known.insert(sentence).second) fmt::print("{}: {}\n", kind, sentence);
  }
};

std::string derived_text(const std::vector<setup::DerivedFrame>& derived) {
  TextTable table;
  table.columns = {{"frame", "", true}, {"link", "", true}, {"x", "mm"},
                   {"y", "mm"},         {"z", "mm"},        {"certainty", "", true}};
  for (const setup::DerivedFrame& frame : derived) {
    TextTable::Row& row = table.rows.emplace_back();
    row.cells = {frame.name, frame.link};
    for (const double x : frame.position) {
      const bool zero = std::abs(x) < 5e-5;  // avoids -0.0
      row.cells.push_back(fmt::format("{:.1f}", zero ? 0 : 1e3 * x));
    }
    row.cells.push_back(frame.certainty);
  }
  return derived.empty() ? "" : table_text(table, terminal_width());
}

/// Reads the numbers of "LOWER..UPPER".
std::optional<std::array<double, 2>> range_of(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) return std::nullopt;
  const std::vector<double> lower = robot::numbers_of(text.substr(0, dots)),
                            upper = robot::numbers_of(text.substr(dots + 2));
  if (lower.size() != 1 || upper.size() != 1 || lower[0] > upper[0]) return std::nullopt;
  return std::array{lower[0], upper[0]};
}

robot::GivenLimits limits_of(const std::vector<std::string>& texts) {
  robot::GivenLimits limits;
  for (const std::string& text : texts) {
    const std::size_t equals = text.rfind('=');
    const auto range = equals == std::string::npos || equals == 0
                           ? std::nullopt
                           : range_of(text.substr(equals + 1));
    if (!range)
      throw InputError(fmt::format(
          "--limit {}: must be JOINT=LOWER..UPPER in rad (or m), like a4=-2.27..2.27", text));
    limits[text.substr(0, equals)] = *range;
  }
  return limits;
}

/// Writes a description and its picture, and prints the properties to be checked.
void write_description(const setup::SetupResult& result, const fs::path& out,
                       PrintedSentences& printed) {
  files::write_atomically(out, result.text);
  const robot::RobotDescription robot = robot::load_robot(out);
  const fs::path picture = picture_of(out);
  files::write_atomically(picture, describe::robot_svg(robot.table, result.points));
  fmt::print("{}", derived_text(result.derived));
  for (const std::string& note : result.notes) printed.print("note", note);
  for (const std::string& remark : describe::plausibility_notes(robot))
    printed.print("note", remark);
  for (const std::string& check : result.to_check) printed.print("check", check);
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
  request.arm = arguments.arm;
  request.elbow = arguments.elbow;
  request.package_paths = package_paths_of(arguments.packages);
  request.limits = limits_of(arguments.limits);
  request.jobs = threads_of(arguments.jobs);
  if (arguments.capsules > 0) {
    setup::CapsuleBudget& budget = request.budget;
    const int capsules = arguments.capsules;
    budget = {capsules, capsules, capsules, capsules, capsules, capsules};
  }
  return request;
}

/// Makes the description of a URDF or MJCF, with progress on a terminal.
void describe_input(const SetupArguments& arguments, const SetupInput& input, bool alone,
                    PrintedSentences& printed) {
  const fs::path urdf = urdf_of_input(input);
  setup::SetupRequest request = request_for(arguments, urdf, input.description);
  if (alone) request.name = arguments.name;
  setup::SetupResult result;
  {
    run::StatusLine status;
    request.progress = [&](const std::string& step) {
      status.show(fmt::format("{}: {}", input.file.filename().string(), step));
    };
    result = setup::make_description(request, text_of(input.description));
  }
  write_description(result, input.description, printed);
}

/// Refuses options that change nothing for these inputs.
void check_effects(const SetupArguments& arguments, const std::vector<SetupInput>& inputs) {
  const bool alone = inputs.size() == 1;
  expect_effect(!alone || arguments.mount.empty(), "--mount",
                "on one file; it mounts a hand on an arm: give both");
  expect_effect(alone || arguments.hand.empty(), "--hand",
                "on an arm and a hand; set up the hand by itself first");
  const bool all_described = std::ranges::all_of(
      inputs, [](const SetupInput& input) { return input.kind == robot::RobotFile::description; });
  const std::string reason = "on robot descriptions; it is for a URDF or MJCF";
  expect_effect(!all_described || arguments.arm.empty(), "--arm", reason);
  expect_effect(!all_described || arguments.elbow.empty(), "--elbow", reason);
  expect_effect(!all_described || arguments.packages.empty(), "--package", reason);
  expect_effect(!all_described || arguments.limits.empty(), "--limit", reason);
  expect_effect(!all_described || arguments.capsules == 0, "--capsules", reason);
}

int execute(const SetupArguments& arguments) {
  const fs::path out = arguments.out;
  const SetupFiles files =
      check_setup_inputs(arguments.inputs, out, package_paths_of(arguments.packages).packages,
                         limits_of(arguments.limits));
  const std::vector<SetupInput>& inputs = files.inputs;
  check_effects(arguments, inputs);
  PrintedSentences printed;
  for (const SetupInput& input : inputs) {
    if (input.kind != robot::RobotFile::description)
      describe_input(arguments, input, inputs.size() == 1, printed);
  }
  if (inputs.size() < 2) return 0;
  setup::MountRequest request{
      inputs[0].description, inputs[1].description, out, arguments.name, {}};
  const auto& m = arguments.mount;
  if (!m.empty()) request.mount = {{m[0], m[1], m[2]}, {m[3], m[4], m[5]}};
  write_description(setup::mount_hand(request, text_of(out)), out, printed);
  return 0;
}

}  // namespace

CommandAction add_robot_setup(CLI::App& robot) {
  CLI::App& app = *robot.add_subcommand(
      "setup",
      "Create a robot description from a URDF or MJCF, or from those of an arm and a hand");
  app.footer("Examples:\n  morphe robot setup outputs/robot.urdf --out outputs/new_robot.yaml\n");
  const auto arguments = std::make_shared<SetupArguments>();
  add_input_option(
      app, "URDF", arguments->inputs,
      "URDF or MJCF of an arm, a hand, or both in this order (robot descriptions work, "
      "too); an MJCF is converted to a URDF next to the description")
      ->required();
  app.add_option("--out", arguments->out,
                 "Description to write (YAML); a drawing (SVG) is written next to it")
      ->required();
  app.add_option("--name", arguments->name, "The robot's name");
  app.add_option("--mount", arguments->mount,
                 "X Y Z ROLL PITCH YAW: the hand's base on the arm's flange (m, rad)")
      ->expected(6);
  app.add_option("--hand", arguments->hand, "Link from which the fingers branch");
  app.add_option("--arm", arguments->arm, "Link at the end of the arm, of a robot with several");
  app.add_option("--elbow", arguments->elbow, "Joint of the elbow, if it cannot be derived");
  app.add_option("--package", arguments->packages, "NAME=DIR: folder of package://NAME")
      ->allow_extra_args(false);
  app.add_option("--limit", arguments->limits,
                 "JOINT=LOWER..UPPER: limits of position that replace the URDF's (rad or m)")
      ->allow_extra_args(false);
  add_jobs_option(app, arguments->jobs);
  app.add_option("--capsules", arguments->capsules, "Maximum number of capsules per link")
      ->check(within({1, 1000}));
  return [arguments] { return execute(*arguments); };
}

robot::RobotDescription read_robot(const fs::path& file) {
  const robot::RobotFile kind =
      fs::is_regular_file(file) ? robot::robot_file_kind(file) : robot::RobotFile::description;
  if (kind != robot::RobotFile::urdf) return robot::load_robot(file);
  setup::SetupRequest request;
  request.urdf = file;
  request.out = file.parent_path() / (file.stem().string() + ".yaml");
  const setup::SetupResult result = setup::make_description(request, std::nullopt);
  robot::RobotDescription robot = robot::parse_robot(result.text, request.out);
  robot.notes.insert(robot.notes.end(), result.notes.begin(), result.notes.end());
  return robot;
}

}  // namespace morphe::commands
