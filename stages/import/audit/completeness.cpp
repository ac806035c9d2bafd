#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/movement_checks.hpp"

namespace morphe::imports {
namespace {

/// The track of a point of the hand.
using Track = std::vector<Vec3>;

/// The frames in which the hand was seen, and those of the movement.
struct SeenFrames {
  std::ptrdiff_t first = 0, last = -1;
};

Track tip_track(const HumanMotion& motion, std::size_t finger) {
  Track track;
  for (std::size_t frame = 0; frame < motion.time.size(); ++frame)
    track.push_back(motion.tip(frame, finger));
  return track;
}

/// Returns the wrist, then the fingertips.
std::vector<Track> hand_tracks(const HumanMotion& motion) {
  std::vector<Track> tracks{motion.wrist};
  for (std::size_t finger = 0; finger < motion.tip.cols; ++finger)
    tracks.push_back(tip_track(motion, finger));
  return tracks;
}

SeenFrames seen_frames(const std::vector<Track>& tracks, std::ptrdiff_t frames) {
  const auto seen = [&](std::ptrdiff_t frame) {
    return std::ranges::any_of(tracks, [&](const Track& track) { return is_known(track[frame]); });
  };
  SeenFrames range{frames, -1};
  for (std::ptrdiff_t frame = 0; frame < frames; ++frame) {
    if (!seen(frame)) continue;
    range.first = std::min(range.first, frame);
    range.last = frame;
  }
  return range;
}

/// Returns the mean speed in a window of frames; NaN if the point was not seen at its ends.
double speed_in(const Track& track, const std::vector<double>& time, std::ptrdiff_t first,
                std::ptrdiff_t last) {
  if (first < 0 || last >= std::ssize(track) || first >= last) return kUnknown;
  return (track[last] - track[first]).norm() / (time[last] - time[first]);
}

/// Returns the highest speed in a window of `width` frames within the movement, or NaN.
double peak_speed(const Track& track, const AuditedMovement& audited, std::ptrdiff_t width) {
  const std::vector<double>& time = audited.motion.time;
  double peak = kUnknown;
  for (std::ptrdiff_t frame = 0; frame + width < std::ssize(time); ++frame) {
    const bool inside = time[frame] >= audited.movement.begin_s - kEdgeWindow_s &&
                        time[frame + width] <= audited.movement.end_s + kEdgeWindow_s;
    if (inside) peak = std::fmax(peak, speed_in(track, time, frame, frame + width));
  }
  return peak;
}

/// Returns the highest speed of a hand at rest in a movement with this peak.
double rest_speed(double peak) { return std::fmax(kMinEdgeSpeed_m_s, kMaxEdgeSpeedShare * peak); }

/// Returns the first time up to which the hand has rested for kMinRest_s; infinity if it never has.
double rested_at(const Track& track, const std::vector<double>& time, std::ptrdiff_t width,
                 double peak) {
  double rest_begin_s = kUnknown;
  for (std::ptrdiff_t frame = 0; frame + width < std::ssize(time); ++frame) {
    const bool rests = speed_in(track, time, frame, frame + width) <= rest_speed(peak);
    if (!rests) {
      rest_begin_s = kUnknown;
      continue;
    }
    rest_begin_s = std::fmin(rest_begin_s, time[frame]);
    if (time[frame + width] - rest_begin_s >= kMinRest_s) return time[frame + width];
  }
  return kInfinity;
}

RecordingFlag incomplete(bool at_begin, double time_s, double speed, double peak) {
  RecordingFlag flag{.code = FlagCode::incomplete_movement,
                     .begin_s = time_s,
                     .end_s = time_s,
                     .value = speed / peak,
                     .limit = kMaxEdgeSpeedShare,
                     .unit = "1"};
  flag.text = fmt::format(
      "the recording {} while the hand moves at {:.2f} m/s, {:.0f} % of the highest speed of the "
      "movement (at rest: at most {:.0f} %){}: no complete reach; record it from rest to rest",
      at_begin ? "begins" : "ends", speed, 100 * flag.value, 100 * kMaxEdgeSpeedShare,
      at_begin ? " and has not rested before the movement" : "");
  return flag;
}

/// Returns a flag if the hand moves in the window from `first` to `last`, at an edge of what was
/// seen. It is measured by the first track that was seen there.
std::optional<RecordingFlag> motion_at_edge(const AuditedMovement& audited,
                                            const std::vector<Track>& tracks, std::ptrdiff_t first,
                                            std::ptrdiff_t last, bool at_begin) {
  const std::vector<double>& time = audited.motion.time;
  for (const Track& track : tracks) {
    const double speed = speed_in(track, time, first, last);
    if (std::isnan(speed)) continue;
    const double peak = peak_speed(track, audited, last - first);
    const bool rested =
        at_begin && rested_at(track, time, last - first, peak) <= audited.movement.begin_s;
    if (rested || !(speed > rest_speed(peak))) return std::nullopt;
    return incomplete(at_begin, time[at_begin ? first : last], speed, peak);
  }
  return std::nullopt;
}

}  // namespace

std::vector<RecordingFlag> check_completeness(const AuditedMovement& audited,
                                              const AuditOptions& /*options*/) {
  const std::vector<double>& time = audited.motion.time;
  if (audited.movement.phases.empty() || time.size() < 2) return {};
  const std::vector<Track> tracks = hand_tracks(audited.motion);
  const SeenFrames seen = seen_frames(tracks, std::ssize(time));
  const auto width = std::max<std::ptrdiff_t>(1, std::lround(kEdgeWindow_s / (time[1] - time[0])));
  std::vector<RecordingFlag> flags;
  const auto add = [&](std::ptrdiff_t first, bool at_begin) {
    if (auto flag = motion_at_edge(audited, tracks, first, first + width, at_begin))
      flags.push_back(std::move(*flag));
  };
  if (seen.last < seen.first + width) return {};
  add(seen.first, true);
  if (audited.movement.end_s >= time[seen.last] - kEdgeWindow_s) add(seen.last - width, false);
  return flags;
}

}  // namespace morphe::imports
