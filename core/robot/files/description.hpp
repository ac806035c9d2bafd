#pragma once

#include <filesystem>
#include <string>

#include "core/files/given_files.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/files/robot_description.hpp"

namespace morphe::robot {

/// Reads a robot description (docs/formats.md): DH chains, a URDF (with an SRDF), a generated arm
/// or hand, or `parts` that mount other descriptions (a hand on an arm). Throws InputError with a
/// line, with file, line and key, for each error: unknown or missing keys, a joint without limits,
/// a coupling to an unknown joint, references to frames or capsules that do not exist. With given
/// files, it and all that it names are read from these.
RobotDescription load_robot(const std::filesystem::path& file,
                            const files::GivenFiles* given = nullptr);
/// Parses a robot description from a text as if it were the content of `file`.
RobotDescription parse_robot(const std::string& text, const std::filesystem::path& file);

}  // namespace morphe::robot
