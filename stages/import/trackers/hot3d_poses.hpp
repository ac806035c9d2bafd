#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// Poses of a body as HOT3D's tables have them, in the recording's world.
struct TimedPoses {
  std::vector<std::int64_t> time_ns;
  std::vector<Pose> pose;
};

/// dynamic_objects.csv or headset_trajectory.csv: the poses of each body by its number, in the
/// order of their times. InputError for what is no such table.
std::map<std::string, TimedPoses> read_hot3d_poses(const std::filesystem::path& file);

}  // namespace morphe::imports
