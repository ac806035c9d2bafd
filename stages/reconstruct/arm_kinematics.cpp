#include "stages/reconstruct/arm_kinematics.hpp"

#include <fmt/format.h>

#include <numbers>

#include "core/human/arm_angles.hpp"
#include "core/math/statistics.hpp"
#include "stages/reconstruct/human_limits.hpp"
#include "stages/reconstruct/residual_sum.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kMaxLengthRms_m = 0.02;  ///< skin movement does not explain more

/// Gives the two bones their lengths by Newton's method on the constraints. Each step is the
/// shortest that meets them to first order. From errors of 1 %, convergence is quadratic.
void project_to_bone_lengths(double upper_arm, double forearm, Vec3& shoulder, Vec3& elbow,
                             Vec3& wrist) {
  constexpr int kStepCount = 4;
  for (int step = 0; step < kStepCount; ++step) {
    const Vec3 a = (elbow - shoulder).normalized(), b = (wrist - elbow).normalized();
    const double excess_a = (elbow - shoulder).norm() - upper_arm;
    const double excess_b = (wrist - elbow).norm() - forearm;
    // Both constraints move the elbow and are therefore coupled: [2 -c; -c 2] pull = excess.
    const double c = a.dot(b), scale = 1 / (4 - c * c);
    const double pull_a = scale * (2 * excess_a + c * excess_b);
    const double pull_b = scale * (2 * excess_b + c * excess_a);
    shoulder += pull_a * a;
    elbow += pull_b * b - pull_a * a;
    wrist -= pull_b * b;
  }
}

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
  ResidualSum upper_errors, lower_errors;
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    upper_errors.add((motion.elbow[i] - motion.shoulder[i]).norm() - upper_arm);
    lower_errors.add((motion.wrist[i] - motion.elbow[i]).norm() - forearm);
  }
  upper_errors.report("upper arm length", motion.residuals);
  lower_errors.report("forearm length", motion.residuals);
  if (!known && (upper_errors.rms() > kMaxLengthRms_m || lower_errors.rms() > kMaxLengthRms_m)) {
    motion.reconstruction_notes.push_back(
        fmt::format("the tracked joints do not form an arm: the lengths of upper arm and forearm "
                    "vary by {:.0f} and {:.0f} mm RMS; the joints are used as recorded",
                    1000 * upper_errors.rms(), 1000 * lower_errors.rms()));
    return;
  }
  for (int i = 0; i < std::ssize(motion.time); ++i) {
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
  constexpr double kHandLever_m = 0.1;
  JointRows angles(motion.time.size(), kArmAngleCount);
  ResidualSum position_errors, rotation_errors;
  for (int i = 0; i < angles.rows(); ++i) {
    const human::ArmFit fit = human::fit_arm_angles(
        {motion.shoulder[i], motion.elbow[i], motion.wrist[i], motion.wrist_orientation[i]});
    for (std::size_t k = 0; k < kArmAngleCount; ++k) angles(i, k) = fit.angles[k];
    position_errors.add(fit.position_error_m);
    rotation_errors.add(kHandLever_m * fit.rotation_error_rad);
  }
  if (!(angles.array().isFinite()).any()) return;
  motion.arm_angles = std::move(angles);
  position_errors.report(kLimitViolationResidual, motion.residuals);
  rotation_errors.report("arm angles, hand", motion.residuals);
  constexpr double kMaxPositionRms_m = 0.02, kMaxRotationRms_m = 0.3 * kHandLever_m;
  if (position_errors.rms() > kMaxPositionRms_m) {
    motion.reconstruction_notes.push_back(
        fmt::format("arm angles: elbow or wrist are {:.0f} mm RMS beyond human joint limits",
                    1000 * position_errors.rms()));
  }
  if (rotation_errors.rms() > kMaxRotationRms_m) {
    motion.reconstruction_notes.push_back(
        fmt::format("arm angles: the hand is turned {:.0f} degrees RMS beyond human joint limits",
                    rotation_errors.rms() / kHandLever_m * 180 / std::numbers::pi));
  }
}

}  // namespace morphe::reconstruct
