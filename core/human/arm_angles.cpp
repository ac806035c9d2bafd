#include "core/human/arm_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morphe::human {
namespace {

using Eigen::Matrix3d;
constexpr double kPi = std::numbers::pi;
/// Sine of the angle to an axis below which a direction has no defined angle about the axis.
constexpr double kSingularSine = 1e-9;

Matrix3d about_x(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d r;
  r << 1, 0, 0, 0, c, -s, 0, s, c;
  return r;
}
Matrix3d about_y(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d r;
  r << c, 0, s, 0, 1, 0, -s, 0, c;
  return r;
}
Matrix3d about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d r;
  r << c, -s, 0, s, c, 0, 0, 0, 1;
  return r;
}

/// Returns R diag(-1, 1, -1): a forearm's axes become those of a hand at zero, or the reverse.
Matrix3d turned_to_hand(const Matrix3d& rotation) {
  Matrix3d hand = rotation;
  hand.col(0) *= -1;
  hand.col(2) *= -1;
  return hand;
}

double clamp_to_limits(int k, double angle) {
  return std::clamp(angle, human_arm_limits().lower[k], human_arm_limits().upper[k]);
}

/// Returns the angle nearest to `middle` that differs from `angle` by whole turns.
double wrap_near(double middle, double angle) {
  return middle + std::remainder(angle - middle, 2 * kPi);
}

double middle_of(int k) { return (human_arm_limits().lower[k] + human_arm_limits().upper[k]) / 2; }

double wrap_and_clamp(int k, double angle) {
  return clamp_to_limits(k, wrap_near(middle_of(k), angle));
}

/// Computes all angles and errors, given flexion and abduction of the upper arm. At the pole, where
/// the upper arm is along X, `flexion` is not used.
ArmFit fit_from_shoulder(const ArmPose& pose, const ArmLengths& lengths, double flexion,
                         double abduction, bool at_pole) {
  ArmFit fit;
  auto& [q0, q1, q2, q3, q4, q5, q6] = fit.angles;
  q0 = wrap_and_clamp(0, flexion);
  q1 = wrap_and_clamp(1, abduction);
  Matrix3d upper_arm = about_x(q0) * about_y(-q1);
  Vec3 elbow = pose.shoulder - lengths.upper_arm * upper_arm.col(2);
  Vec3 forearm = (upper_arm.transpose() * (pose.wrist - elbow)).normalized();
  if (at_pole) {  // Rx(f) Ry(-90 deg) Rz(i) depends only on f - i
    const double flexion_less_rotation =
        wrap_near(middle_of(0) - middle_of(2), std::atan2(forearm.x(), forearm.y()));
    q0 = clamp_to_limits(0, flexion_less_rotation);
    upper_arm = about_x(q0) * about_y(-q1);
    forearm = (upper_arm.transpose() * (pose.wrist - elbow)).normalized();
  }
  const Matrix3d hand = turned_to_hand(upper_arm.transpose() * pose.world_from_hand.matrix());
  if (std::hypot(forearm.x(), forearm.y()) > kSingularSine) {
    q2 = wrap_and_clamp(2, std::atan2(-forearm.x(), forearm.y()));
  } else {
    // Rotation and pronation have the same axis.
    const double rotation_and_pronation =
        wrap_near(middle_of(2) + middle_of(4), std::atan2(hand(1, 0), hand(0, 0)));
    q2 = clamp_to_limits(2, rotation_and_pronation - clamp_to_limits(4, rotation_and_pronation));
  }
  q3 = wrap_and_clamp(
      3, std::atan2(std::cos(q2) * forearm.y() - std::sin(q2) * forearm.x(), -forearm.z()));
  // The remaining rotation is Rz(pronation) Ry(flexion) Rx(deviation).
  Matrix3d remaining = (about_z(q2) * about_x(q3)).transpose() * hand;
  q4 = wrap_and_clamp(4, std::atan2(remaining(1, 0), remaining(0, 0)));
  remaining = about_z(q4).transpose() * remaining;
  q5 = wrap_and_clamp(5, std::atan2(-remaining(2, 0), remaining(0, 0)));
  remaining = about_y(q5).transpose() * remaining;
  q6 = wrap_and_clamp(
      6, std::atan2(remaining(2, 1) - remaining(1, 2), remaining(1, 1) + remaining(2, 2)));

  const ArmPose fitted = arm_pose(pose.shoulder, lengths, fit.angles);
  fit.position_error_m = std::sqrt(std::max((fitted.elbow - pose.elbow).squaredNorm(),
                                            (fitted.wrist - pose.wrist).squaredNorm()));
  // Small angles are exact, unlike those from acos of the quaternions' inner product.
  const Vec3 half_chord = (fitted.world_from_hand.conjugate() * pose.world_from_hand).vec();
  fit.rotation_error_rad = 2 * std::asin(std::min(1.0, half_chord.norm()));
  return fit;
}

