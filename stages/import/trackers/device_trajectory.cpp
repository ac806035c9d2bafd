#include "stages/import/trackers/device_trajectory.hpp"

#include <algorithm>
#include <cmath>

#include "stages/import/recording/named_columns.hpp"

namespace morphe::imports {
namespace {

constexpr double kMinTimeStep_s = 1e-4, kMaxInterpolationGap_s = 0.1, kMaxExtrapolation_s = 0.010;

}  // namespace

std::optional<DeviceTrajectory::DevicePose> DeviceTrajectory::at(double time_s) const {
  const auto after = std::ranges::upper_bound(time, time_s) - time.begin();
  const bool has_before = after > 0, has_after = after < std::ssize(time);
  if (has_before && has_after && map_index[after - 1] == map_index[after] &&
      time[after] - time[after - 1] <= kMaxInterpolationGap_s) {
    const double u = (time_s - time[after - 1]) / (time[after] - time[after - 1]);
    const Pose &a = pose[after - 1], &b = pose[after];
    return DevicePose{make_pose((1 - u) * a.translation() + u * b.translation(),
                                Quat(a.linear()).slerp(u, Quat(b.linear()))),
                      map_index[after]};
  }
  if (has_before && time_s - time[after - 1] <= kMaxExtrapolation_s)
    return DevicePose{pose[after - 1], map_index[after - 1]};
  if (has_after && time[after] - time_s <= kMaxExtrapolation_s)
    return DevicePose{pose[after], map_index[after]};
  return std::nullopt;
}

std::filesystem::path find_trajectory_file(const std::filesystem::path& hands) {
  const std::filesystem::path folder = hands.parent_path(), above = folder / "..";
  for (const std::filesystem::path& place : {folder, folder / "slam", folder / "trajectory",
                                             above / "slam", above / "trajectory", above}) {
    const auto file = (place / "closed_loop_trajectory.csv").lexically_normal();
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error)) return file;
  }
  return {};
}

DeviceTrajectory read_device_trajectory(const std::filesystem::path& file) {
  const files::CsvText csv = files::read_csv(file);
  if (csv.lines.empty()) csv.fail(1, "", "the file is empty");
  const NamedColumns columns(csv, 1);
  const std::size_t uid = columns.at("graph_uid"), stamp = columns.at("tracking_timestamp_us");
  const auto numbers =
      columns.at({"tx_world_device", "ty_world_device", "tz_world_device", "qx_world_device",
                  "qy_world_device", "qz_world_device", "qw_world_device"});
  const auto gravity = columns.at({"gravity_x_world", "gravity_y_world", "gravity_z_world"});
  DeviceTrajectory trajectory;
  trajectory.file = csv.file;
  std::string last_uid;
  int map_index = 0;
  for (std::size_t line = columns.first_row(); line <= csv.lines.size(); ++line) {
    const auto row = columns.cells(line);
    const double time_s = columns.number(line, row, stamp) / 1e6;
    if (line == columns.first_row()) {
      last_uid = row[uid];
      for (int k = 0; k < 3; ++k) trajectory.gravity[k] = columns.number(line, row, gravity[k]);
    } else if (time_s < trajectory.time.back()) {
      csv.fail(line, "tracking_timestamp_us", "must be greater than in the previous row");
    }
    if (row[uid] != last_uid) {
      last_uid = row[uid];
      ++map_index;
    } else if (!trajectory.time.empty() && time_s - trajectory.time.back() < kMinTimeStep_s) {
      continue;
    }
    double v[7];
    for (int k = 0; k < 7; ++k) v[k] = columns.number(line, row, numbers[k]);
    const Quat rotation(v[6], v[3], v[4], v[5]);
    if (!(std::abs(rotation.norm() - 1) < 0.01))
      csv.fail(line, "qx_world_device", "is not a quaternion of unit length");
    trajectory.time.push_back(time_s);
    trajectory.pose.push_back(make_pose({v[0], v[1], v[2]}, rotation.normalized()));
    trajectory.map_index.push_back(map_index);
  }
  return trajectory;
}

}  // namespace morphe::imports
