#pragma once

#include <array>

#include "core/human/arm_angles.hpp"
#include "pipeline/synthesize/subject.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// What an arm is led by: wrist [m], pronation, wrist flexion, radial deviation, elbow swivel
/// [rad], shoulder [m].
inline constexpr int kArmState = 10;
using ArmState = Eigen::Matrix<double, kArmState, 1>;
enum ArmStateIndex { kWristAt = 0, kPronation = 3, kFlexion, kDeviation, kSwivel, kShoulderAt };

/// Small motion that nobody asked for: Σ_k a_k sin(2π f_k t + φ_k) for each axis.
struct Unrest {
  struct Wave {
    Vec3 amplitude = Vec3::Zero();  ///< [m]
    double hz = 0;
    Vec3 phase = Vec3::Zero();
  };
  std::vector<Wave> waves;
  Vec3 at(double time_s) const;
  bool still() const;
};
/// Drift: three waves below 0.3 Hz. Tremor: three close to one frequency, which beat.
Unrest draw_drift(const SyntheticBody& options, math::RandomStream& random);
Unrest draw_tremor(const SyntheticBody& options, math::RandomStream& random);

/// All that moves.
struct BodyMotion {
  SmoothSteps<kArmState> arm;
  SmoothSteps<kHandState> hand;
  Unrest drift, tremor;
};

struct ArmAt {
  human::ArmAngles angles{};
  human::ArmPose pose;
};
/// The elbow hangs at the swivel (natural_elbow), the angles are within human limits, the pose is
/// theirs: bones keep their lengths.
ArmAt arm_at(const Subject& subject, const ArmState& state);
/// With the drift, without the tremor.
ArmState arm_state(const BodyMotion& motion, double time_s);

}  // namespace morphe::synthesize
