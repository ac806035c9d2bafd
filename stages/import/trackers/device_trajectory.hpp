#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The trajectory of a headset: Aria's closed_loop_trajectory.csv.
struct DeviceTrajectory {
  std::string file;                    ///< file name for messages
  std::vector<double> time;            ///< [N] [s] on the device's clock
  std::vector<Pose> pose;              ///< [N] world_from_device
  std::vector<std::size_t> map_index;  ///< [N] index of the map; each map has its own world
  Vec3 gravity = Vec3(0, 0, -9.81);    ///< in the world

  /// A pose between two rows at most 0.1 s apart, interpolated linearly and by slerp; it is held
  /// for 10 ms before the first and after the last row of a world.
  struct DevicePose {
    Pose world_from_device;
    std::size_t map_index;
  };
  /// Returns the pose at a time, no value outside of these intervals.
  std::optional<DevicePose> at(double time_s) const;
};

/// Returns the trajectory that belongs to a file of hands: beside it, or in a folder slam/ or
/// trajectory/ beside or above it. Empty if there is no such file.
std::filesystem::path find_trajectory_file(const std::filesystem::path& hands);

/// Reads a trajectory. Rows that follow within 0.1 ms are dropped. Throws InputError for another
/// kind of file and for decreasing times.
DeviceTrajectory read_device_trajectory(const std::filesystem::path& file);

}  // namespace morphe::imports
