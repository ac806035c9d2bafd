#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/math/low_pass.hpp"
#include "core/math/statistics.hpp"
#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/point_streams.hpp"
#include "stages/import/guess/constants.hpp"
#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {
namespace {

/// The motion of a hand while it moves.
struct Tempo {
  double acceleration_m_s2 = 0;  ///< root mean square
  double frequency_hz = 0;       ///< rms acceleration over rms speed and 2 pi
};

/// A track without gaps: unseen points are copies of the seen ones before or after them.
struct FilledTrack {
  std::vector<Vec3> points;
  std::vector<bool> judged;  ///< false near unseen points and near moments of other doubts
};

FilledTrack fill(const std::vector<Vec3>& track, const std::vector<double>& time,
                 const std::vector<RecordingFlag>& flags) {
  FilledTrack filled{track, std::vector<bool>(track.size(), true)};
  const double period_s = median_period(time);
  const auto leave_out = [&](double begin_s, double end_s) {
    const auto begin = std::ranges::lower_bound(time, begin_s - kDoubtMargin_s) - time.begin();
    const auto end = std::ranges::upper_bound(time, end_s + kDoubtMargin_s) - time.begin();
    for (auto i = begin; i < end; ++i) filled.judged[i] = false;
  };
  for (std::size_t i = 0; i < track.size(); ++i) {
    if (!is_known(track[i])) leave_out(time[i], time[i]);
    if (i > 0 && time[i] - time[i - 1] > kMaxTempoStep * period_s) leave_out(time[i - 1], time[i]);
    if (i > 0 && !is_known(filled.points[i])) filled.points[i] = filled.points[i - 1];
  }
  for (std::size_t i = track.size() - 1; i > 0; --i) {
    if (!is_known(filled.points[i - 1])) filled.points[i - 1] = filled.points[i];
  }
  for (const RecordingFlag& flag : flags) {
    if (flag.code == FlagCode::lost_rows || flag.code == FlagCode::step)
      leave_out(flag.begin_s, flag.begin_s);
  }
  return filled;
}

std::vector<Vec3> smoothed(const std::vector<Vec3>& track, double rate_hz) {
  if (rate_hz < 2.1 * kTempoFilter_hz) return track;
  std::vector<Vec3> smooth = track;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Vec3& point : track) values.push_back(point[axis]);
    const std::vector<double> filtered = math::low_pass_filter(values, rate_hz, kTempoFilter_hz);
    for (std::size_t i = 0; i < track.size(); ++i) smooth[i][axis] = filtered[i];
  }
  return smooth;
}

/// Returns the track of the hand, or else of the wrist, that is seen most of the time; empty if
/// there is none.
std::vector<Vec3> hand_track(const RecordedPoints& points, const std::string& side) {
  for (const char* part : {" hand", " wrist", " forearm"}) {
    std::vector<Vec3> track = mean_track(points, side + part);
    const auto seen = std::ranges::count_if(track, [](const Vec3& p) { return is_known(p); });
    if (2 * seen > std::ssize(track)) return track;
  }
  return {};
}

/// Returns the diagonal of the box around a track; 0 if it is never seen.
double extent_of(const std::vector<Vec3>& track) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : track) {
    if (is_known(point)) box.extend(point);
  }
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

Tempo tempo_of(const FilledTrack& track, double period_s) {
  const std::vector<Vec3> smooth = smoothed(track.points, 1 / period_s);
  std::vector<double> speed, acceleration;
  for (std::size_t i = 1; i + 1 < smooth.size(); ++i) {
    if (!track.judged[i]) continue;
    const Vec3 step = smooth[i + 1] - smooth[i], before = smooth[i] - smooth[i - 1];
    speed.push_back((step + before).norm() / (2 * period_s));
    acceleration.push_back((step - before).norm() / (period_s * period_s));
  }
  if (speed.size() < kMinJudgedRows) return {};
  const double moving = kMovingShare * math::quantile(speed, 1);
  double speed_square = 0, acceleration_square = 0, count = 0;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    if (speed[i] < moving) continue;
    speed_square += speed[i] * speed[i];
    acceleration_square += acceleration[i] * acceleration[i];
    ++count;
  }
  if (!(speed_square > 0)) return {};
  return {std::sqrt(acceleration_square / count),
          std::sqrt(acceleration_square / speed_square) / (2 * std::numbers::pi)};
}

/// Returns the usual rate at which the hand would move most nearly like those at a table.
double likely_rate(const FilledTrack& track) {
  const auto misfit = [&](double rate_hz) {
    return std::abs(std::log(tempo_of(track, 1 / rate_hz).frequency_hz / kTableFrequency_hz));
  };
  return *std::ranges::min_element(kUsualRates_hz, {}, misfit);
}

}  // namespace

std::vector<Doubt> check_time_base(const Demonstration& recording, const AuditInput& input) {
  if (input.rate_given) return {};
  const RecordedPoints points = recorded_points(recording.streams, recording.hand);
  if (points.time.size() < kMinJudgedRows) return {};
  const double period_s = median_period(points.time);
  const std::string side(name_of(recording.hand));
  const std::vector<Vec3> hand = hand_track(points, side);
  if (hand.empty() || extent_of(hand) < kMinTempoExtent_m || !(period_s > 0)) return {};
  const double shoulder_m = extent_of(mean_track(points, side + " shoulder"));
  const bool at_table = shoulder_m > 0 && shoulder_m < kMaxSeatedShoulder_m;
  const FilledTrack track = fill(hand, points.time, recording.flags);
  const Tempo tempo = tempo_of(track, period_s);
  const double limit = at_table ? kMaxTableAcceleration_m_s2 : kMaxAcceleration_m_s2;
  const bool strong = tempo.acceleration_m_s2 > limit;
  const bool quick = at_table && tempo.frequency_hz > kQuickFrequency_hz &&
                     tempo.acceleration_m_s2 > kQuickAcceleration_m_s2;
  const bool slow =
      at_table && tempo.frequency_hz > 0 && tempo.frequency_hz < kMinTableFrequency_hz;
  if (!strong && !quick && !slow) return {};
  const double rate_hz = 1 / period_s, likely_hz = likely_rate(track);
  Doubt doubt;
  doubt.flag.code = FlagCode::time_base;
  doubt.flag.subject = side + " hand";
  const bool fast = strong || quick;
  doubt.flag.value = fast ? tempo.acceleration_m_s2 : tempo.frequency_hz;
  doubt.flag.limit = strong ? limit : quick ? kQuickAcceleration_m_s2 : kMinTableFrequency_hz;
  doubt.flag.unit = fast ? "m/s2" : "Hz";
  doubt.flag.text = fmt::format(
      "the {} moves {} than people {}: {:.1f} m/s2 and {:.2f} Hz (rms); are {:.4g} rows per second "
      "right? With --rate {:g} it would be usual; --rate {:.4g} confirms it",
      doubt.flag.subject, fast ? "faster" : "slower", at_table ? "at a table" : "do",
      tempo.acceleration_m_s2, tempo.frequency_hz, rate_hz, likely_hz, rate_hz);
  return {std::move(doubt)};
}

}  // namespace morphe::imports
