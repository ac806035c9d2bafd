#include "stages/import/trackers/hand_tracker.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/motion/input_error.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_checks.hpp"
#include "stages/import/trackers/unseen_hands.hpp"
#include "stages/import/trackers/world_checks.hpp"

namespace morphe::imports {
namespace {

void drop_unseen_hands(HandClip& clip, std::vector<std::string>& reports) {
  for (const Side side : {Side::right, Side::left}) {
    auto& hand = clip.hands[side_index(side)];
    if (!hand || any_known(hand->keypoints.values)) continue;
    hand.reset();
    add_note(reports, "the {} hand is never visible", name_of(side));
  }
}

}  // namespace

Pose TrackerFrame::pose(const Pose& in_file) const {
  return make_pose(point(in_file.translation()), rotation(Quat(in_file.linear())));
}

TrackerFrame tracker_frame(const RecordingFiles& files, const std::string& axes,
                           const std::string& unit, const std::string& axes_reason,
                           std::vector<std::string>& reports) {
  const std::string file = files.file.string();
  if (!files.static_trial.empty())
    throw InputError(file + ": static_trial: this format has no static trial");
  if (!files.name_map.empty())
    throw InputError(file + ": names: the names of this format are known; remove names");
  TrackerFrame frame;
  frame.unit_m = resolve_unit_m(unit, files.conventions, file, reports);
  const std::string& given = files.conventions.axes;
  if (given.empty() && !axes_reason.empty()) add_note(reports, "axes '{}': {}", axes, axes_reason);
  frame.world_from_file = world_from_recorded(given.empty() ? axes : given, file);
  return frame;
}

RecordedHand unseen_hand(std::size_t rows) {
  return {Array2D<Vec3>(rows, kKeypointCount, unknown_point()), {}, {}};
}

void add_time(double time_s, const std::string& file, std::size_t line, const std::string& key,
              std::vector<double>& time) {
  if (!time.empty() && !(time_s >= time.back())) {
    throw InputError(
        fmt::format("{}:{}: {}: must be greater than in the previous row", file, line, key));
  }
  time.push_back(time_s);
}

void add_tracked_clip(HandClip&& clip, const RecordingFiles& files, Demonstration& demonstration) {
  std::vector<std::string>& reports = demonstration.import_notes;
  if (!clip.reconstructed) hide_unseen_points(clip, reports);
  drop_unseen_hands(clip, reports);
  if (!clip.hands[0] && !clip.hands[1] && clip.body.names.empty())
    throw InputError(fmt::format("{}: no hand is visible in any frame", files.file.string()));
  check_hands(files.file.string(), clip, files.conventions.plausibility_checks, reports);
  check_world(clip, reports);
  add_clip(std::move(clip), demonstration);
}

void add_shape(HandClip&& clip, const RecordingFiles& files, const std::string& why,
               Demonstration& demonstration) {
  std::vector<std::string>& reports = demonstration.import_notes;
  hide_unseen_points(clip, reports);
  drop_unseen_hands(clip, reports);
  Side side = files.hand;
  if (!clip.hands[side_index(side)]) side = side == Side::right ? Side::left : Side::right;
  auto& hand = clip.hands[side_index(side)];
  if (!hand)
    throw InputError(fmt::format("{}: no hand is visible in any frame", files.file.string()));
  check_hands(files.file.string(), clip, files.conventions.plausibility_checks, reports);
  add_note(reports, "{}: only the shape of the {} hand is used, not its position", why,
           name_of(side));
  HandStream& stream = demonstration.streams.hand.emplace();
  stream.kind = HandKind::keypoints;
  stream.time = std::move(clip.time);
  stream.position = std::move(hand->keypoints);
}

SceneObject placeholder_sphere(const std::string& name, std::vector<std::string>& reports) {
  constexpr double kPlaceholderRadius_m = 0.03;
  SceneObject ball;
  ball.name = name;
  ball.shape = Shape::sphere;
  ball.size = {kPlaceholderRadius_m};
  ball.shape_origin = ObjectOrigin::inferred;
  add_note(reports,
           "object {}: only its pose was recorded; assumed a ball of {:.0f} mm diameter at its "
           "origin; set `target.body` in a config for its shape",
           name, 2000 * kPlaceholderRadius_m);
  return ball;
}

}  // namespace morphe::imports
