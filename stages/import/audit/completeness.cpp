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

/// Returns the highest speed of the motion to which the window of frames at an edge belongs: from
/// there on, until the speed has fallen to a share of the highest one.
double peak_at_edge(const Track& track, const std::vector<double>& time, std::ptrdiff_t first,
                    std::ptrdiff_t width, bool at_begin) {
  double peak = speed_in(track, time, first, first + width);
  const std::ptrdiff_t step = at_begin ? 1 : -1;
  for (std::ptrdiff_t frame = first; frame >= 0 && frame + width < std::ssize(time);
       frame += step) {
    const double speed = speed_in(track, time, frame, frame + width);
    if (speed < kMotionEndShare * peak && peak > kMinEdgeSpeed_m_s) break;
    peak = std::fmax(peak, speed);
  }
  return peak;
}

/// Returns the highest speed of the wrist, or of a fingertip, of a hand at rest whose motion has
/// this peak.
double rest_speed(bool is_wrist, double peak) {
  return std::fmax(is_wrist ? kMinEdgeSpeed_m_s : kMinEdgeTipSpeed_m_s, kMaxEdgeSpeedShare * peak);
}

/// Returns the first time up to which the hand has rested for kMinRest_s; infinity if it never has.
double rested_at(const Track& track, const std::vector<double>& time, std::ptrdiff_t width,
                 double rest_m_s) {
  double rest_begin_s = kUnknown;
  for (std::ptrdiff_t frame = 0; frame + width < std::ssize(time); ++frame) {
    const bool rests = speed_in(track, time, frame, frame + width) <= rest_m_s;
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
      "the recording {} while the hand moves at {:.2f} m/s, {:.0f} % of the highest speed of this "
      "motion (at rest: at most {:.0f} %){}: no complete reach; record it from rest to rest",
      at_begin ? "begins" : "ends", speed, 100 * flag.value, 100 * kMaxEdgeSpeedShare,
      at_begin ? " and has not rested before the movement" : "");
  return flag;
}

/// Returns a flag if the wrist, the first of the tracks, or else a fingertip moves in the window
/// from `first` to `last`, at an edge of what was seen.
std::optional<RecordingFlag> motion_at_edge(const AuditedMovement& audited,
                                            const std::vector<Track>& tracks, std::ptrdiff_t first,
                                            std::ptrdiff_t last, bool at_begin) {
  const std::vector<double>& time = audited.motion.time;
  for (const Track& track : tracks) {
    const double speed = speed_in(track, time, first, last);
    const double peak = peak_at_edge(track, time, first, last - first, at_begin);
    const double rest_m_s = rest_speed(&track == &tracks.front(), peak);
    if (std::isnan(speed)) continue;
    if (!(speed > rest_m_s)) return std::nullopt;
    const bool rested =
        at_begin && rested_at(track, time, last - first, rest_m_s) <= audited.movement.begin_s;
    if (rested) return std::nullopt;
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
  if (seen.last < seen.first + width) return {};
  std::vector<RecordingFlag> flags;
  const auto add = [&](std::optional<RecordingFlag> flag) {
    if (flag) flags.push_back(std::move(*flag));
  };
  add(motion_at_edge(audited, tracks, seen.first, seen.first + width, true));
  if (audited.movement.end_s < time[seen.last] - kEdgeWindow_s) return flags;
  add(motion_at_edge(audited, tracks, seen.last - width, seen.last, false));
  return flags;
}

}  // namespace morphe::imports
