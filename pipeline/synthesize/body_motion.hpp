#pragma once

#include <array>

#include "core/human/arm_angles.hpp"
#include "pipeline/synthesize/subject.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// The size of the state that determines an arm posture: wrist [m], pronation, wrist flexion,
/// radial deviation, elbow swivel angle [rad], shoulder [m].
inline constexpr int kArmStateSize = 10;
/// The state of an arm.
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

/// Small involuntary motion: Σ_k a_k sin(2π f_k t + φ_k) for each axis.
struct InvoluntaryMotion {
  /// A sine wave of the motion.
  struct Wave {
    /// Amplitude of each axis [m].
    Vec3 amplitude = Vec3::Zero();
    /// The frequency [Hz].
    double frequency_hz = 0;
    /// The phase of each axis [rad].
    Vec3 phase = Vec3::Zero();
  };
  /// The waves.
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
  /// The motion of the arm.
  SmoothSteps<kArmStateSize> arm;
  /// The motion of the fingers.
  SmoothSteps<kHandStateSize> hand;
  /// The involuntary motions of the wrist.
  InvoluntaryMotion drift, tremor;
};

/// The arm at one instant.
struct ArmSample {
  /// The joint angles [rad].
  human::ArmAngles angles{};
  /// The positions and orientations of the segments.
  human::ArmPose pose;
};
/// Computes the arm of a state. The elbow is at the swivel angle (elbow_from_swivel), the angles
/// are within human limits, and the pose follows from the angles, so that bones keep their lengths.
ArmSample arm_sample(const Subject& subject, const ArmState& state);
/// Returns the state at a time, with the drift but without the tremor.
ArmState arm_state(const BodyMotion& motion, double time_s);

}  // namespace morphe::synthesize
