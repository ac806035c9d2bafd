#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The poses of a body in HOT3D's tables, in the recording's world.
struct TimedPoses {
  std::vector<std::int64_t> time_ns;  ///< [N]
  std::vector<Pose> pose;             ///< [N] world_from_body
};

/// Reads dynamic_objects.csv or headset_trajectory.csv. Returns the poses of each body, in the
/// order of their times, by its object_uid. Throws InputError for other files.
std::map<std::string, TimedPoses> read_hot3d_poses(const std::filesystem::path& file);

}  // namespace morphe::imports
