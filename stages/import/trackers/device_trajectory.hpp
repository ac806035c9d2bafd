#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// Where a headset was: Aria's closed_loop_trajectory.csv.
struct DeviceTrajectory {
  std::string file;
  std::vector<double> time;          ///< [N] [s] of the device's clock
  std::vector<Pose> pose;            ///< [N] world_from_device
  std::vector<std::size_t> world;    ///< [N] of which map; another one has another world
  Vec3 gravity = Vec3(0, 0, -9.81);  ///< in the world

  /// Between two rows at most 0.1 s apart, linear and slerp; held for 10 ms before the first and
  /// behind the last row of a world. None elsewhere.
  struct Place {
    Pose world_from_device;
    std::size_t world;
  };
  std::optional<Place> at(double time_s) const;
};

/// The trajectory that belongs to a file of hands: beside it, or in a folder slam/ or trajectory/
/// beside or above it. Empty if there is none.
std::filesystem::path trajectory_of(const std::filesystem::path& hands);

/// Rows that follow within 0.1 ms are dropped. InputError for what is no such file and for times
/// that run back.
DeviceTrajectory read_device_trajectory(const std::filesystem::path& file);

}  // namespace morphe::imports
