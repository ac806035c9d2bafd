#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/human/arm_angles.hpp"
#include "core/human/glove.hpp"
#include "core/motion/demonstration.hpp"

namespace morphe::reconstruct {

/// An arm and a hand whose every angle swings, by forward kinematics: what calibrated sensors and a
/// glove record of them, and the truth at any instant.
struct GlovedArm {
  human::ArmLengths arm{0.30, 0.25};
  human::HandSize hand{0.19, 0.085};
  Vec3 shoulder = Vec3(0.2, -0.2, 0.4);
  double position_noise = 0, rotation_noise = 0, glove_noise = 0;  ///< [m], [rad], [rad]
  double glove_late_s = 0;                                         ///< what its clock reads more
  double glove_zero = 0.1;                                         ///< of every sensor [rad]
  double duration_s = 10;

  human::ArmAngles angles(double t) const {
    const auto swing = [&](double middle, double width, double hz, double phase) {
      return middle + width * std::sin(2 * std::numbers::pi * hz * t + phase);
    };
    return {swing(0.6, 0.3, 0.4, 0),    swing(0.3, 0.15, 0.3, 1), swing(0.3, 0.2, 0.5, 2),
            swing(1.2, 0.4, 0.45, 0.5), swing(0.2, 0.4, 0.35, 3), swing(0.1, 0.3, 0.6, 1.5),
            swing(0.0, 0.15, 0.5, 0.7)};
  }
  human::ArmPose pose(double t) const { return human::arm_pose(shoulder, arm, angles(t)); }
  human::HandAngles fingers(double t) const {
    human::HandAngles angles;
    for (std::size_t k = 0; k < kHandAngleCount; ++k) {
      const double phase = 0.3 * static_cast<double>(k);
      angles.joint[k] = 0.4 + 0.25 * std::sin(2 * std::numbers::pi * 0.5 * t + phase);
    }
    for (const std::size_t abduction : {4u, 12u, 16u}) angles.joint[abduction] -= 0.4;
    angles.joint[8] = 0;  // no sensor sees the middle finger's own
    angles.palm_arch = 0.1 + 0.05 * std::sin(t);
    return angles;
  }
  human::HandPoints points(double t) const {
    std::vector<Pose> frames;
    return human::hand_points(human::human_hand(hand), fingers(t), frames);
  }
  Vec3 tip(double t, std::size_t finger) const {
    const human::ArmPose now = pose(t);
    return now.wrist + now.world_from_hand * points(t).tip[finger];
  }

  Demonstration record() const {
    std::mt19937 random(12);
    std::normal_distribution<double> normal;
    const auto three = [&](double size) {
      return Vec3(size * Vec3(normal(random), normal(random), normal(random)));
    };
    const SensorOffsets offsets = {
        {"shoulder", "elbow", "wrist"},
        {{0.01, -0.03, -0.02}, {0.03, 0.01, -0.02}, {-0.02, 0.02, -0.03}},
        {Quat::Identity(), Quat::Identity(),
         Quat(Eigen::AngleAxisd(0.7, Vec3(1, -2, 1).normalized()))}};
    Demonstration d;
    BodyStream& bodies = d.streams.sensors.emplace();
    bodies.names = offsets.sensors;
    const auto n = static_cast<std::size_t>(240 * duration_s);
    bodies.position = Array2D<Vec3>(n, 3, Vec3::Zero());
    bodies.orientation = Array2D<Quat>(n, 3, Quat::Identity());
    for (std::size_t i = 0; i < n; ++i) {
      const double t = static_cast<double>(i) / 240;
      bodies.time.push_back(t);
      const human::ArmPose now = pose(t);
      const human::ArmAngles q = angles(t);
      const Quat upper_arm = Eigen::AngleAxisd(q[0], Vec3::UnitX()) *
                             Eigen::AngleAxisd(-q[1], Vec3::UnitY()) *
                             Eigen::AngleAxisd(q[2], Vec3::UnitZ());
      const Vec3 joint[] = {now.shoulder, now.elbow, now.wrist};
      const Quat sensor[] = {Quat(Eigen::AngleAxisd(0.4, Vec3::UnitY())), upper_arm,
                             now.world_from_hand * offsets.sensor_from_segment[2].conjugate()};
      for (std::size_t s = 0; s < 3; ++s) {
        const Vec3 turn = three(rotation_noise);
        const Quat shaken =
            turn.norm() > 0 ? sensor[s] * Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized()))
                            : sensor[s];
        bodies.position(i, s) =
            joint[s] - sensor[s] * offsets.joint_in_sensor[s] + three(position_noise);
        bodies.orientation(i, s) = shaken;
      }
    }
    d.sensor_offsets = offsets;
    d.hand_length = hand.length;
    d.hand_breadth = hand.breadth;
    const auto glove_of = [&](const std::vector<double>& time, bool flat) {
      HandStream glove;
      glove.kind = HandKind::glove;
      glove.names.assign(std::begin(human::kGloveSensors), std::end(human::kGloveSensors));
      glove.angles.resize(static_cast<Eigen::Index>(time.size()),
                          static_cast<Eigen::Index>(human::kGloveSensorCount));
      for (std::size_t i = 0; i < time.size(); ++i) {
        human::GloveReading reading;
        if (!flat) reading = {fingers(time[i]), angles(time[i])[5], angles(time[i])[6]};
        const human::GloveAngles read = human::encode_glove(reading);
        glove.time.push_back(time[i] + (flat ? 0 : glove_late_s));
        for (std::size_t k = 0; k < human::kGloveSensorCount; ++k) {
          glove.angles(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
              read[k] + glove_zero + glove_noise * normal(random);
        }
      }
      return glove;
    };
    std::vector<double> instants, still;
    for (double t = 0.0031; t < duration_s; t += 1.0 / 90) instants.push_back(t);
    for (int i = 0; i < 180; ++i) still.push_back(i / 90.0);
    d.streams.hand = glove_of(instants, false);
    d.calibration.hand = glove_of(still, true);
    return d;
  }
};

}  // namespace morphe::reconstruct
