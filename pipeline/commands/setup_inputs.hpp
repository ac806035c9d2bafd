#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/robot/files/robot_file.hpp"
#include "core/robot/files/urdf_model.hpp"
#include "pipeline/run/output_files.hpp"

namespace morphe::commands {

/// A file given to `robot setup`, and the description that it is or becomes.
struct SetupInput {
  std::filesystem::path file;
  robot::RobotFile kind = robot::RobotFile::description;
  std::filesystem::path description;
};

/// The inputs of `robot setup`, and the lock of all files that it will write.
struct SetupFiles {
  std::vector<SetupInput> inputs;
  run::OutputFiles outputs;
};

/// Returns the drawing that is written beside a description.
std::filesystem::path picture_of(const std::filesystem::path& description);

/// Returns the inputs of `robot setup`: one URDF or MJCF, which becomes `out`, or an arm and a
/// hand, whose URDFs or MJCFs become descriptions beside `out`. Before any work, throws InputError
/// for inputs that cannot be read, outputs that cannot be written or would overwrite an input or
/// each other, outputs that another command is writing, and folders of packages that do not exist.
/// `limits` replace those of a URDF.
SetupFiles check_setup_inputs(const std::vector<std::string>& files,
                              const std::filesystem::path& out,
                              const std::map<std::string, std::filesystem::path>& packages,
                              const robot::GivenLimits& limits);

/// Returns the URDF of an input that is not a description. An MJCF is converted: the URDF is
/// written beside the description, and its path and the parts that it lacks are printed.
std::filesystem::path urdf_of_input(const SetupInput& input);

}  // namespace morphe::commands
