#include "stages/segment/signals.hpp"

#include <algorithm>
#include <cmath>

#include "stages/segment/constants.hpp"
#include "stages/segment/noise.hpp"

namespace morphe::segment {
namespace {

bool is_seen(double value) { return std::isfinite(value); }
bool is_seen(const Vec3& point) { return is_known(point); }

/// Returns the slope per frame over up to kSlopeFrames seen values before (step -1) or after (step
/// +1) a seen frame; 0 without any.
template <class T>
T slope_beside(const std::vector<T>& values, int frame, int step) {
  int far = frame;
  for (int k = 0; k < kSlopeFrames; ++k) {
    const int next = far + step;
    if (next < 0 || next >= std::ssize(values) || !is_seen(values[next])) break;
    far = next;
  }
  if (far == frame) return T(values[frame] - values[frame]);  // 0 of this type
  return T((values[far] - values[frame]) / (far - frame));
}

/// Bridges gaps by cubics with the slopes beside them (by straight lines if not `cubic`), and
/// extends the first and last seen value to the ends. Returns false if no value is seen.
template <class T>
bool bridge_gaps(std::vector<T>& values, bool cubic) {
  int last = -1;  // the last seen frame
  for (int i = 0; i < std::ssize(values); ++i) {
    if (!is_seen(values[i])) continue;
    if (last < 0) {
      std::fill_n(values.begin(), i, values[i]);
    } else if (i > last + 1) {
      const double span = i - last;
      const T chord = T((values[i] - values[last]) / span);
      const T start = cubic ? slope_beside(values, last, -1) : chord;
      const T end = cubic ? slope_beside(values, i, +1) : chord;
      for (int k = last + 1; k < i; ++k) {
        const double u = (k - last) / span;
        values[k] =
            T(values[last] +
              span * (u * chord + u * (1 - u) * ((1 - u) * (start - chord) - u * (end - chord))));
      }
    }
    last = i;
  }
  if (last < 0) return false;
  std::fill(values.begin() + last + 1, values.end(), values[last]);
  return true;
}

/// Returns the Gaussian average with normalised weights, so that the ends are not pulled down.
template <class T>
std::vector<T> smooth_gaussian(const std::vector<T>& values, double sigma_frames) {
  if (!(sigma_frames > 0)) return values;
  const long half_width = std::lround(std::ceil(3 * sigma_frames));
  const std::ptrdiff_t count = std::ssize(values);
  std::vector<double> weights;
  for (std::ptrdiff_t k = 0; k <= half_width; ++k) {
    const double deviate = static_cast<double>(k) / sigma_frames;
    weights.push_back(std::exp(-0.5 * deviate * deviate));
  }
  std::vector<T> result = values;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    T sum = weights[0] * values[i];
    double total = weights[0];
    const std::ptrdiff_t last = std::min(count - 1, i + half_width);
    for (std::ptrdiff_t k = i < half_width ? 0 : i - half_width; k <= last; ++k) {
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
  for (int i = 0; i < std::ssize(points); ++i) {
    const int before = i > 0 ? i - 1 : i, after = i + 1 < std::ssize(points) ? i + 1 : i;
    result[i] = (points[after] - points[before]) / ((after - before) * step_s);
  }
  return result;
}

/// Returns the index tip. While only the wrist is seen, it is the wrist plus the vector from wrist
/// to tip, interpolated in time; if no tip is ever seen, the wrist itself.
std::vector<Vec3> hand_positions(const HumanMotion& motion, bool has_tips) {
  const std::size_t n = motion.time.size();
  std::vector<Vec3> position = motion.wrist, tip_from_wrist(n, unknown_point());
  if (!has_tips) return position;
  for (std::size_t i = 0; i < n; ++i) tip_from_wrist[i] = motion.tip(i, kIndex) - motion.wrist[i];
  if (!bridge_gaps(tip_from_wrist, false)) return position;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3& tip = motion.tip(i, kIndex);
    position[i] = is_known(tip) ? tip : Vec3(position[i] + tip_from_wrist[i]);
  }
  return position;
}

/// Returns Σ v² / Σ v: the mean of the speed over the travelled distance, which rests do not
/// change.
double travel_speed(const std::vector<double>& speed) {
  double sum = 0, squares = 0;
  for (const double v : speed) {
    sum += v;
    squares += v * v;
  }
  return sum > 0 ? squares / sum : 0;
}

}  // namespace

int HandSignals::frame(double time_s) const {
  const double nearest = std::round((time_s - begin_s) / step_s);
  return static_cast<int>(std::clamp(nearest, 0.0, frames() - 1.0));
}

int HandSignals::frames_in(double duration_s) const {
  return static_cast<int>(std::min(duration_s / step_s, 2.0 * frames()));
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
  double widening = 1;
  for (;; widening = std::min(kMaxWideningFactor, widening * kWideningFactor)) {
    const std::vector<Vec3> smooth =
        smooth_gaussian(velocity, widening * smoothing_s / signals.step_s);
    signals.speed_noise = noise_rms(smooth, signals.step_s);
    const double noise = signals.speed_noise * signals.speed_noise;
    signals.speed.clear();
    for (const Vec3& v : smooth)
      signals.speed.push_back(std::sqrt(std::max(0.0, v.squaredNorm() - noise)));
    const double tolerable = kMaxNoiseShare * travel_speed(signals.speed);
    if (signals.speed_noise <= tolerable || widening >= kMaxWideningFactor || !(smoothing_s > 0))
      break;
  }
  if (has_tips) {
    std::vector<double> opening(n);
    for (std::size_t i = 0; i < n; ++i)
      opening[i] = (motion.tip(i, kThumb) - motion.tip(i, kIndex)).norm();
    if (bridge_gaps(opening, false)) {
      signals.aperture = smooth_gaussian(opening, widening * smoothing_s / signals.step_s);
      signals.aperture_noise = noise_rms(signals.aperture, signals.step_s);
    }
  }
  return signals;
}

}  // namespace morphe::segment
