#include "stages/segment/signals.hpp"

#include <algorithm>
#include <cmath>

namespace morphe {
namespace {

constexpr std::size_t kThumb = 0, kIndex = 1, kLeastFrames = 10;

bool is_seen(double value) { return std::isfinite(value); }
bool is_seen(const Vec3& point) { return seen(point); }

/// Bridges gaps linearly and holds the first and last value seen; false if there is none.
template <class T>
bool bridge_gaps(std::vector<T>& values) {
  std::size_t last = values.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!is_seen(values[i])) continue;
    const T from = last == values.size() ? values[i] : values[last];
    const std::size_t begin = last == values.size() ? 0 : last + 1;
    const double span = last == values.size() ? 1.0 : static_cast<double>(i - last);
    for (std::size_t k = begin; k < i; ++k) {
      const double share = last == values.size() ? 0.0 : static_cast<double>(k - last) / span;
      values[k] = T((1 - share) * from + share * values[i]);
    }
    last = i;
  }
  if (last == values.size()) return false;
  for (std::size_t k = last + 1; k < values.size(); ++k) values[k] = values[last];
  return true;
}

/// Gaussian average over what is there (weights are normalised, so that ends are not pulled down).
template <class T>
std::vector<T> smoothed(const std::vector<T>& values, double sigma_frames, const T& zero,
                        const T& unseen) {
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3 * sigma_frames));
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  std::vector<T> result(values.size(), unseen);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    if (!is_seen(values[static_cast<std::size_t>(i)])) continue;
    T sum = zero;
    double weights = 0;
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, i - reach);
         k <= std::min(count - 1, i + reach); ++k) {
      const T& value = values[static_cast<std::size_t>(k)];
      if (!is_seen(value)) continue;
      const double away = sigma_frames > 0 ? static_cast<double>(k - i) / sigma_frames : 0;
      const double weight = std::exp(-0.5 * away * away);
      sum += weight * value;
      weights += weight;
    }
    result[static_cast<std::size_t>(i)] = sum / weights;
  }
  return result;
}

/// Central difference, one-sided at the ends and beside a gap; unseen where only one point is.
Vec3 velocity_at(const std::vector<Vec3>& points, std::size_t i, double step_s) {
  if (!seen(points[i])) return unseen_point();
  const std::size_t before = i > 0 && seen(points[i - 1]) ? i - 1 : i;
  const std::size_t after = i + 1 < points.size() && seen(points[i + 1]) ? i + 1 : i;
  if (before == after) return unseen_point();
  return (points[after] - points[before]) / (static_cast<double>(after - before) * step_s);
}

}  // namespace

std::size_t HandSignals::frame(double time_s) const {
  const double at = std::round((time_s - begin_s) / step_s);
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(frames() - 1)));
}

HandSignals hand_signals(const HumanMotion& motion, double smoothing_s) {
  const std::size_t n = motion.time.size();
  const bool has_tips = motion.tip.rows == n && motion.tip.cols > kIndex;
  const bool has_wrist = motion.wrist.size() == n;
  if (n < kLeastFrames || (!has_tips && !has_wrist)) return {};
  HandSignals signals;
  signals.begin_s = motion.time.front();
  signals.step_s = (motion.time.back() - motion.time.front()) / static_cast<double>(n - 1);
  if (!(signals.step_s > 0) || !std::isfinite(signals.step_s)) return {};

  std::vector<Vec3> tip(n, unseen_point()), wrist(n, unseen_point());
  std::vector<double> opening(n, kNotSeen);
  std::size_t tips_seen = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (has_tips) tip[i] = motion.tip(i, kIndex);
    if (has_tips) opening[i] = (motion.tip(i, kThumb) - tip[i]).norm();
    if (has_wrist) wrist[i] = motion.wrist[i];
    tips_seen += seen(tip[i]) ? 1 : 0;
    signals.seen.push_back(seen(tip[i]) || seen(wrist[i]));
  }
  std::vector<Vec3> velocity(n);
  for (std::size_t i = 0; i < n; ++i) {
    velocity[i] = velocity_at(tip, i, signals.step_s);
    if (!seen(velocity[i])) velocity[i] = velocity_at(wrist, i, signals.step_s);
  }
  const double sigma = smoothing_s / signals.step_s;
  const Vec3 zero = Vec3::Zero();
  velocity = smoothed(velocity, sigma, zero, unseen_point());
  signals.position = 2 * tips_seen >= n ? tip : wrist;
  std::vector<double> speed(n);
  for (std::size_t i = 0; i < n; ++i) speed[i] = velocity[i].norm();
  if (!bridge_gaps(speed) || !bridge_gaps(signals.position)) return {};
  signals.speed = std::move(speed);
  opening = smoothed(opening, sigma, 0.0, kNotSeen);
  if (bridge_gaps(opening)) signals.opening = std::move(opening);
  return signals;
}

}  // namespace morphe
