#include "stages/import/clips/clip_spider.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "core/config/node.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;
using files::NpyArray;

constexpr std::size_t kPoseValueCount = 7;  ///< x, y, z, then the quaternion w, x, y, z
constexpr double kMinFingertipDistance_m = 0.10;

/// Returns true if an array of poses exists and has a pose other than zeros and the identity.
bool has_data(const NpyArray* array) {
  if (array == nullptr) return false;
  for (std::size_t k = 0; k < array->values.size(); ++k) {
    const double value = array->values[k];
    if (value != 0 && !(value == 1 && k % kPoseValueCount == 3)) return true;
  }
  return false;
}

/// Reads ../task_info.json, if it exists, with the reader of YAML, of which JSON is a subset.
void read_task(const RecordingFiles& files, double& step_s, Demonstration& demonstration) {
  const fs::path file = fs::absolute(files.file).parent_path().parent_path() / "task_info.json";
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return;
  const config::ConfigNode task = config::ConfigNode::load(file);
  if (task.has("task")) demonstration.task = task["task"].text();
  if (!task.has("ref_dt")) return;
  step_s = task["ref_dt"].number();
  if (!(step_s > 0)) task["ref_dt"].fail("must be positive");
  add_note(demonstration.import_notes, "frame period {} s, from {}", step_s,
           file.filename().string());
}

std::vector<double> times_of(ClipArrays& clip, std::size_t rows, double step_s,
                             const RecordingFiles& files, std::vector<std::string>& reports) {
  std::vector<double> time;
  const NpyArray* const stamps = clip.numbers("timestamps", {rows});
  const double in_file = step_s > 0 ? 1 / step_s : 0;
  const double rate_hz =
      stamps ? 0 : resolve_rate_hz(in_file, files.conventions, clip.file(), reports);
  for (std::size_t i = 0; i < rows; ++i) {
    time.push_back(stamps != nullptr ? (stamps->values[i] - stamps->values[0]) * 1e-9
                                     : static_cast<double>(i) / rate_hz);
    if (i > 0 && !(time[i] > time[i - 1]))
      clip.fail("timestamps", fmt::format("value {} must be greater than the previous one", i));
  }
  return time;
}

std::optional<RecordedHand> read_hand(ClipArrays& clip, Side side, std::size_t rows,
                                      const TrackerFrame& frame,
                                      std::vector<std::string>& reports) {
  const NpyArray* const wrist = clip.numbers(spider_key("wrist", side), {rows, kPoseValueCount});
  const NpyArray* const tips =
      clip.numbers(spider_key("finger", side), {rows, kFingerCount, kPoseValueCount});
  if (!has_data(wrist)) return std::nullopt;
  RecordedHand hand = unseen_hand(rows);
  double sum_m = 0, count = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    hand.keypoints(i, 0) =
        frame.point(Eigen::Map<const Vec3>(wrist->values.data() + kPoseValueCount * i));
    for (std::size_t finger = 0; finger < kFingerCount && has_data(tips); ++finger) {
      const double* const tip = tips->values.data() + kPoseValueCount * (kFingerCount * i + finger);
      hand.keypoints(i, 4 + 4 * finger) = frame.point(Eigen::Map<const Vec3>(tip));
      if (finger == kThumb) continue;
      sum_m += (hand.keypoints(i, 4 + 4 * finger) - hand.keypoints(i, 0)).norm();
      ++count;
    }
  }
  if (count > 0 && sum_m / count < kMinFingertipDistance_m) {
    add_note(reports,
             "the mean distance of the {} fingertips from the wrist is only {:.0f} mm; the point "
             "called wrist may be the knuckle of the middle finger",
             name_of(side), 1000 * sum_m / count);
  }
  return hand;
}

}  // namespace

std::string spider_key(const char* part, Side side) {
  return fmt::format("qpos_{}_{}", part, name_of(side));
}

bool is_spider(const ClipArrays& clip) {
  return clip.has(spider_key("wrist", Side::right)) || clip.has(spider_key("wrist", Side::left));
}

Demonstration read_spider(ClipArrays& clip, const RecordingFiles& files) {
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  double step_s = 0;
  read_task(files, step_s, demonstration);
  const TrackerFrame frame = tracker_frame(
      files, "x y z", "m", "Z is up in SPIDER; facing direction not in the file", reports);
  const Side first_side = clip.has(spider_key("wrist", Side::right)) ? Side::right : Side::left;
  const std::size_t rows =
      clip.numbers(spider_key("wrist", first_side), {ClipArrays::kAnyLength, kPoseValueCount})
          ->shape[0];
  HandClip hands;
  hands.time = times_of(clip, rows, step_s, files, reports);
  for (const Side side : {Side::right, Side::left}) {
    hands.hands[side_index(side)] = read_hand(clip, side, rows, frame, reports);
    const NpyArray* const poses = clip.numbers(spider_key("obj", side), {rows, kPoseValueCount});
    if (!has_data(poses)) continue;
    SceneObject object = placeholder_sphere(fmt::format("{}_object", name_of(side)), reports);
    object.time = hands.time;
    for (std::size_t i = 0; i < rows; ++i) {
      const double* const q = poses->values.data() + kPoseValueCount * i;
      const Quat rotation(q[3], q[4], q[5], q[6]);
      if (!(std::abs(rotation.norm() - 1) < 1e-3)) {
        clip.fail(poses->name, fmt::format("the quaternion of row {} has length {:.4g}, must be 1",
                                           i, rotation.norm()));
      }
      object.position.push_back(frame.point(Vec3(q[0], q[1], q[2])));
      object.orientation.push_back(frame.rotation(rotation));
    }
    hands.objects.push_back(std::move(object));
  }
  reports.push_back(
      "only wrists and fingertips used; wrist rotation skipped, since its axes depend on the "
      "original data set");
  if (const std::vector<std::string> unread = clip.unread(); !unread.empty())
    add_note(reports, "keys skipped: {}", fmt::join(unread, ", "));
  add_tracked_clip(std::move(hands), files, demonstration);
  return demonstration;
}

}  // namespace morphe::imports
