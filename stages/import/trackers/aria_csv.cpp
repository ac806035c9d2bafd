// Hands as tracked by Project Aria's machine perception services: hand_tracking_results.csv, or
// wrist_and_palm_poses.csv of earlier versions. There is a row per frame, with columns by name, in
// metres in the frame of the device; a hand that was not seen has a confidence of 0 or less. The
// trajectory of the device is in closed_loop_trajectory.csv beside the file; its world has Z up.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "core/motion/input_error.hpp"
#include "stages/import/recording/named_columns.hpp"
#include "stages/import/trackers/device_trajectory.hpp"
#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/readers.hpp"

namespace morphe::imports {
namespace {

/// The columns of a side; points are x, y, z.
struct HandColumns {
  std::size_t confidence = 0;
  std::vector<std::vector<std::size_t>> landmarks;  ///< 21, or empty
  std::vector<std::size_t> wrist;                   ///< used if there are no landmarks
};

struct AriaFile {
  HandClip clip;          ///< in the device's frame
  bool landmarks = true;  ///< false for wrists alone
};

std::vector<std::string> point_names(const std::string& point) {
  return {"tx_" + point, "ty_" + point, "tz_" + point};
}

HandColumns hand_columns(const NamedColumns& columns, const std::string& side) {
  HandColumns hand;
  hand.confidence = columns.at(side + "_tracking_confidence");
  const KeypointOrder& order = *keypoint_order("aria");
  if (columns.has(fmt::format("tx_{}_landmark_0_device", side))) {
    for (std::size_t k = 0; k < order.joints; ++k) {
      hand.landmarks.push_back(
          columns.at(point_names(fmt::format("{}_landmark_{}_device", side, k))));
    }
  } else {
    hand.wrist = columns.at(point_names(side + "_wrist_device"));
  }
  return hand;
}

void read_hand(const NamedColumns& columns, std::size_t line,
               const std::vector<std::string_view>& row, const HandColumns& at, std::size_t i,
               RecordedHand& hand) {
  const double confidence = columns.number(line, row, at.confidence);
  hand.confidence.push_back(confidence > 0 ? std::min(confidence, 1.0) : 0.0);
  const auto point = [&](const std::vector<std::size_t>& cells) {
    return Vec3(columns.number(line, row, cells[0]), columns.number(line, row, cells[1]),
                columns.number(line, row, cells[2]));
  };
  if (!(confidence > 0)) return;
  if (at.landmarks.empty()) {
    hand.keypoints(i, 0) = point(at.wrist);
    return;
  }
  const KeypointOrder& order = *keypoint_order("aria");
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    if (order.joint[k] >= 0) {
      hand.keypoints(i, k) = point(at.landmarks[order.joint[k]]);
    }
  }
}

AriaFile read_aria_file(const files::CsvText& csv) {
  if (csv.lines.empty()) csv.fail(1, "", "the file is empty");
  const NamedColumns columns(csv, 1);
  const std::size_t stamp = columns.at("tracking_timestamp_us");
  const HandColumns right = hand_columns(columns, "right"), left = hand_columns(columns, "left");
  AriaFile read;
  read.landmarks = !right.landmarks.empty() && !left.landmarks.empty();
  RecordedHand hands[] = {unseen_hand(columns.rows()), unseen_hand(columns.rows())};
  for (std::size_t line = columns.first_row(); line <= csv.lines.size(); ++line) {
    const auto row = columns.cells(line);
    add_time(columns.number(line, row, stamp) / 1e6, csv.file, line, "tracking_timestamp_us",
             read.clip.time);
    const std::size_t i = line - columns.first_row();
    read_hand(columns, line, row, right, i, hands[0]);
    read_hand(columns, line, row, left, i, hands[1]);
  }
  read.clip.hands = {std::move(hands[0]), std::move(hands[1])};
  return read;
}

/// Returns the world that contains most rows; no value if the trajectory contains none of them.
std::optional<std::size_t> main_map(
    const std::vector<std::optional<DeviceTrajectory::DevicePose>>& places) {
  std::map<std::size_t, std::size_t> rows;
  for (const auto& place : places) {
    if (place) ++rows[place->map_index];
  }
  const auto most =
      std::ranges::max_element(rows, {}, [](const auto& entry) { return entry.second; });
  return most == rows.end() ? std::nullopt : std::optional(most->first);
}

/// Returns the axes of the trajectory's world: up is opposite to gravity.
std::string trajectory_axes(const DeviceTrajectory& trajectory, const Conventions& conventions) {
  const Vec3 up = -trajectory.gravity.normalized();
  if (!(up.z() > 0.99) && conventions.axes.empty()) {
    throw UnresolvedConvention("axes",
                               fmt::format("{}: axes: gravity points along ({:.3g}, {:.3g}, "
                                           "{:.3g}), not along -z; give --axes or `axes:`",
                                           trajectory.file, -up.x(), -up.y(), -up.z()));
  }
  return "x y z";
}

void transform_to_world(const DeviceTrajectory& trajectory, const RecordingFiles& files,
                        const std::vector<std::optional<DeviceTrajectory::DevicePose>>& places,
                        std::size_t world, HandClip& clip, std::vector<std::string>& reports) {
  const TrackerFrame frame =
      tracker_frame(files, trajectory_axes(trajectory, files.conventions), "m",
                    "Z is up (gravity); facing direction not in the file", reports);
  const std::size_t rows = clip.time.size();
  BodyStream& body = clip.body;
  body.names = {"head"};
  body.position = Array2D<Vec3>(rows, 1, unknown_point());
  body.orientation = Array2D<Quat>(rows, 1, unknown_rotation());
  std::size_t nowhere = 0, elsewhere = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const bool here = places[i] && places[i]->map_index == world;
    if (!places[i]) ++nowhere;
    if (places[i] && !here) ++elsewhere;
    for (auto& hand : clip.hands) {
      for (std::size_t k = 0; k < kKeypointCount; ++k) {
        Vec3& point = hand->keypoints(i, k);
        point = here ? frame.point(places[i]->world_from_device * point) : unknown_point();
      }
    }
    if (!here) continue;
    const Pose head = frame.pose(places[i]->world_from_device);
    body.position(i, 0) = head.translation();
    body.orientation(i, 0) = Quat(head.linear());
  }
  reports.push_back(fmt::format("device trajectory from {}", trajectory.file));
  if (nowhere > 0) {
    reports.push_back(
        fmt::format("{} of {} rows are outside of the device trajectory; treated as not visible",
                    nowhere, rows));
  }
  if (elsewhere > 0) {
    reports.push_back(
        fmt::format("the device changes its map (graph_uid): {} of {} rows are in "
                    "another map than the longest section; treated as not visible",
                    elsewhere, rows));
  }
}

}  // namespace

