#include "core/human/arm_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morphe::human {
namespace {

using Eigen::Matrix3d;
constexpr double kPi = std::numbers::pi;
constexpr double kUndetermined = 1e-9;  ///< sine of an angle below which a direction has no heading

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

/// The hand's axes in the forearm's at zero.
Matrix3d turned_to_hand(const Matrix3d& world_from_forearm) {
  Matrix3d hand = world_from_forearm;
  hand.col(0) *= -1;
  hand.col(2) *= -1;
  return hand;
}

double clamped(std::size_t k, double angle) {
  return std::clamp(angle, human_arm_limits().lower[k], human_arm_limits().upper[k]);
}

/// The turn of `angle` nearest to `middle`.
double turn_about(double middle, double angle) {
  return middle + std::remainder(angle - middle, 2 * kPi);
}

double middle_of(std::size_t k) {
  return (human_arm_limits().lower[k] + human_arm_limits().upper[k]) / 2;
}

double within(std::size_t k, double angle) { return clamped(k, turn_about(middle_of(k), angle)); }

/// The other angles, given where the upper arm points; `flexion` is free at the pole.
ArmFit fit_from_shoulder(const ArmPose& pose, const ArmLengths& lengths, double flexion,
                         double abduction, bool at_pole) {
  ArmFit fit;
  auto& [q0, q1, q2, q3, q4, q5, q6] = fit.angles;
  q0 = within(0, flexion);
  q1 = within(1, abduction);
  Matrix3d upper_arm = about_x(q0) * about_y(-q1);
  Vec3 elbow = pose.shoulder - lengths.upper_arm * upper_arm.col(2);
  Vec3 forearm = (upper_arm.transpose() * (pose.wrist - elbow)).normalized();
  if (at_pole) {  // Rx(f) Ry(-90 deg) Rz(i) depends on f - i alone
    const double lead =
        turn_about(middle_of(0) - middle_of(2), std::atan2(forearm.x(), forearm.y()));
    q0 = clamped(0, lead);
    upper_arm = about_x(q0) * about_y(-q1);
    forearm = (upper_arm.transpose() * (pose.wrist - elbow)).normalized();
  }
  const Matrix3d hand = turned_to_hand(upper_arm.transpose() * pose.world_from_hand.matrix());
  if (std::hypot(forearm.x(), forearm.y()) > kUndetermined) {
    q2 = within(2, std::atan2(-forearm.x(), forearm.y()));
  } else {
    // Rotation and pronation turn about the same line.
    const double turned =
        turn_about(middle_of(2) + middle_of(4), std::atan2(hand(1, 0), hand(0, 0)));
    q2 = clamped(2, turned - clamped(4, turned));
  }
  q3 = within(3, std::atan2(std::cos(q2) * forearm.y() - std::sin(q2) * forearm.x(), -forearm.z()));
  // What is left is Rz(pronation) Ry(flexion) Rx(deviation).
  Matrix3d left = (about_z(q2) * about_x(q3)).transpose() * hand;
  q4 = within(4, std::atan2(left(1, 0), left(0, 0)));
  left = about_z(q4).transpose() * left;
  q5 = within(5, std::atan2(-left(2, 0), left(0, 0)));
  left = about_y(q5).transpose() * left;
  q6 = within(6, std::atan2(left(2, 1) - left(1, 2), left(1, 1) + left(2, 2)));

  const ArmPose reached = arm_pose(pose.shoulder, lengths, fit.angles);
  fit.position_m = std::sqrt(std::max((reached.elbow - pose.elbow).squaredNorm(),
                                      (reached.wrist - pose.wrist).squaredNorm()));
  // The angle by the chord: exact near zero, where acos of the inner product is not.
  const Vec3 apart = (reached.world_from_hand.conjugate() * pose.world_from_hand).vec();
  fit.rotation_rad = 2 * std::asin(std::min(1.0, apart.norm()));
  return fit;
}

bool exact(const ArmFit& fit) { return fit.position_m < 1e-9 && fit.rotation_rad < 1e-7; }

double missed(const ArmFit& fit) {
  constexpr double kHand = 0.1;  // [m] a hand's lever
  return fit.position_m + kHand * fit.rotation_rad;
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
  static constexpr ArmLimits limits = {{-61 * kDegree, -48 * kDegree, -34 * kDegree, 0,
                                        -133 * kDegree, -90 * kDegree, -90 * kDegree},
                                       {188 * kDegree, 134 * kDegree, 97 * kDegree, 142 * kDegree,
                                        77 * kDegree, 90 * kDegree, 90 * kDegree}};
  return limits;
}

ArmFit fit_arm_angles(const ArmPose& pose) {
  const ArmLengths lengths = {(pose.elbow - pose.shoulder).norm(),
                              (pose.wrist - pose.elbow).norm()};
  if (!(lengths.upper_arm > 0 && lengths.forearm > 0 && seen(pose.world_from_hand))) {
    ArmFit unseen{{}, kNotSeen, kNotSeen};
    unseen.angles.fill(kNotSeen);
    return unseen;
  }
  const Vec3 upper_arm = (pose.elbow - pose.shoulder) / lengths.upper_arm;
  const double down = std::hypot(upper_arm.y(), upper_arm.z());
  const bool at_pole = down < kUndetermined;
  const double flexion = at_pole ? 0 : std::atan2(upper_arm.y(), -upper_arm.z());
  const double abduction = std::atan2(upper_arm.x(), down);
  const ArmFit below = fit_from_shoulder(pose, lengths, flexion, abduction, at_pole);
  if (exact(below)) return below;
  // Abducted past the horizontal: the same direction by the other way round.
  const ArmFit above = fit_from_shoulder(pose, lengths, flexion + kPi, kPi - abduction, at_pole);
  return missed(above) < missed(below) ? above : below;
}

}  // namespace morphe::human
