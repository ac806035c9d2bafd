#include "stages/reconstruct/time_grid.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/low_pass.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kTimeTolerance_s = 1e-9;  // [s]
// Recordings are far shorter (core/store/input_bounds.hpp); the limit protects memory.
constexpr double kMaxSamples = 1e8, kMaxOversampling = 1e5;

/// A natural cubic spline through the points of one run.
class Spline {
 public:
  Spline(std::vector<double> time, std::vector<double> value)
      : time_(std::move(time)), value_(std::move(value)), curvature_(time_.size(), 0.0) {
    const std::size_t n = time_.size();
    if (n < 3) return;
    // The tridiagonal system of the second derivatives is solved by forward elimination.
    std::vector<double> diagonal(n, 1.0), right(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double before = time_[i] - time_[i - 1], after = time_[i + 1] - time_[i];
      const double rise =
          (value_[i + 1] - value_[i]) / after - (value_[i] - value_[i - 1]) / before;
      const double factor = i == 1 ? 0.0 : before / diagonal[i - 1];
      diagonal[i] = 2 * (before + after) - factor * (i == 1 ? 0.0 : before);
      right[i] = 6 * rise - factor * right[i - 1];
    }
    for (std::size_t i = n - 2; i > 0; --i) {
      const double after = time_[i + 1] - time_[i];
      curvature_[i] = (right[i] - after * curvature_[i + 1]) / diagonal[i];
    }
  }

  double operator()(double t) const {
    if (time_.size() == 1) return value_.front();
    const auto above = std::upper_bound(time_.begin() + 1, time_.end() - 1, t);
    const auto i = static_cast<std::size_t>(above - time_.begin()) - 1;
    const double h = time_[i + 1] - time_[i];
    const double a = (time_[i + 1] - t) / h, b = (t - time_[i]) / h;
    return a * value_[i] + b * value_[i + 1] +
           ((a * a * a - a) * curvature_[i] + (b * b * b - b) * curvature_[i + 1]) * h * h / 6;
  }

  double begin() const { return time_.front(); }
  double end() const { return time_.back(); }

 private:
  std::vector<double> time_, value_, curvature_;
};

/// Returns splines through the seen samples, split at gaps that are too long to bridge.
std::vector<Spline> runs_of(const std::vector<double>& time, const std::vector<double>& values,
                            double max_gap_s) {
  std::vector<Spline> runs;
  std::vector<double> run_time, run_value;
  const auto close = [&] {
    if (run_time.size() > 1) runs.emplace_back(std::move(run_time), std::move(run_value));
    run_time.clear();
    run_value.clear();
  };
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    if (!run_time.empty() && time[i] - run_time.back() > max_gap_s + kTimeTolerance_s) close();
    run_time.push_back(time[i]);
    run_value.push_back(values[i]);
  }
  close();
  return runs;
}

}  // namespace

TimeGrid make_time_grid(const std::vector<const std::vector<double>*>& stream_times,
                        double rate_hz) {
  double begin = kUnknown, end = kUnknown;
  for (const std::vector<double>* time : stream_times) {
    if (time->empty()) continue;
    begin = std::fmin(begin, time->front());
    end = std::fmax(end, time->back());
  }
  if (!(end >= begin)) return {0, rate_hz, 0};
  const double steps = std::floor((end - begin + kTimeTolerance_s) * rate_hz);
  if (!(steps < kMaxSamples)) return {0, rate_hz, 0};
  return {begin, rate_hz, static_cast<std::size_t>(steps) + 1};
}

std::vector<double> resample(const std::vector<double>& time, const std::vector<double>& values,
                             const TimeGrid& clock, const ReconstructOptions& options) {
  std::vector<double> result(clock.count, kUnknown);
  if (time.size() < 2 || clock.count == 0 || !(time.back() > time.front())) return result;
  const double stream_rate = static_cast<double>(time.size() - 1) / (time.back() - time.front());
  const auto refine = static_cast<std::size_t>(
      std::clamp(std::ceil(stream_rate / clock.rate_hz - 1e-6), 1.0, kMaxOversampling));
  const double fine_rate = clock.rate_hz * static_cast<double>(refine);
  for (const Spline& run : runs_of(time, values, options.max_gap_s)) {
    const double first = std::ceil((run.begin() - kTimeTolerance_s - clock.start_s) * fine_rate);
    std::vector<double> samples;
    const auto begin = static_cast<std::size_t>(std::max(0.0, first));
    for (std::size_t i = begin; i / refine < clock.count; ++i) {
      const double t = clock.start_s + static_cast<double>(i) / fine_rate;
      if (t > run.end() + kTimeTolerance_s) break;
      samples.push_back(run(std::clamp(t, run.begin(), run.end())));
    }
    samples = math::low_pass_filter(samples, fine_rate, options.cutoff_hz);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if ((begin + i) % refine == 0) result[(begin + i) / refine] = samples[i];
    }
  }
  return result;
}

std::vector<Vec3> resample(const std::vector<double>& time, const std::vector<Vec3>& values,
                           const TimeGrid& clock, const ReconstructOptions& options) {
  std::vector<Vec3> result(clock.count, unknown_point());
  std::vector<double> column(values.size());
  for (Eigen::Index c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < values.size(); ++i) column[i] = values[i][c];
    const std::vector<double> filtered = resample(time, column, clock, options);
    for (std::size_t i = 0; i < filtered.size(); ++i) result[i][c] = filtered[i];
  }
  return result;
}

std::vector<Quat> resample(const std::vector<double>& time, const std::vector<Quat>& values,
                           const TimeGrid& clock, const ReconstructOptions& options) {
  std::vector<Quat> aligned = values;
  Quat last = unknown_rotation();
  for (Quat& rotation : aligned) {
    if (!is_known(rotation)) continue;
    if (is_known(last) && last.dot(rotation) < 0) rotation.coeffs() *= -1;
    last = rotation;
  }
  std::vector<Quat> result(clock.count, unknown_rotation());
  std::vector<double> column(aligned.size());
  for (Eigen::Index c = 0; c < 4; ++c) {
    for (std::size_t i = 0; i < aligned.size(); ++i) column[i] = aligned[i].coeffs()[c];
    const std::vector<double> filtered = resample(time, column, clock, options);
    for (std::size_t i = 0; i < filtered.size(); ++i) result[i].coeffs()[c] = filtered[i];
  }
  for (Quat& rotation : result) {
    if (is_known(rotation)) rotation.normalize();
  }
  return result;
}

}  // namespace morphe::reconstruct
