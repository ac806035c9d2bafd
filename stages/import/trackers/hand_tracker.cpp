#include "stages/import/trackers/hand_tracker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/motion/input_error.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/hand_checks.hpp"
#include "stages/import/trackers/world_checks.hpp"

namespace morphe::imports {
namespace {

bool ever_seen(const std::optional<RecordedHand>& hand) {
  return hand &&
         std::ranges::any_of(hand->keypoints.values, [](const Vec3& p) { return is_known(p); });
}

void drop_unseen(HandClip& clip, std::vector<std::string>& reports) {
  for (const Side side : {Side::right, Side::left}) {
    auto& hand = clip.hands[static_cast<std::size_t>(side)];
    if (!hand || ever_seen(hand)) continue;
    hand.reset();
    reports.push_back(fmt::format("the {} hand is never visible", name_of(side)));
  }
}

}  // namespace

Pose TrackerFrame::pose(const Pose& in_file) const {
  return make_pose(point(in_file.translation()), rotation(Quat(in_file.linear())));
}

TrackerFrame tracker_frame(const RecordingFiles& files, const std::string& axes,
                           const std::string& unit, const std::string& because,
                           std::vector<std::string>& reports) {
  const std::string file = files.file.string();
  if (!files.static_trial.empty()) {
    throw InputError(fmt::format("{}: static_trial: this format has no static trial", file));
  }
  if (!files.name_map.empty()) {
    throw InputError(
        fmt::format("{}: names: the names of this format are known; remove names", file));
  }
  TrackerFrame frame;
  frame.unit_m = resolve_unit_m(unit, files.conventions, file, reports);
  const std::string& given = files.conventions.axes;
  if (given.empty() && !because.empty())
    reports.push_back(fmt::format("axes '{}': {}", axes, because));
  frame.world_from_file = world_from_recorded(given.empty() ? axes : given, file);
  return frame;
}

RecordedHand unseen_hand(std::size_t rows) {
  return {Array2D<Vec3>(rows, kKeypointCount, unknown_point()), {}, {}};
}

void add_time(double time_s, const std::string& file, std::size_t line, const std::string& key,
              std::vector<double>& time) {
  if (!time.empty() && !(time_s > time.back())) {
    throw InputError(
        fmt::format("{}:{}: {}: must be greater than in the previous row", file, line, key));
  }
  time.push_back(time_s);
}

void add_tracked_clip(HandClip&& clip, const RecordingFiles& files, Demonstration& demonstration) {
  std::vector<std::string>& reports = demonstration.import_notes;
  drop_unseen(clip, reports);
  if (!clip.hands[0] && !clip.hands[1] && clip.body.names.empty()) {
    throw InputError(fmt::format("{}: no hand is visible in any frame", files.file.string()));
  }
  check_hands(files.file.string(), clip, files.conventions.plausibility_checks, reports);
  check_world(clip, reports);
  add_clip(std::move(clip), demonstration);
}

void add_shape(HandClip&& clip, const RecordingFiles& files, const std::string& why,
               Demonstration& demonstration) {
  std::vector<std::string>& reports = demonstration.import_notes;
  drop_unseen(clip, reports);
  Side side = files.hand;
  if (!clip.hands[static_cast<std::size_t>(side)]) {
    side = side == Side::right ? Side::left : Side::right;
  }
  auto& hand = clip.hands[static_cast<std::size_t>(side)];
  if (!hand)
    throw InputError(fmt::format("{}: no hand is visible in any frame", files.file.string()));
  check_hands(files.file.string(), clip, files.conventions.plausibility_checks, reports);
  reports.push_back(fmt::format("{}: only the shape of the {} hand is used, not its position", why,
                                name_of(side)));
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
  reports.push_back(fmt::format(
      "object {}: only its pose was recorded; assumed a ball of {:.0f} mm diameter at its origin; "
      "set `target.body` in a config for its shape",
      name, 2000 * kPlaceholderRadius_m));
  return ball;
}

}  // namespace morphe::imports
