#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The trajectory of a headset: Aria's closed_loop_trajectory.csv.
struct DeviceTrajectory {
  std::string file;                  ///< file name for messages
  std::vector<double> time;          ///< [N] [s] on the device's clock
  std::vector<Pose> pose;            ///< [N] world_from_device
  std::vector<int> map_index;        ///< [N]; each map has its own world
  Vec3 gravity = Vec3(0, 0, -9.81);  ///< in the world of the first row's map [m/s²]

  /// A pose and the map that it is given in.
  struct DevicePose {
    Pose world_from_device;
    int map_index;
  };
  /// Returns the pose at a time: interpolated (slerp) between two rows of one map that are at most
  /// 0.1 s apart; otherwise that of the row before or, failing that, after, at most 10 ms away.
  std::optional<DevicePose> at(double time_s) const;
};

/// Returns the closed_loop_trajectory.csv that belongs to a file of hands: in the file's folder or
/// the one above, or in slam/ or trajectory/ in either. Empty if there is no such file.
std::filesystem::path find_trajectory_file(const std::filesystem::path& hands);

/// Reads a trajectory, without rows less than 0.1 ms after the previous one of the same map. Throws
/// InputError for missing columns, decreasing times and quaternions whose norm is not 1.
DeviceTrajectory read_device_trajectory(const std::filesystem::path& file);

}  // namespace morphe::imports
