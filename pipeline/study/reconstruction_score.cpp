#include "pipeline/study/reconstruction_score.hpp"

#include <algorithm>
#include <cassert>

namespace morphe::study {
namespace {

/// True speed of the tip below which it is at rest.
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
    const auto after = std::upper_bound(time.begin() + 1, time.end() - 1, time_s);
    row_ = (after - time.begin()) - 1;
    share_ = (time_s - time[row_]) / (time[row_ + 1] - time[row_]);
    return true;
  }
  Vec3 body(int k) const { return interpolate(bodies_.position, k); }
  Vec3 tip(std::size_t finger) const { return interpolate(hand_.position, finger); }
  Quat wrist_orientation() const {
    return bodies_.orientation(row_, 2).slerp(share_, bodies_.orientation(row_ + 1, 2));
  }
  double angle(Eigen::Index joint) const {
    return (1 - share_) * angles_.angles(row_, joint) + share_ * angles_.angles(row_ + 1, joint);
  }

 private:
  Vec3 interpolate(const Array2D<Vec3>& table, std::size_t column) const {
    return (1 - share_) * table(row_, column) + share_ * table(row_ + 1, column);
  }
  const BodyStream& bodies_;
  const HandStream& hand_;
  const AngleStream& angles_;
  Eigen::Index row_ = 0;
  double share_ = 0;
};

/// Computes the speed between each point and the one before; the first speed is that of the second.
std::vector<double> speeds(const std::vector<Vec3>& points, double step_s) {
  std::vector<double> result(points.size(), 0);
  for (int i = 1; i < std::ssize(points); ++i)
    result[i] = (points[i] - points[i - 1]).norm() / step_s;
  if (result.size() > 1) result[0] = result[1];
  return result;
}

void compare_angles(const JointRows& angles, int row, const Truth& truth, int first_joint,
                    MeanSquare& score) {
  if (row >= angles.rows()) return;
  for (Eigen::Index j = 0; j < angles.cols(); ++j)
    score.add(angles(row, j) - truth.angle(first_joint + j));
}

void compare_frame(const HumanMotion& motion, int i, const Truth& truth,
                   ReconstructionScore& score) {
  score.shoulder.add((motion.shoulder[i] - truth.body(0)).norm());
  score.elbow.add((motion.elbow[i] - truth.body(1)).norm());
  score.wrist.add((motion.wrist[i] - truth.body(2)).norm());
  const Quat orientation = motion.wrist_orientation[i];
  if (is_known(orientation))
    score.orientation.add(angle_between(orientation, truth.wrist_orientation()));
  bool all_seen = is_known(motion.wrist[i]);
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    const Vec3 tip = motion.tip(i, finger);
    all_seen = all_seen && is_known(tip);
    score.tips.add((tip - truth.tip(finger)).norm());
    const Vec3 tip_in_hand = orientation.conjugate() * (tip - motion.wrist[i]);
    const Vec3 true_tip_in_hand =
        truth.wrist_orientation().conjugate() * (truth.tip(finger) - truth.body(2));
    score.tips_in_hand.add((tip_in_hand - true_tip_in_hand).norm());
  }
  compare_angles(motion.arm_angles, i, truth, 0, score.arm_angles);
  compare_angles(motion.hand_angles, i, truth, kArmAngleCount, score.hand_angles);
  score.seen += all_seen ? 1 : 0;
  ++score.frames;
}

double peak_within(const std::vector<double>& time, const std::vector<double>& values,
                   const Label& label) {
  double peak = kUnknown;
  for (int i = 0; i < std::ssize(time); ++i) {
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
  const std::ptrdiff_t n = std::ssize(signal);
  const std::ptrdiff_t max_lag = std::min<std::ptrdiff_t>(n / 4, std::lround(0.2 / step_s));
  if (max_lag < 2) return kUnknown;
  const auto mean = [n](const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(n);
  };
  const double signal_mean = mean(signal), reference_mean = mean(reference);
  std::vector<double> correlation;
  for (std::ptrdiff_t lag = -max_lag; lag <= max_lag; ++lag) {
    double product = 0;
    // The same frames of the reference are used for every lag, so that no lag is favoured.
    for (std::ptrdiff_t i = max_lag; i < n - max_lag; ++i)
      product += (reference[i] - reference_mean) * (signal[i + lag] - signal_mean);
    correlation.push_back(product);
  }
  const auto top = std::max_element(correlation.begin(), correlation.end());
  if (top == correlation.begin() || top + 1 == correlation.end()) return kUnknown;
  const double before = *(top - 1), after = *(top + 1), bend = before - 2 * *top + after;
  if (!(bend < 0)) return kUnknown;
  const double lag =
      static_cast<double>(top - correlation.begin() - max_lag) + (before - after) / (2 * bend);
  return lag * step_s;
}

ReconstructionScore score_reconstruction(const HumanMotion& motion, const Demonstration& truth) {
  ReconstructionScore score;
  Truth interpolated_truth(truth);
  std::vector<Vec3> tip, true_tip;
  std::vector<double> time;
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    if (!interpolated_truth.seek(motion.time[i])) continue;
    compare_frame(motion, i, interpolated_truth, score);
    time.push_back(motion.time[i]);
    tip.push_back(motion.tip(i, kIndex));
    true_tip.push_back(interpolated_truth.tip(kIndex));
  }
  if (time.size() < 10) return score;
  const double step_s = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  std::vector<double> speed = speeds(tip, step_s);
  const std::vector<double> true_speed = speeds(true_tip, step_s);
  for (int i = 0; i < std::ssize(speed); ++i) {
    if (!std::isfinite(speed[i])) {
      speed[i] = true_speed[i];  // so that unseen frames do not change the delay
      continue;
    }
    if (true_speed[i] > kMaxRestSpeed_m_s) continue;
    score.speed_at_rest.add(speed[i]);
    score.true_speed_at_rest.add(true_speed[i]);
  }
  if (const double delay_s = estimate_delay_s(speed, true_speed, step_s); std::isfinite(delay_s))
    score.delay_s.push_back(delay_s);
  for (const Label& label : truth.labels) {
    if (label.phase != PhaseKind::reach) continue;
    const double ratio = peak_within(time, speed, label) / peak_within(time, true_speed, label);
    if (std::isfinite(ratio)) score.peak_ratio.push_back(ratio);
  }
  return score;
}

}  // namespace morphe::study
