#include "pipeline/commands/setup_inputs.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "core/files/atomic_file.hpp"
#include "core/motion/input_error.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/files/mjcf_urdf.hpp"
#include "core/robot/files/urdf_model.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;
using robot::RobotFile;

fs::path converted_urdf(const SetupInput& input) {
  return fs::path(input.description).replace_extension(".urdf");
}

/// Throws InputError if a file exists that setup has not made.
void expect_converted_or_absent(const SetupInput& input) {
  const fs::path urdf = converted_urdf(input);
  std::ifstream stream(urdf, std::ios::binary);
  if (!stream) return;
  if (robot::is_converted_mjcf(std::string(std::istreambuf_iterator<char>(stream), {}))) return;
  throw InputError(
      fmt::format("{}: exists and was not made by setup, which would write the URDF of {} there; "
                  "give another --out or remove it",
                  urdf.string(), input.file.string()));
}

void read_once(const SetupInput& input, const robot::GivenLimits& limits) {
  if (input.kind == RobotFile::description) (void)robot::load_robot(input.file);
  if (input.kind == RobotFile::urdf) (void)robot::load_urdf_model(input.file, limits);
  if (input.kind == RobotFile::mjcf) (void)robot::read_mjcf(input.file);
}

/// Returns the files that an input becomes, beside the picture of a description.
std::vector<fs::path> outputs_of(const SetupInput& input) {
  if (input.kind == RobotFile::description) return {};
  if (input.kind == RobotFile::urdf) return {input.description};
  return {input.description, converted_urdf(input)};
}

/// Locks all outputs and checks that they can be written.
run::OutputFiles lock_outputs(const std::vector<SetupInput>& inputs, const fs::path& out) {
  std::set<fs::path> outputs;
  const auto add = [&](const fs::path& file) {
    if (!outputs.insert(fs::absolute(file).lexically_normal()).second) {
      throw InputError(fmt::format(
          "{}: would be written twice; give another --out, or rename an input", file.string()));
    }
  };
  for (const SetupInput& input : inputs)
    for (const fs::path& file : outputs_of(input)) add(file);
  if (inputs.size() > 1) add(out);
  std::vector<fs::path> files(outputs.begin(), outputs.end());
  for (const fs::path& file : outputs)
    if (file.extension() != ".urdf") files.push_back(picture_of(file));
  run::OutputFiles lock(files);
  for (const fs::path& file : files) {
    for (const SetupInput& input : inputs) files::expect_not_input(file, input.file);
    const files::AtomicFile can_be_written(file);
  }
  return lock;
}

}  // namespace

fs::path picture_of(const fs::path& description) {
  return fs::path(description).replace_extension(".svg");
}

SetupFiles check_setup_inputs(const std::vector<std::string>& files, const fs::path& out,
                              const std::map<std::string, fs::path>& packages,
                              const robot::GivenLimits& limits) {
  if (files.size() > 2) throw InputError("robot setup: needs an arm, a hand, or both");
  for (const auto& [name, folder] : packages) {
    if (!fs::is_directory(folder))
      throw InputError(fmt::format("--package {}={}: is not a folder", name, folder.string()));
  }
  std::vector<SetupInput> inputs;
  for (const fs::path file : files) {
    SetupInput input{file, robot::robot_file_kind(file), file};
    if (input.kind != RobotFile::description && files.size() == 1) input.description = out;
    if (input.kind != RobotFile::description && files.size() > 1)
      input.description = fs::absolute(out).parent_path() / (file.stem().string() + ".yaml");
    if (input.kind == RobotFile::description && files.size() == 1)
      throw InputError(
          fmt::format("{}: is a robot description already; setup needs a URDF or MJCF, or also a "
                      "hand to be mounted",
                      file.string()));
    if (input.kind == RobotFile::mjcf) expect_converted_or_absent(input);
    inputs.push_back(std::move(input));
  }
  run::OutputFiles outputs = lock_outputs(inputs, out);
  for (const SetupInput& input : inputs) read_once(input, limits);
  return {std::move(inputs), std::move(outputs)};
}

fs::path urdf_of_input(const SetupInput& input) {
  if (input.kind != RobotFile::mjcf) return input.file;
  const robot::MjcfModel model = robot::read_mjcf(input.file);
  const fs::path urdf = converted_urdf(input);
  files::write_atomically(urdf, robot::urdf_of(model, urdf.parent_path()).text);
  fmt::print("{}: converted to {}, which the description uses\n", input.file.string(),
             urdf.string());
  for (const std::string& note : model.notes) fmt::print("note: {}\n", note);
  for (const std::string& check : model.to_check) fmt::print("check: {}\n", check);
  return urdf;
}

}  // namespace morphe::commands
