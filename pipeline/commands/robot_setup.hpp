#pragma once

#include <filesystem>

#include "core/robot/files/description.hpp"
#include "pipeline/commands/commands.hpp"

namespace morphe::commands {

/// Adds `setup` to `morphe robot`.
Command add_robot_setup(CLI::App& robot);

/// Reads a description, or a URDF that is completed by setup.
robot::RobotDescription read_robot(const std::filesystem::path& file);

}  // namespace morphe::commands
