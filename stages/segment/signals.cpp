#include "stages/segment/signals.hpp"

#include <algorithm>
#include <cmath>

#include "stages/segment/noise.hpp"

namespace morphe::segment {
namespace {

constexpr std::size_t kThumb = 0, kIndex = 1, kMinFrames = 10;
/// Frames over which the velocity beside a gap is measured.
constexpr std::size_t kSlopeFrames = 5;
constexpr double kMaxNoiseShare = 0.02;  ///< share of the travel speed
constexpr double kWideningFactor = 1.5, kMaxWideningFactor = 4;

bool is_seen(double value) { return std::isfinite(value); }
bool is_seen(const Vec3& point) { return is_known(point); }

/// Returns the slope per frame of the run of seen values that ends (step -1) or begins (step +1) at
/// `at`.
template <class T>
T slope_beside(const std::vector<T>& values, std::size_t at, int step) {
  std::size_t far = at;
  for (std::size_t k = 0; k < kSlopeFrames; ++k) {
    const auto next = static_cast<std::size_t>(far + step);
    if (next >= values.size() || !is_seen(values[next])) break;
    far = next;
  }
  if (far == at) return T(values[at] - values[at]);
  return T((values[far] - values[at]) / (static_cast<double>(far) - static_cast<double>(at)));
}

/// Bridges gaps by cubics with the slopes beside them (by straight lines if not `cubic`), and
/// extends the first and last seen value. Returns false if no value is seen.
template <class T>
bool bridge_gaps(std::vector<T>& values, bool cubic) {
  std::size_t last = values.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!is_seen(values[i])) continue;
    if (last == values.size()) {
      for (std::size_t k = 0; k < i; ++k) values[k] = values[i];
    } else if (i > last + 1) {
      const double span = static_cast<double>(i - last);
      const T chord = T((values[i] - values[last]) / span);
      const T from = cubic ? slope_beside(values, last, -1) : chord;
      const T to = cubic ? slope_beside(values, i, +1) : chord;
      for (std::size_t k = last + 1; k < i; ++k) {
        const double u = static_cast<double>(k - last) / span;
        values[k] =
            T(values[last] +
              span * (u * chord + u * (1 - u) * ((1 - u) * (from - chord) - u * (to - chord))));
      }
    }
    last = i;
  }
  if (last == values.size()) return false;
  for (std::size_t k = last + 1; k < values.size(); ++k) values[k] = values[last];
  return true;
}

/// Returns the Gaussian average with normalised weights, so that the ends are not pulled down.
template <class T>
std::vector<T> smooth_gaussian(const std::vector<T>& values, double sigma_frames) {
  if (!(sigma_frames > 0)) return values;
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3 * sigma_frames));
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  std::vector<double> weights;
  for (std::ptrdiff_t k = 0; k <= reach; ++k) {
    const double away = static_cast<double>(k) / sigma_frames;
    weights.push_back(std::exp(-0.5 * away * away));
  }
  std::vector<T> result = values;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    T sum = weights[0] * values[i];
    double total = weights[0];
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, i - reach);
         k <= std::min(count - 1, i + reach); ++k) {
      if (k == i) continue;
      const double weight = weights[std::abs(k - i)];
      sum += weight * values[k];
      total += weight;
    }
    result[i] = sum / total;
  }
  return result;
}

std::vector<Vec3> velocities(const std::vector<Vec3>& points, double step_s) {
  std::vector<Vec3> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, points.size() - 1);
    result[i] = (points[after] - points[before]) / (static_cast<double>(after - before) * step_s);
  }
  return result;
}

/// Returns the index tip; while only the wrist is seen, the wrist plus the interpolated offset from
/// it to the tip.
std::vector<Vec3> hand_positions(const HumanMotion& motion, bool has_tips) {
  const std::size_t n = motion.time.size();
  std::vector<Vec3> position = motion.wrist, from_wrist(n, unknown_point());
  if (!has_tips) return position;
  for (std::size_t i = 0; i < n; ++i) from_wrist[i] = motion.tip(i, kIndex) - motion.wrist[i];
  if (!bridge_gaps(from_wrist, false)) return position;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3& tip = motion.tip(i, kIndex);
    position[i] = is_known(tip) ? tip : Vec3(position[i] + from_wrist[i]);
  }
  return position;
}

/// Returns sum v^2 / sum v: the mean speed per travelled distance, independent of rests.
double travel_speed(const std::vector<double>& speed) {
  double sum = 0, squares = 0;
  for (const double v : speed) {
    sum += v;
    squares += v * v;
  }
  return sum > 0 ? squares / sum : 0;
}

}  // namespace

std::size_t HandSignals::frame(double time_s) const {
  const double at = std::round((time_s - begin_s) / step_s);
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(frames() - 1)));
}

HandSignals hand_signals(const HumanMotion& motion, double smoothing_s) {
  const std::size_t n = motion.time.size();
  const bool has_tips = motion.tip.rows == n && motion.tip.cols > kIndex;
  if (n < kMinFrames || motion.wrist.size() != n) return {};
  HandSignals signals;
  signals.begin_s = motion.time.front();
  signals.step_s = (motion.time.back() - motion.time.front()) / static_cast<double>(n - 1);
  if (!(signals.step_s > 0) || !std::isfinite(signals.step_s)) return {};
  signals.position = hand_positions(motion, has_tips);
  for (const Vec3& point : signals.position) signals.seen.push_back(is_known(point));
  signals.wrist = motion.wrist;
  if (!bridge_gaps(signals.position, true) || !bridge_gaps(signals.wrist, true)) return {};
  const std::vector<Vec3> velocity = velocities(signals.position, signals.step_s);
  double wider = 1;
  for (;; wider = std::min(kMaxWideningFactor, wider * kWideningFactor)) {
    const std::vector<Vec3> smooth =
        smooth_gaussian(velocity, wider * smoothing_s / signals.step_s);
    signals.speed_noise = noise_rms(smooth, signals.step_s);
    const double noise = signals.speed_noise * signals.speed_noise;
    signals.speed.clear();
    for (const Vec3& v : smooth) {
      signals.speed.push_back(std::sqrt(std::max(0.0, v.squaredNorm() - noise)));
    }
    const double tolerable = kMaxNoiseShare * travel_speed(signals.speed);
    if (signals.speed_noise <= tolerable || wider >= kMaxWideningFactor || !(smoothing_s > 0))
      break;
  }
  if (has_tips) {
    std::vector<double> opening(n);
    for (std::size_t i = 0; i < n; ++i) {
      opening[i] = (motion.tip(i, kThumb) - motion.tip(i, kIndex)).norm();
    }
    if (bridge_gaps(opening, false)) {
      signals.aperture = smooth_gaussian(opening, wider * smoothing_s / signals.step_s);
      signals.aperture_noise = noise_rms(signals.aperture, signals.step_s);
    }
  }
  return signals;
}

}  // namespace morphe::segment
