// Hands as tracked by Project Aria's machine perception services: hand_tracking_results.csv, or
// wrist_and_palm_poses.csv of earlier versions. There is a row per frame, with columns by name, in
// metres in the frame of the device; a hand that was not seen has a confidence of 0 or less. The
// trajectory of the device is in closed_loop_trajectory.csv beside the file; its world has Z up.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "core/files/table_text.hpp"
#include "core/motion/input_error.hpp"
#include "stages/import/recording/named_columns.hpp"
#include "stages/import/recording/unseen_points.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/device_trajectory.hpp"
#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/readers.hpp"

namespace morphe::imports {
namespace {

/// The columns of a hand; each point has three, x, y and z.
struct HandColumns {
  std::size_t confidence = 0;
  std::vector<std::vector<std::size_t>> landmarks;  ///< 21, or empty
  std::vector<std::size_t> wrist;                   ///< empty if there are landmarks
};

struct AriaFile {
  HandClip clip;          ///< in the device's frame
  bool landmarks = true;  ///< false for wrists alone
  std::vector<std::string> notes;
};

std::vector<std::string> point_names(const std::string& point) {
  return {"tx_" + point, "ty_" + point, "tz_" + point};
}

HandColumns hand_columns(const NamedColumns& columns, const std::string& side) {
  HandColumns hand;
  hand.confidence = columns.at(side + "_tracking_confidence");
  const KeypointOrder& order = *keypoint_order("aria");
  if (!columns.has(fmt::format("tx_{}_landmark_0_device", side))) {
    hand.wrist = columns.at(point_names(side + "_wrist_device"));
    return hand;
  }
  for (std::size_t k = 0; k < order.joints; ++k) {
    hand.landmarks.push_back(
        columns.at(point_names(fmt::format("{}_landmark_{}_device", side, k))));
  }
  return hand;
}

void read_hand(const NamedColumns& columns, std::size_t line,
               const std::vector<std::string_view>& row, const HandColumns& places, std::size_t i,
               RecordedHand& hand) {
  const double confidence = columns.number(line, row, places.confidence);
  hand.confidence.push_back(confidence > 0 ? std::min(confidence, 1.0) : 0.0);
  const auto point = [&](const std::vector<std::size_t>& cells) {
    return Vec3(columns.number_or_unknown(line, row, cells[0]),
                columns.number_or_unknown(line, row, cells[1]),
                columns.number_or_unknown(line, row, cells[2]));
  };
  if (!(confidence > 0)) return;
  if (places.landmarks.empty()) {
    hand.keypoints(i, 0) = point(places.wrist);
    return;
  }
  const KeypointOrder& order = *keypoint_order("aria");
  for (int k = 0; k < kKeypointCount; ++k) {
    if (order.joint[k] >= 0) hand.keypoints(i, k) = point(places.landmarks[order.joint[k]]);
  }
}

AriaFile read_aria_file(const files::CsvText& csv) {
  if (csv.lines.empty()) csv.fail(1, "", "the file is empty");
  const NamedColumns columns(csv, csv.filled_line(1));
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
  for (RecordedHand& hand : hands) hide_fillers(1, hand.keypoints, read.notes);
  read.clip.hands = {std::move(hands[0]), std::move(hands[1])};
  return read;
}

/// The pose of the device in each row of the file; no value for rows outside of the trajectory.
using DevicePoses = std::vector<std::optional<DeviceTrajectory::DevicePose>>;

/// Returns the map with most rows; no value if all rows are outside of the trajectory.
std::optional<int> main_map(const DevicePoses& poses) {
  std::map<int, int> row_counts;
  for (const auto& pose : poses) {
    if (pose) ++row_counts[pose->map_index];
  }
  const auto main = std::ranges::max_element(row_counts, {}, &std::pair<const int, int>::second);
  return main == row_counts.end() ? std::nullopt : std::optional(main->first);
}

/// Returns the axes of the trajectory's world, which must have gravity along -Z or given axes.
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
                        const DevicePoses& poses, int map_index, HandClip& clip,
                        std::vector<std::string>& reports) {
  const TrackerFrame frame =
      tracker_frame(files, trajectory_axes(trajectory, files.conventions), "m",
                    "Z is up (gravity); facing direction not in the file", reports);
  const std::size_t rows = clip.time.size();
  clip.body = unseen_body({"head"}, rows);
  int untracked = 0, in_other_map = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const bool usable = poses[i] && poses[i]->map_index == map_index;
    if (!poses[i]) ++untracked;
    if (poses[i] && !usable) ++in_other_map;
    for (auto& hand : clip.hands) {
      for (int k = 0; k < kKeypointCount; ++k) {
        Vec3& point = hand->keypoints(i, k);
        point = usable ? frame.point(poses[i]->world_from_device * point) : unknown_point();
      }
    }
    if (usable) set_pose(frame.pose(poses[i]->world_from_device), i, 0, clip.body);
  }
  add_note(reports, "device trajectory from {}", trajectory.file);
  if (untracked > 0) {
    add_note(reports, "{} of {} rows are outside of the device trajectory; treated as not visible",
             untracked, rows);
  }
  if (in_other_map > 0) {
    add_note(reports,
             "the device changes its map (graph_uid): {} of {} rows are in another map than the "
             "longest section; treated as not visible",
             in_other_map, rows);
  }
}

}  // namespace

bool recognises_aria_csv(std::string_view head) {
  const std::string line = files::first_line_with_commas(head);
  return line.starts_with("tracking_timestamp_us,") &&
         line.find("left_tracking_confidence") != std::string::npos;
}

Demonstration read_aria_csv(const RecordingFiles& files) {
  const files::CsvText csv = files::read_table(files.file);
  AriaFile read = read_aria_file(csv);
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  reports = csv.notes;
  reports.insert(reports.end(), read.notes.begin(), read.notes.end());
  reports.push_back(
      read.landmarks
          ? "Aria does not track the base of the thumb (CMC); thumb base and palm skipped"
          : "only wrists: this version of the file has no fingers");
  const std::vector<double> device_time = read.clip.time;
  for (double& time_s : read.clip.time) time_s -= device_time.front();
  add_note(reports, "time 0 is {} s of the device clock", device_time.front());
  const std::filesystem::path trajectory_file = find_trajectory_file(files.file);
  std::string why = "no closed_loop_trajectory.csv beside the file or in a folder slam/";
  if (!trajectory_file.empty()) {
    const DeviceTrajectory trajectory = read_device_trajectory(trajectory_file);
    DevicePoses poses;
    for (const double time_s : device_time) poses.push_back(trajectory.at(time_s));
    if (const auto map_index = main_map(poses)) {
      transform_to_world(trajectory, files, poses, *map_index, read.clip, reports);
      add_tracked_clip(std::move(read.clip), files, demonstration);
      return demonstration;
    }
    why = fmt::format("no row is within the time of {}", trajectory.file);
  }
  if (!read.landmarks)
    throw InputError(csv.file + ": " + why +
                     ": the positions of the wrists in the world are unknown");
  tracker_frame(files, "x y z", "m", "", reports);
  add_shape(std::move(read.clip), files, why, demonstration);
  return demonstration;
}

}  // namespace morphe::imports
