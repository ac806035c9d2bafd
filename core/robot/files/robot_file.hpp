#pragma once

#include <cstdint>
#include <filesystem>

#include "core/files/xml_text.hpp"

namespace morphe::robot {

/// The kinds of files from which robots are read; a description is YAML.
enum class RobotFile : std::uint8_t { description, urdf, mjcf };

/// Returns the kind of a file by its content. Throws InputError that says which other kind it is,
/// and how to obtain a robot from it.
RobotFile robot_file_kind(const std::filesystem::path& file,
                          const files::GivenFiles* given = nullptr);

/// Reads a URDF or SRDF. Throws InputError as robot_file_kind() does, also for an MJCF.
files::XmlText read_urdf_text(const std::filesystem::path& file,
                              const files::GivenFiles* given = nullptr);

}  // namespace morphe::robot
