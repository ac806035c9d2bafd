#include "pipeline/study/reconstruction_score.hpp"
#include "core/math/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

namespace morphe::study {
namespace {

constexpr std::size_t kIndex = 1;
/// True speed of the tip below which it is at rest [m/s].
constexpr double kMaxRestSpeed_m_s = 0.005;

/// The ground truth at any instant, linear between its samples.
class Truth {
 public:
  explicit Truth(const Demonstration& truth)
      : bodies_(*truth.streams.sensors),
        hand_(*truth.streams.hand),
        angles_(*truth.streams.arm_angles) {
    assert(hand_.time.size() == bodies_.time.size() && angles_.time.size() == bodies_.time.size());
  }

  /// Moves to a time. Returns false outside the recording.
  bool seek(double time_s) {
    const std::vector<double>& time = bodies_.time;
    if (time.size() < 2 || time_s < time.front() || time_s > time.back()) return false;
    const auto above = std::upper_bound(time.begin() + 1, time.end() - 1, time_s);
    row_ = (above - time.begin()) - 1;
    share_ = (time_s - time[row_]) / (time[row_ + 1] - time[row_]);
    return true;
  }
  Vec3 body(std::size_t k) const { return between(bodies_.position, k); }
  Vec3 tip(std::size_t finger) const { return between(hand_.position, finger); }
  Quat wrist_orientation() const {
    return bodies_.orientation(row_, 2).slerp(share_, bodies_.orientation(row_ + 1, 2));
  }
  double angle(std::size_t joint) const {
    const auto r = static_cast<Eigen::Index>(row_), c = static_cast<Eigen::Index>(joint);
    return (1 - share_) * angles_.angles(r, c) + share_ * angles_.angles(r + 1, c);
  }

 private:
  Vec3 between(const Array2D<Vec3>& table, std::size_t k) const {
    return (1 - share_) * table(row_, k) + share_ * table(row_ + 1, k);
  }
  const BodyStream& bodies_;
  const HandStream& hand_;
  const AngleStream& angles_;
  std::size_t row_ = 0;
  double share_ = 0;
};

/// Computes the speed between neighbouring points. The first value is repeated so that there is one
/// for each frame.
std::vector<double> speeds(const std::vector<Vec3>& points, double step_s) {
  std::vector<double> result(points.size(), 0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    result[i] = (points[i] - points[i - 1]).norm() / step_s;
  }
  if (result.size() > 1) result[0] = result[1];
  return result;
}

void compare_angles(const JointRows& rebuilt, std::size_t row, const Truth& truth,
                    std::size_t first, MeanSquare& score) {
  if (static_cast<Eigen::Index>(row) >= rebuilt.rows()) return;
  for (Eigen::Index j = 0; j < rebuilt.cols(); ++j) {
    score.add(rebuilt(row, j) - truth.angle(first + j));
  }
}

void compare_frame(const HumanMotion& motion, std::size_t i, const Truth& truth,
                   ReconstructionScore& score) {
  score.shoulder.add((motion.shoulder[i] - truth.body(0)).norm());
  score.elbow.add((motion.elbow[i] - truth.body(1)).norm());
  score.wrist.add((motion.wrist[i] - truth.body(2)).norm());
  const Quat orientation = motion.wrist_orientation[i];
  if (is_known(orientation))
    score.orientation.add(angle_between(orientation, truth.wrist_orientation()));
  bool all = is_known(motion.wrist[i]);
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    const Vec3 tip = motion.tip(i, finger);
    all = all && is_known(tip);
    score.tips.add((tip - truth.tip(finger)).norm());
    const Vec3 in_hand = orientation.conjugate() * (tip - motion.wrist[i]);
    const Vec3 true_speed =
        truth.wrist_orientation().conjugate() * (truth.tip(finger) - truth.body(2));
    score.tips_in_hand.add((in_hand - true_speed).norm());
  }
  compare_angles(motion.arm_angles, i, truth, 0, score.arm_angles);
  compare_angles(motion.hand_angles, i, truth, kArmAngleCount, score.hand_angles);
  score.seen += all ? 1 : 0;
  ++score.frames;
}

double peak_within(const std::vector<double>& time, const std::vector<double>& values,
                   const Label& label) {
  double peak = kUnknown;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] >= label.begin_s && time[i] <= label.end_s) peak = std::fmax(peak, values[i]);
  }
  return peak;
}

}  // namespace

