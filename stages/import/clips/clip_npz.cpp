// Clips contain hands, arms and objects in one world, as arrays of numpy with a fixed set of keys
// (docs/clips.md). Files of FlashDexRetarget are clips. SPIDER's keypoints have keys of their own.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/motion/input_error.hpp"
#include "stages/import/clips/clip_hand.hpp"
#include "stages/import/clips/clip_objects.hpp"
#include "stages/import/clips/clip_spider.hpp"
#include "stages/import/clips/readers.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/recording/format.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/time_unit.hpp"
#include "stages/import/trackers/unseen_hands.hpp"

namespace morphe::imports {
namespace {

constexpr double kMinRate_hz = 1, kMaxRate_hz = 1000;  ///< as the periods in time_unit.cpp

/// Returns true for a key of a hand, a body or an object, by which a .npz is recognised as a clip.
bool is_clip_key(const std::string& key) {
  for (const Side side : {Side::right, Side::left}) {
    if (key.starts_with(clip_prefix(side)) || key == spider_key("wrist", side)) return true;
    if (key == fmt::format("obj_{}_pose", name_of(side))) return true;
  }
  return key == "body_joints" || (key.starts_with("object_") && key.ends_with("_pose"));
}

[[noreturn]] void fail_as_no_clip(const std::string& file, const std::vector<std::string>& keys) {
  throw InputError(fmt::format(
      "{}: is not a clip: it has neither {}joints, {}joints, body_joints, {} nor {}, only {}", file,
      clip_prefix(Side::right), clip_prefix(Side::left), spider_key("wrist", Side::right),
      spider_key("wrist", Side::left),
      keys.empty() ? "nothing" : fmt::format("{}", fmt::join(keys, ", "))));
}

/// Returns the number of frames of the clip, by the first of the arrays below that exists.
std::size_t rows_of(ClipArrays& clip) {
  constexpr std::size_t kAny = ClipArrays::kAnyLength;
  if (const auto* const times = clip.numbers("times", {kAny})) return times->shape[0];
  for (const Side side : {Side::right, Side::left}) {
    const std::string prefix = clip_prefix(side);
    if (const auto* const wrist = clip.numbers(prefix + "wrist_pos", {kAny, 3}))
      return wrist->shape[0];
    if (const auto* const joints = clip.numbers(prefix + "joints", {kAny, kAny, 3}))
      return joints->shape[0];
  }
  if (const auto* const body = clip.numbers("body_joints", {kAny, kAny, 3})) return body->shape[0];
  fail_as_no_clip(clip.file(), clip.unread());
}

/// Returns the seconds in one unit of the clip's times. A given rate is that of their median step.
double seconds_per_time(const std::vector<double>& times, const Conventions& conventions,
                        const std::string& file, std::vector<std::string>& reports) {
  if (!conventions.rate_hz) {
    std::vector<std::string> notes;
    const double seconds = seconds_per_unit("times", "", times, file, notes);
    if (seconds != 1) std::ranges::move(notes, std::back_inserter(reports));
    return seconds;
  }
  const double step = median_step(times);
  return 1 / (resolve_rate_hz(1 / step, conventions, file, reports) * step);
}

ClipClock clock_of(ClipArrays& clip, std::size_t rows, const Conventions& conventions,
                   std::vector<std::string>& reports) {
  ClipClock clock;
  if (rows < 2) throw InputError(fmt::format("{}: has fewer than two frames", clip.file()));
  if (const auto* const times = clip.numbers("times", {rows})) {
    clip.expect_increasing("times", times->values);
    clock.seconds = seconds_per_time(times->values, conventions, clip.file(), reports);
    for (const double value : times->values) clock.time.push_back(clock.seconds * value);
    return clock;
  }
  const double in_file = clip.number("fps").value_or(0);
  if (in_file != 0 && !(in_file >= kMinRate_hz && in_file <= kMaxRate_hz) && !conventions.rate_hz) {
    throw UnresolvedConvention(
        "rate", fmt::format("{}: fps: {:.4g} frames per second is implausible; give --rate or "
                            "`rate_hz:`",
                            clip.file(), in_file));
  }
  const double rate_hz = resolve_rate_hz(in_file, conventions, clip.file(), reports);
  for (std::size_t i = 0; i < rows; ++i) clock.time.push_back(static_cast<double>(i) / rate_hz);
  return clock;
}

Quat quaternion(const ClipArrays& clip, const files::NpyArray& array, std::size_t k) {
  constexpr double kUnitNormTolerance = 1e-3, kUnitNormRounding = 1e-15;
  const double* const q = array.values.data() + 4 * k;  // w, x, y, z
  const Quat rotation(q[0], q[1], q[2], q[3]);
  if (!is_known(rotation) || rotation.coeffs().isZero(0)) return unknown_rotation();
  const double norm = rotation.norm();
  if (std::abs(norm - 1) > kUnitNormTolerance)
    clip.fail(array.name, fmt::format("quaternion {} has length {:.4g}, must be 1", k, norm));
  return std::abs(norm - 1) < kUnitNormRounding ? rotation : rotation.normalized();
}

BodyStream read_body(ClipArrays& clip, std::size_t rows, const TrackerFrame& frame) {
  BodyStream body = unseen_body(clip.texts("body_joint_names"), rows);
  body.parents = clip.texts("body_parents");
  const std::size_t count = body.names.size();
  const auto* const points = clip.numbers("body_joints", {rows, count, 3});
  const auto* const rotations = clip.numbers("body_rotations", {rows, count, 4});
  const auto* const confidence = clip.numbers("body_confidence", {rows, count});
  if (count > 0 && points == nullptr) clip.fail("body_joints", "is missing");
  if (!body.parents.empty() && body.parents.size() != count)
    clip.fail("body_parents", fmt::format("must have {} names", count));
  for (const std::string& name : body.names) {
    if (std::ranges::count(body.names, name) > 1)
      clip.fail("body_joint_names", fmt::format("'{}' appears twice", name));
  }
  // Not rotated or normalised again, so that clips written by Morphe are restored bit for bit.
  const bool in_world = frame.world_from_file == Eigen::Matrix3d::Identity();
  if (confidence != nullptr) body.confidence = {rows, count, kUnknown};
  for (std::size_t k = 0; k < rows * count; ++k) {
    body.position.values[k] = frame.point(Eigen::Map<const Vec3>(points->values.data() + 3 * k));
    if (confidence != nullptr) body.confidence.values[k] = confidence->values[k];
    if (rotations == nullptr) continue;
    const Quat rotation = quaternion(clip, *rotations, k);
    if (is_known(rotation))
      body.orientation.values[k] = in_world ? rotation : frame.rotation(rotation);
  }
  return body;
}

/// Removes the joints of a hand that the body also has, and a hand without other joints.
void drop_duplicate_joints(HandClip& clip) {
  for (const Side side : {Side::right, Side::left}) {
    auto& hand = clip.hands[side_index(side)];
    if (!hand) continue;
    Array2D<Vec3>& joints = hand->keypoints;
    const std::vector<std::string> names = keypoint_names(side);
    const std::string hand_name = std::string(name_of(side)) + "_hand";
    if (name_index(clip.body.names, hand_name) >= 0) hand->orientation.clear();
    for (int k = 0; k < kKeypointCount; ++k) {
      if (name_index(clip.body.names, names[k]) < 0) continue;
      for (std::size_t i = 0; i < joints.rows; ++i) joints(i, k) = unknown_point();
    }
    if (!any_known(joints.values) && !clip.body.names.empty()) hand.reset();
  }
}

void read_clip_metadata(ClipArrays& clip, double seconds, Demonstration& demonstration) {
  demonstration.subject = clip.text("subject").value_or("");
  demonstration.task = clip.text("task").value_or("");
  demonstration.source = clip.text("source").value_or("");
  demonstration.licence = clip.text("licence").value_or("");
  using Length = std::pair<const char*, std::optional<double>*>;
  for (const auto& [key, length] : {Length{"upper_arm", &demonstration.upper_arm},
                                    {"forearm", &demonstration.forearm},
                                    {"hand_length", &demonstration.hand_length},
                                    {"hand_breadth", &demonstration.hand_breadth}}) {
    *length = clip.number(key);
    if (*length && !(**length > 0)) clip.fail(key, "must be positive");
  }
  const std::vector<std::string> phases = clip.texts("label_phases");
  const auto* const times = clip.numbers("label_times", {phases.size(), 2});
  if (!phases.empty() && times == nullptr) clip.fail("label_times", "is missing");
  for (std::size_t k = 0; k < phases.size(); ++k) {
    const auto phase = enum_from_name<PhaseKind>(phases[k]);
    if (!phase) clip.fail("label_phases", fmt::format("'{}' is not a phase", phases[k]));
    demonstration.labels.push_back(
        {seconds * times->values[2 * k], seconds * times->values[2 * k + 1], *phase});
  }
}

std::optional<Side> declared_hand(ClipArrays& clip) {
  const std::optional<std::string> name = clip.text("hand");
  const std::optional<Side> side = name ? enum_from_name<Side>(*name) : std::nullopt;
  if (name && !side) clip.fail("hand", "must be right or left, not '" + *name + "'");
  return side;
}

/// Returns true for a key that only files of FlashDexRetarget have, whose Z is up.
bool is_flashdex(const ClipArrays& clip) {
  return clip.has("obj_right_pose") || clip.has("obj_left_pose") || clip.has("desk_context_poses");
}

/// Returns the axes to propose for a clip without `axes`: with Y up, as headsets have it, if the
/// first array of points is mainly below the plane z = 0 or is higher along y than along z.
std::string usual_axes(ClipArrays& clip) {
  Vec3 sum = Vec3::Zero();
  for (const Side side : {Side::right, Side::left}) {
    const auto* const joints = clip.numbers(clip_prefix(side) + "joints",
                                            {ClipArrays::kAnyLength, ClipArrays::kAnyLength, 3});
    for (std::size_t k = 0; joints != nullptr && k + 2 < joints->values.size(); k += 3) {
      const Vec3 point = Eigen::Map<const Vec3>(joints->values.data() + k);
      if (is_known(point)) sum += point;
    }
  }
  return sum.z() < 0 || sum.y() > sum.z() ? "x -z y" : "x y z";
}

TrackerFrame frame_of(ClipArrays& clip, const RecordingFiles& files, bool axes_matter,
                      std::vector<std::string>& reports) {
  const std::optional<std::string> axes = clip.text("axes");
  if (!axes && axes_matter && !is_flashdex(clip) && files.conventions.axes.empty()) {
    throw_unknown_axes(clip.file(), ", since the clip has no key 'axes', and headsets have Y up",
                       usual_axes(clip));
  }
  const char* const reason =
      axes ? "as stated in the clip"
           : "those of FlashDexRetarget's files, with Z up; facing direction not in the file";
  return tracker_frame(files, axes.value_or("x y z"), clip.text("unit").value_or("m"),
                       axes || axes_matter ? reason : "", reports);
}

}  // namespace

bool recognises_clip_npz(std::string_view head) { return files::is_npz(head); }

bool holds_a_clip(const std::filesystem::path& file) {
  return std::ranges::any_of(files::npz_keys(file), is_clip_key);
}

std::optional<Side> clip_reaching_side(const std::filesystem::path& file) {
  ClipArrays clip(files::read_npz(file));
  return declared_hand(clip);
}

Demonstration read_clip_npz(const RecordingFiles& files) {
  // Keys are checked first: the arrays of other files may be unreadable, such as Python objects.
  const std::vector<std::string> keys = files::npz_keys(files.file);
  if (std::ranges::none_of(keys, is_clip_key)) fail_as_no_clip(files.file.string(), keys);
  ClipArrays clip(files::read_npz(files.file));
  if (is_spider(clip)) return read_spider(clip, files);
  Demonstration demonstration;
  demonstration.import_notes = clip.texts("reports");
  std::vector<std::string>& reports = demonstration.import_notes;
  if (const auto declared = declared_hand(clip); declared && *declared != files.hand) {
    add_note(reports, "the clip states that the {} hand reaches; the {} one was requested and used",
             name_of(*declared), name_of(files.hand));
  }
  const bool in_hand = clip.number("in_hand").value_or(0) != 0;
  const TrackerFrame frame = frame_of(clip, files, !in_hand, reports);
  HandClip hands;
  const std::size_t rows = rows_of(clip);
  const ClipClock clock = clock_of(clip, rows, files.conventions, reports);
  hands.time = clock.time;
  read_clip_metadata(clip, clock.seconds, demonstration);
  hands.reconstructed = clip.number("rebuilt").value_or(0) != 0;
  for (const Side side : {Side::right, Side::left}) {
    hands.hands[side_index(side)] =
        read_clip_hand(clip, side, rows, frame, hands.reconstructed, files.conventions, reports);
  }
  hands.body = read_body(clip, rows, frame);
  hands.objects = read_clip_objects(clip, clock, frame, reports);
  clip.number("fps");  // a known key, even if it was not needed
  if (const std::vector<std::string> unread = clip.unread(); !unread.empty())
    add_note(reports, "keys skipped, not keys of a clip: {}", fmt::join(unread, ", "));
  const auto& used = hands.hands[side_index(files.hand)];
  const bool local = hands.body.names.empty() && used && is_wrist_at_origin(*used);
  if (in_hand || local) {
    add_shape(
        std::move(hands), files,
        local ? "the wrist is the origin in every frame: the points are in the frame of the hand"
              : "the clip's points are in the frame of the hand",
        demonstration);
    return demonstration;
  }
  drop_duplicate_joints(hands);
  add_tracked_clip(std::move(hands), files, demonstration);
  return demonstration;
}

}  // namespace morphe::imports