bool recognises_aria_csv(std::string_view head) {
  const std::string_view line = head.substr(0, head.find_first_of("\r\n"));
  return line.starts_with("tracking_timestamp_us,") &&
         line.find("left_tracking_confidence") != std::string_view::npos;
}

Demonstration read_aria_csv(const RecordingFiles& files) {
  const files::CsvText csv = files::read_csv(files.file);
  AriaFile read = read_aria_file(csv);
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  reports = csv.notes;
  if (read.landmarks) {
    reports.push_back(
        "Aria does not track the base of the thumb (CMC); thumb base and palm skipped");
  } else {
    reports.push_back("only wrists: this version of the file has no fingers");
  }
  const std::vector<double> device_time = read.clip.time;
  for (double& time_s : read.clip.time) time_s -= device_time.front();
  reports.push_back(fmt::format("time 0 is {} s of the device clock", device_time.front()));
  const std::filesystem::path beside = find_trajectory_file(files.file);
  std::string why = "no closed_loop_trajectory.csv beside the file or in a folder slam/";
  if (!beside.empty()) {
    const DeviceTrajectory trajectory = read_device_trajectory(beside);
    std::vector<std::optional<DeviceTrajectory::DevicePose>> places;
    for (const double time_s : device_time) places.push_back(trajectory.at(time_s));
    if (const auto world = main_map(places)) {
      transform_to_world(trajectory, files, places, *world, read.clip, reports);
      add_tracked_clip(std::move(read.clip), files, demonstration);
      return demonstration;
    }
    why = fmt::format("no row is within the time of {}", trajectory.file);
  }
  if (!read.landmarks) {
    throw InputError(
        fmt::format("{}: {}: the positions of the wrists in the world are unknown", csv.file, why));
  }
  tracker_frame(files, "x y z", "m", "", reports);
  add_shape(std::move(read.clip), files, why, demonstration);
  return demonstration;
}

}  // namespace morphe::imports