void ReconstructionScore::add(const ReconstructionScore& other) {
  for (const auto member :
       {&ReconstructionScore::shoulder, &ReconstructionScore::elbow, &ReconstructionScore::wrist,
        &ReconstructionScore::tips, &ReconstructionScore::tips_in_hand,
        &ReconstructionScore::orientation, &ReconstructionScore::arm_angles,
        &ReconstructionScore::hand_angles, &ReconstructionScore::speed_at_rest,
        &ReconstructionScore::true_speed_at_rest}) {
    (this->*member).add(other.*member);
  }
  delay_s.insert(delay_s.end(), other.delay_s.begin(), other.delay_s.end());
  peak_ratio.insert(peak_ratio.end(), other.peak_ratio.begin(), other.peak_ratio.end());
  seen += other.seen;
  frames += other.frames;
}

double estimate_delay_s(const std::vector<double>& signal, const std::vector<double>& reference,
                        double step_s) {
  assert(signal.size() == reference.size());
  const auto n = static_cast<std::ptrdiff_t>(signal.size());
  const auto most = std::min<std::ptrdiff_t>(n / 4, std::lround(0.2 / step_s));
  if (most < 2) return kUnknown;
  const auto mean = [n](const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(n);
  };
  const double signal_mean = mean(signal), reference_mean = mean(reference);
  const auto at = [](const std::vector<double>& v, std::ptrdiff_t i) { return v[i]; };
  std::vector<double> correlation;
  for (std::ptrdiff_t lag = -most; lag <= most; ++lag) {
    double product = 0;
    // The same frames of the reference are used for every lag, so that no lag is favoured.
    for (std::ptrdiff_t i = most; i < n - most; ++i) {
      product += (at(reference, i) - reference_mean) * (at(signal, i + lag) - signal_mean);
    }
    correlation.push_back(product);
  }
  const auto top = std::max_element(correlation.begin(), correlation.end());
  if (top == correlation.begin() || top + 1 == correlation.end()) return kUnknown;
  const double before = *(top - 1), after = *(top + 1), bend = before - 2 * *top + after;
  if (!(bend < 0)) return kUnknown;
  const double lag =
      static_cast<double>(top - correlation.begin() - most) + (before - after) / (2 * bend);
  return lag * step_s;
}

ReconstructionScore score_reconstruction(const HumanMotion& motion, const Demonstration& truth) {
  ReconstructionScore score;
  Truth at(truth);
  std::vector<Vec3> rebuilt, real;
  std::vector<double> time;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    if (!at.seek(motion.time[i])) continue;
    compare_frame(motion, i, at, score);
    time.push_back(motion.time[i]);
    rebuilt.push_back(motion.tip(i, kIndex));
    real.push_back(at.tip(kIndex));
  }
  if (time.size() < 10) return score;
  const double step_s = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  std::vector<double> found = speeds(rebuilt, step_s);
  const std::vector<double> true_speed = speeds(real, step_s);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!std::isfinite(found[i])) {
      found[i] = true_speed[i];  // unseen frames are given no delay
      continue;
    }
    if (true_speed[i] > kMaxRestSpeed_m_s) continue;
    score.speed_at_rest.add(found[i]);
    score.true_speed_at_rest.add(true_speed[i]);
  }
  if (const double delay = estimate_delay_s(found, true_speed, step_s); std::isfinite(delay)) {
    score.delay_s.push_back(delay);
  }
  for (const Label& label : truth.labels) {
    if (label.phase != PhaseKind::reach) continue;
    const double ratio = peak_within(time, found, label) / peak_within(time, true_speed, label);
    if (std::isfinite(ratio)) score.peak_ratio.push_back(ratio);
  }
  return score;
}

}  // namespace morphe::study
