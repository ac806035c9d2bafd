#pragma once

#include "core/human/arm_angles.hpp"
#include "pipeline/synthesize/subject.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

inline constexpr int kArmStateSize = 10;
/// The state that determines an arm posture: wrist [m], pronation, wrist flexion, radial deviation,
/// elbow swivel angle [rad], shoulder [m].
using ArmState = Eigen::Matrix<double, kArmStateSize, 1>;
/// The indices of the components of ArmState.
enum ArmStateIndex {
  kWristPosition = 0,
  kPronation = 3,
  kFlexion,
  kDeviation,
  kSwivel,
  kShoulderPosition
};

/// A small involuntary motion: Σ_k a_k sin(2π f_k t + φ_k) along each axis, over the waves k.
struct InvoluntaryMotion {
  /// A sine wave of one frequency.
  struct Wave {
    Vec3 amplitude = Vec3::Zero();  ///< of each axis [m]
    double frequency_hz = 0;
    Vec3 phase = Vec3::Zero();  ///< of each axis [rad]
  };
  std::vector<Wave> waves;
  /// Returns the displacement at a time [m].
  Vec3 at(double time_s) const;
  /// Returns true if all amplitudes are zero.
  bool is_zero() const;
};
/// Draws the drift: three waves below 0.3 Hz.
InvoluntaryMotion draw_drift(const SyntheticBody& options, math::RandomStream& random);
/// Draws the tremor: three waves close to one frequency, which beat.
InvoluntaryMotion draw_tremor(const SyntheticBody& options, math::RandomStream& random);

/// The motion of the whole body.
struct BodyMotion {
  SmoothSteps<kArmStateSize> arm;
  SmoothSteps<kHandStateSize> hand;
  InvoluntaryMotion drift, tremor;  ///< of the wrist
};

/// The arm at one instant.
struct ArmSample {
  human::ArmAngles angles{};  ///< [rad]
  human::ArmPose pose;
};
/// Computes the arm of a state. Its angles are within human limits, and its pose follows from them,
/// so that bones keep their lengths.
ArmSample arm_sample(const Subject& subject, const ArmState& state);
/// Returns the state at a time, with the drift but without the tremor.
ArmState arm_state(const BodyMotion& motion, double time_s);

}  // namespace morphe::synthesize
