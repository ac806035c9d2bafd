#pragma once

#include <filesystem>
#include <functional>

#include "core/robot/files/description.hpp"
#include "pipeline/commands/commands.hpp"

namespace morphe::commands {

/// Adds `setup` to `morphe robot` and returns the function to run after parsing.
CommandAction add_robot_setup(CLI::App& robot);

/// Reads a description, or a URDF, for which a description is generated.
robot::RobotDescription read_robot(const std::filesystem::path& file);

}  // namespace morphe::commands
