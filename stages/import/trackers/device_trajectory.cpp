#include "stages/import/trackers/device_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stages/import/recording/named_columns.hpp"

namespace morphe::imports {
namespace {

constexpr double kMinTimeStep_s = 1e-4, kMaxInterpolationGap_s = 0.1, kMaxExtrapolation_s = 0.010;

Quat unit_quaternion(const NamedColumns& columns, std::size_t line, const double (&q)[4]) {
  const Quat turn(q[3], q[0], q[1], q[2]);
  if (!(std::abs(turn.norm() - 1) < 0.01)) {
    columns.csv.fail(line, "qx_world_device", "is not a quaternion of unit length");
  }
  return turn.normalized();
}

}  // namespace

std::optional<DeviceTrajectory::DevicePose> DeviceTrajectory::at(double time_s) const {
  const auto after =
      static_cast<std::size_t>(std::ranges::upper_bound(time, time_s) - time.begin());
  const bool has_before = after > 0, has_after = after < time.size();
  if (has_before && has_after && map_index[after - 1] == map_index[after] &&
      time[after] - time[after - 1] <= kMaxInterpolationGap_s) {
    const double share = (time_s - time[after - 1]) / (time[after] - time[after - 1]);
    const Pose &a = pose[after - 1], &b = pose[after];
    return DevicePose{make_pose((1 - share) * a.translation() + share * b.translation(),
                                Quat(a.linear()).slerp(share, Quat(b.linear()))),
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
  const std::vector<std::size_t> numbers =
      columns.at({"tx_world_device", "ty_world_device", "tz_world_device", "qx_world_device",
                  "qy_world_device", "qz_world_device", "qw_world_device"});
  const std::vector<std::size_t> gravity =
      columns.at({"gravity_x_world", "gravity_y_world", "gravity_z_world"});
  DeviceTrajectory trajectory;
  trajectory.file = csv.file;
  std::string last_uid;
  std::size_t world = 0;
  for (std::size_t line = columns.first_row(); line <= csv.lines.size(); ++line) {
    const auto row = columns.cells(line);
    const double time_s = columns.number(line, row, stamp) / 1e6;
    if (line == columns.first_row()) {
      last_uid = row[uid];
      for (std::size_t k = 0; k < 3; ++k) {
        trajectory.gravity[k] = columns.number(line, row, gravity[k]);
      }
    } else if (time_s < trajectory.time.back()) {
      csv.fail(line, "tracking_timestamp_us", "must be greater than in the previous row");
    }
    if (row[uid] != last_uid) {
      last_uid = row[uid];
      ++world;
    } else if (!trajectory.time.empty() && time_s - trajectory.time.back() < kMinTimeStep_s) {
      continue;
    }
    double t[3], q[4];
    for (std::size_t k = 0; k < 3; ++k) t[k] = columns.number(line, row, numbers[k]);
    for (std::size_t k = 0; k < 4; ++k) q[k] = columns.number(line, row, numbers[3 + k]);
    trajectory.time.push_back(time_s);
    trajectory.pose.push_back(make_pose({t[0], t[1], t[2]}, unit_quaternion(columns, line, q)));
    trajectory.map_index.push_back(world);
  }
  return trajectory;
}

}  // namespace morphe::imports