bool is_exact(const ArmFit& fit) {
  return fit.position_error_m < 1e-9 && fit.rotation_error_rad < 1e-7;
}

double pose_error_m(const ArmFit& fit) {
  constexpr double kHandLength_m = 0.1;  // distance at which a rotation error counts
  return fit.position_error_m + kHandLength_m * fit.rotation_error_rad;
}

}  // namespace

ArmPose arm_pose(const Vec3& shoulder, const ArmLengths& lengths, const ArmAngles& q) {
  const Matrix3d upper_arm = about_x(q[0]) * about_y(-q[1]) * about_z(q[2]);
  const Matrix3d forearm = upper_arm * about_x(q[3]);
  ArmPose pose;
  pose.shoulder = shoulder;
  pose.elbow = shoulder - lengths.upper_arm * upper_arm.col(2);
  pose.wrist = pose.elbow - lengths.forearm * forearm.col(2);
  pose.world_from_hand =
      Quat(turned_to_hand(forearm * about_z(q[4]) * about_y(q[5]) * about_x(q[6])));
  return pose;
}

const ArmLimits& human_arm_limits() {
  static constexpr ArmLimits limits = {
      {-61 * kRadPerDegree, -48 * kRadPerDegree, -34 * kRadPerDegree, 0, -133 * kRadPerDegree,
       -90 * kRadPerDegree, -90 * kRadPerDegree},
      {188 * kRadPerDegree, 134 * kRadPerDegree, 97 * kRadPerDegree, 142 * kRadPerDegree,
       77 * kRadPerDegree, 90 * kRadPerDegree, 90 * kRadPerDegree}};
  return limits;
}

ArmFit fit_arm_angles(const ArmPose& pose) {
  const ArmLengths lengths = {(pose.elbow - pose.shoulder).norm(),
                              (pose.wrist - pose.elbow).norm()};
  if (!(lengths.upper_arm > 0 && lengths.forearm > 0 && is_known(pose.world_from_hand))) {
    ArmFit unknown{{}, kUnknown, kUnknown};
    unknown.angles.fill(kUnknown);
    return unknown;
  }
  const Vec3 upper_arm = (pose.elbow - pose.shoulder) / lengths.upper_arm;
  const double down = std::hypot(upper_arm.y(), upper_arm.z());
  const bool at_pole = down < kSingularSine;
  const double flexion = at_pole ? 0 : std::atan2(upper_arm.y(), -upper_arm.z());
  const double abduction = std::atan2(upper_arm.x(), down);
  const ArmFit below = fit_from_shoulder(pose, lengths, flexion, abduction, at_pole);
  if (is_exact(below)) return below;
  // With abduction beyond the horizontal, the same direction of the upper arm has other angles.
  const ArmFit above = fit_from_shoulder(pose, lengths, flexion + kPi, kPi - abduction, at_pole);
  return pose_error_m(above) < pose_error_m(below) ? above : below;
}

}  // namespace morphe::human
