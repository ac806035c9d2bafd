#include "pipeline/synthesize/ground_truth_labels.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::synthesize {
namespace {

constexpr double kBoundarySpeedShare = 0.05, kPreshapeApertureShare = 0.1;

struct Span {
  double begin_s = 0, end_s = 0, peak_s = 0;
};

/// Returns the time between samples i - 1 and i at which a signal, linear there, crosses a level.
double crossing_time(const MotionSamples& samples, const std::vector<double>& signal,
                     std::ptrdiff_t i, double level) {
  const double share = (level - signal[i - 1]) / (signal[i] - signal[i - 1]);
  return samples.time(i - 1) + share / samples.rate_hz;
}

std::vector<double> index_speed(const MotionSamples& samples) {
  const std::vector<Vec3>& tip = samples.index_without_tremor;
  std::vector<double> speed(samples.size(), 0);
  for (int i = 1; i + 1 < samples.size(); ++i)
    speed[i] = (tip[i + 1] - tip[i - 1]).norm() * 0.5 * samples.rate_hz;
  return speed;
}

std::ptrdiff_t sample_at(const MotionSamples& samples, double time_s) {
  return std::min(std::lround(time_s * samples.rate_hz), samples.size() - 1);
}

/// Returns the interval within samples [first, last] in which the speed is above 5 % of its peak.
Span span_of(const MotionSamples& samples, const std::vector<double>& speed, std::ptrdiff_t first,
             std::ptrdiff_t last) {
  const auto begin = speed.begin();
  const auto peak = std::max_element(begin + first, begin + last + 1);
  const double level = kBoundarySpeedShare * *peak;
  std::ptrdiff_t i = first, k = last;
  while (speed[i] < level) ++i;
  while (speed[k] < level) --k;
  return {i > first ? crossing_time(samples, speed, i, level) : samples.time(i),
          k < last ? crossing_time(samples, speed, k + 1, level) : samples.time(k),
          samples.time(peak - begin)};
}

/// Returns the interval of each scripted phase of all movements, in order.
std::vector<Span> spans_of(const Script& script, const MotionSamples& samples) {
  const std::vector<double> speed = index_speed(samples);
  std::vector<ScriptedPhase> phases;
  for (const ScriptedMovement& movement : script.movements)
    phases.insert(phases.end(), movement.phases.begin(), movement.phases.end());
  std::vector<Span> spans;
  std::ptrdiff_t first = 0;
  for (int k = 0; k < std::ssize(phases); ++k) {
    std::ptrdiff_t last = samples.size() - 1;
    if (k + 1 < std::ssize(phases)) {
      const auto from = speed.begin() + sample_at(samples, phases[k].end_s);
      const auto to = speed.begin() + sample_at(samples, phases[k + 1].begin_s);
      last = std::min_element(from, to + 1) - speed.begin();
    }
    spans.push_back(span_of(samples, speed, first, last));
    first = last;
  }
  return spans;
}

double preshape_begin(const MotionSamples& samples, const Span& reach) {
  const std::ptrdiff_t first = sample_at(samples, reach.begin_s);
  const std::ptrdiff_t last = sample_at(samples, reach.end_s);
  const std::vector<double>& opening = samples.aperture;
  const double widest = *std::max_element(opening.begin() + first, opening.begin() + last + 1);
  const double level = opening[first] + kPreshapeApertureShare * (widest - opening[first]);
  std::ptrdiff_t i = first;
  while (opening[i] < level) ++i;
  return i > first ? crossing_time(samples, opening, i, level) : reach.begin_s;
}

class Labels {
 public:
  Labels(double begin_s, double end_s) : begin_s_(begin_s), end_s_(end_s) {}
  void add(PhaseKind phase, double from_s, double to_s) {
    const double from = std::max(from_s, begin_s_), to = std::min(to_s, end_s_);
    if (to > from) labels.push_back({from - begin_s_, to - begin_s_, phase});
  }
  bool contains(double time_s) const { return time_s >= begin_s_ && time_s <= end_s_; }

  std::vector<Label> labels;

 private:
  double begin_s_, end_s_;
};

}  // namespace

std::vector<Label> ground_truth_labels(const Script& script, const MotionSamples& samples) {
  const std::vector<Span> spans = spans_of(script, samples);
  Labels out(script.begin_s, script.end_s);
  std::ptrdiff_t next = 0;
  for (const ScriptedMovement& movement : script.movements) {
    const Span& reach = spans[next];
    if (out.contains(reach.peak_s)) {
      out.add(PhaseKind::reach, reach.begin_s, reach.end_s);
      if (movement.grasps)
        out.add(PhaseKind::preshape, preshape_begin(samples, reach), reach.end_s);
    }
    PhaseKind pause = movement.grasps ? PhaseKind::grasp : PhaseKind::hold;
    for (int k = 1; k < std::ssize(movement.phases); ++k) {
      const Span &before = spans[next + k - 1], &span = spans[next + k];
      out.add(pause, before.end_s, span.begin_s);
      out.add(movement.phases[k].phase, span.begin_s, span.end_s);
      pause = PhaseKind::hold;
    }
    next += std::ssize(movement.phases);
  }
  return std::move(out.labels);
}

}  // namespace morphe::synthesize
