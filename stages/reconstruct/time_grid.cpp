#include "stages/reconstruct/time_grid.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/low_pass.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kTimeTolerance_s = 1e-9;
// Recordings are far shorter (core/store/input_bounds.hpp); the limit protects memory.
constexpr double kMaxSamples = 1e8, kMaxOversampling = 1e5;

/// A natural cubic spline through the points of one run.
class Spline {
 public:
  Spline(std::vector<double> time, std::vector<double> value)
      : time_(std::move(time)), value_(std::move(value)), curvature_(time_.size(), 0.0) {
    const std::ptrdiff_t n = std::ssize(time_);
    if (n < 3) return;
    // The tridiagonal system of the second derivatives is solved by forward elimination.
    std::vector<double> diagonal(n, 1.0), right(n, 0.0);
    for (std::ptrdiff_t i = 1; i + 1 < n; ++i) {
      const double step_before = time_[i] - time_[i - 1], step_after = time_[i + 1] - time_[i];
      const double rise =
          (value_[i + 1] - value_[i]) / step_after - (value_[i] - value_[i - 1]) / step_before;
      const double factor = i == 1 ? 0.0 : step_before / diagonal[i - 1];
      diagonal[i] = 2 * (step_before + step_after) - factor * (i == 1 ? 0.0 : step_before);
      right[i] = 6 * rise - factor * right[i - 1];
    }
    for (std::ptrdiff_t i = n - 2; i > 0; --i) {
      const double step_after = time_[i + 1] - time_[i];
      curvature_[i] = (right[i] - step_after * curvature_[i + 1]) / diagonal[i];
    }
  }

  double operator()(double t) const {
    if (time_.size() == 1) return value_.front();
    const auto above = std::upper_bound(time_.begin() + 1, time_.end() - 1, t);
    const std::ptrdiff_t i = above - time_.begin() - 1;
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
  for (int i = 0; i < std::ssize(time); ++i) {
    if (!std::isfinite(values[i])) continue;
    if (!run_time.empty() && time[i] - run_time.back() > max_gap_s + kTimeTolerance_s) close();
    run_time.push_back(time[i]);
    run_value.push_back(values[i]);
  }
  close();
  return runs;
}

}  // namespace

HumanMotion unseen_motion(const TimeGrid& clock) {
  HumanMotion motion;
  const int n = clock.count;
  for (int i = 0; i < n; ++i) motion.time.push_back(clock.at(i));
  motion.shoulder = motion.elbow = motion.wrist = std::vector<Vec3>(n, unknown_point());
  motion.wrist_orientation = std::vector<Quat>(n, unknown_rotation());
  motion.tip = motion.finger_joint = Array2D<Vec3>(n, kFingerCount, unknown_point());
  motion.tip_orientation = Array2D<Quat>(n, kFingerCount, unknown_rotation());
  return motion;
}

TimeGrid make_time_grid(const std::vector<const std::vector<double>*>& stream_times,
                        double rate_hz) {
  double begin = kUnknown, end = kUnknown;
  for (const std::vector<double>* time : stream_times) {
    if (time->empty()) continue;
    begin = std::fmin(begin, time->front());
    end = std::fmax(end, time->back());
  }
  if (!(end >= begin)) return {0, rate_hz, 0};
  const double step_count = std::floor((end - begin + kTimeTolerance_s) * rate_hz);
  if (!(step_count < kMaxSamples)) return {0, rate_hz, 0};
  return {begin, rate_hz, static_cast<int>(step_count) + 1};
}

std::vector<double> resample(const std::vector<double>& time, const std::vector<double>& values,
                             const TimeGrid& clock, const ReconstructOptions& options) {
  std::vector<double> result(clock.count, kUnknown);
  if (time.size() < 2 || clock.count == 0 || !(time.back() > time.front())) return result;
  const double stream_rate = static_cast<double>(time.size() - 1) / (time.back() - time.front());
  const double oversampling =
      std::clamp(std::ceil(stream_rate / clock.rate_hz - 1e-6), 1.0, kMaxOversampling);
  const std::ptrdiff_t refine = std::lround(oversampling);
  const double fine_rate = clock.rate_hz * oversampling;
  for (const Spline& run : runs_of(time, values, options.max_gap_s)) {
    const double first = std::ceil((run.begin() - kTimeTolerance_s - clock.start_s) * fine_rate);
    std::vector<double> samples;
    const std::ptrdiff_t begin = std::lround(std::max(0.0, first));
    for (std::ptrdiff_t i = begin; i / refine < clock.count; ++i) {
      const double t = clock.start_s + static_cast<double>(i) / fine_rate;
      if (t > run.end() + kTimeTolerance_s) break;
      samples.push_back(run(std::clamp(t, run.begin(), run.end())));
    }
    samples = math::low_pass_filter(samples, fine_rate, options.cutoff_hz);
    for (std::ptrdiff_t i = 0; i < std::ssize(samples); ++i) {
      if ((begin + i) % refine == 0) result[(begin + i) / refine] = samples[i];
    }
  }
  return result;
}

std::vector<Vec3> resample(const std::vector<double>& time, const std::vector<Vec3>& values,
                           const TimeGrid& clock, const ReconstructOptions& options) {
  std::vector<Vec3> result(clock.count, unknown_point());
  std::vector<double> column(values.size());
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < std::ssize(values); ++i) column[i] = values[i][c];
    const std::vector<double> filtered = resample(time, column, clock, options);
    for (int i = 0; i < std::ssize(filtered); ++i) result[i][c] = filtered[i];
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
  for (int c = 0; c < 4; ++c) {
    for (int i = 0; i < std::ssize(aligned); ++i) column[i] = aligned[i].coeffs()[c];
    const std::vector<double> filtered = resample(time, column, clock, options);
    for (int i = 0; i < std::ssize(filtered); ++i) result[i].coeffs()[c] = filtered[i];
  }
  for (Quat& rotation : result) {
    if (is_known(rotation)) rotation.normalize();
  }
  return result;
}

}  // namespace morphe::reconstruct
