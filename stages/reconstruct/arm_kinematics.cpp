#include "stages/reconstruct/arm_kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/human/arm_angles.hpp"
#include "core/math/statistics.hpp"
#include "stages/reconstruct/human_limits.hpp"

namespace morphe::reconstruct {
namespace {

/// RMS deviation of a length that skin movement cannot explain [m].
constexpr double kMaxLengthRms_m = 0.02;

/// Accumulates the root mean square and maximum of values.
class RmsAccumulator {
 public:
  void add(double value) {
    if (!std::isfinite(value)) return;
    squares_ += value * value;
    max_ = std::max(max_, std::abs(value));
    ++count_;
  }
  double rms() const { return count_ > 0 ? std::sqrt(squares_ / static_cast<double>(count_)) : 0; }
  void report(const std::string& name, std::vector<Residual>& residuals) const {
    if (count_ > 0) residuals.push_back({name, rms(), max_});
  }

 private:
  double squares_ = 0, max_ = 0;
  std::size_t count_ = 0;
};

/// Projects the ends of the two bones onto their lengths by Newton's method on the constraints,
/// each step the shortest that meets them to first order. Convergence is quadratic; errors are a
/// hundredth of the lengths.
void project_to_bone_lengths(double upper_arm, double forearm, Vec3& shoulder, Vec3& elbow,
                             Vec3& wrist) {
  constexpr int kStepCount = 4;
  for (int step = 0; step < kStepCount; ++step) {
    const Vec3 a = (elbow - shoulder).normalized(), b = (wrist - elbow).normalized();
    const double long_a = (elbow - shoulder).norm() - upper_arm;
    const double long_b = (wrist - elbow).norm() - forearm;
    // Both constraints move the elbow and are therefore coupled: [2 -c; -c 2] pull = excess.
    const double c = a.dot(b), scale = 1 / (4 - c * c);
    const double pull_a = scale * (2 * long_a + c * long_b);
    const double pull_b = scale * (2 * long_b + c * long_a);
    shoulder += pull_a * a;
    elbow += pull_b * b - pull_a * a;
    wrist -= pull_b * b;
  }
}

/// Does the same for one bone.
void project_to_bone_length(double length, Vec3& a, Vec3& b) {
  const Vec3 excess = ((b - a).norm() - length) / 2 * (b - a).normalized();
  a += excess;
  b -= excess;
}

}  // namespace

void enforce_bone_lengths(HumanMotion& motion, const std::optional<human::ArmLengths>& known) {
  const auto [upper_arm, forearm] =
      known.value_or(human::ArmLengths{math::median_distance(motion.shoulder, motion.elbow),
                                       math::median_distance(motion.elbow, motion.wrist)});
  RmsAccumulator upper_arm_off, forearm_off;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    upper_arm_off.add((motion.elbow[i] - motion.shoulder[i]).norm() - upper_arm);
    forearm_off.add((motion.wrist[i] - motion.elbow[i]).norm() - forearm);
  }
  upper_arm_off.report("upper arm length", motion.residuals);
  forearm_off.report("forearm length", motion.residuals);
  if (!known && (upper_arm_off.rms() > kMaxLengthRms_m || forearm_off.rms() > kMaxLengthRms_m)) {
    motion.reconstruction_notes.push_back(
        fmt::format("the tracked joints do not form an arm: the lengths of upper arm and forearm "
                    "vary by {:.0f} and {:.0f} mm RMS; the joints are used as recorded",
                    1000 * upper_arm_off.rms(), 1000 * forearm_off.rms()));
    return;
  }
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    Vec3 &shoulder = motion.shoulder[i], &elbow = motion.elbow[i], &wrist = motion.wrist[i];
    if (!is_known(elbow)) continue;
    if (is_known(shoulder) && is_known(wrist)) {
      project_to_bone_lengths(upper_arm, forearm, shoulder, elbow, wrist);
    } else if (is_known(shoulder)) {
      project_to_bone_length(upper_arm, shoulder, elbow);
    } else if (is_known(wrist)) {
      project_to_bone_length(forearm, elbow, wrist);
    }
  }
}

void add_arm_angles(HumanMotion& motion) {
  constexpr double kHandLever_m = 0.1;  // [m]
  const auto frames = static_cast<Eigen::Index>(motion.time.size());
  JointRows angles(frames, kArmAngleCount);
  RmsAccumulator missed, turned;
  for (Eigen::Index row = 0; row < frames; ++row) {
    const auto i = static_cast<std::size_t>(row);
    const human::ArmFit fit = human::fit_arm_angles(
        {motion.shoulder[i], motion.elbow[i], motion.wrist[i], motion.wrist_orientation[i]});
    for (std::size_t k = 0; k < kArmAngleCount; ++k) {
      angles(row, k) = fit.angles[k];
    }
    missed.add(fit.position_error_m);
    turned.add(kHandLever_m * fit.rotation_error_rad);
  }
  if (!(angles.array().isFinite()).any()) return;
  motion.arm_angles = std::move(angles);
  missed.report(kLimitViolationResidual, motion.residuals);
  turned.report("arm angles, hand", motion.residuals);
  constexpr double kMaxPositionRms_m = 0.02, kMaxRotationRms_m = 0.3 * kHandLever_m;  // [m]
  if (missed.rms() > kMaxPositionRms_m) {
    motion.reconstruction_notes.push_back(
        fmt::format("arm angles: elbow or wrist are {:.0f} mm RMS beyond human joint limits",
                    1000 * missed.rms()));
  }
  if (turned.rms() > kMaxRotationRms_m) {
    motion.reconstruction_notes.push_back(
        fmt::format("arm angles: the hand is turned {:.0f} degrees RMS beyond human joint limits",
                    turned.rms() / kHandLever_m * 180 / std::numbers::pi));
  }
}

}  // namespace morphe::reconstruct
