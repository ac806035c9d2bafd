#include "pipeline/synthesize/body_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morphe::synthesize {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

/// Returns the hand's orientation at zero pronation: x opposite to the hinge of the elbow.
Quat neutral_hand(const Vec3& upper_arm, const Vec3& forearm) {
  Eigen::Matrix3d axes;
  axes.col(2) = forearm.normalized();
  axes.col(0) = -upper_arm.cross(forearm).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return Quat(axes);
}

InvoluntaryMotion draw_waves(int count, double from_hz, double to_hz, const Vec3& amplitude,
                             math::RandomStream& random) {
  InvoluntaryMotion motion;
  for (int k = 0; k < count; ++k) {
    InvoluntaryMotion::Wave& wave = motion.waves.emplace_back();
    wave.amplitude = amplitude;
    wave.frequency_hz = random.uniform(from_hz, to_hz);
    for (double& phase : wave.phase) phase = random.uniform(0, kTwoPi);
  }
  return motion;
}

}  // namespace

Vec3 InvoluntaryMotion::at(double time_s) const {
  Vec3 sum = Vec3::Zero();
  for (const Wave& wave : waves) {
    const Vec3 angle = Vec3::Constant(kTwoPi * wave.frequency_hz * time_s) + wave.phase;
    sum += wave.amplitude.cwiseProduct(angle.array().sin().matrix());
  }
  return sum;
}

bool InvoluntaryMotion::is_zero() const {
  return std::ranges::all_of(waves, [](const Wave& wave) { return wave.amplitude.isZero(0); });
}

InvoluntaryMotion draw_drift(const SyntheticBody& options, math::RandomStream& random) {
  constexpr int kWaveCount = 3;
  const double amplitude = options.drift * std::sqrt(2.0 / kWaveCount);
  return draw_waves(kWaveCount, 0.05, 0.3, Vec3::Constant(amplitude), random);
}

InvoluntaryMotion draw_tremor(const SyntheticBody& options, math::RandomStream& random) {
  constexpr int kWaveCount = 3;
  constexpr double kHalfBand_hz = 0.4;
  const double hz = random.uniform(options.tremor_hz);
  const Vec3 along = random.normal_vector3().normalized();
  return draw_waves(kWaveCount, hz - kHalfBand_hz, hz + kHalfBand_hz,
                    options.tremor_amplitude / kWaveCount * along, random);
}

ArmState arm_state(const BodyMotion& motion, double time_s) {
  ArmState state = motion.arm.at(time_s);
  state.segment<3>(kWristPosition) += motion.drift.at(time_s);
  return state;
}

ArmSample arm_sample(const Subject& subject, const ArmState& state) {
  const Vec3 shoulder = state.segment<3>(kShoulderPosition),
             wrist = state.segment<3>(kWristPosition);
  const Vec3 elbow = human::elbow_from_swivel(shoulder, wrist, subject.body.arm, state[kSwivel]);
  ArmSample arm;
  arm.angles =
      human::fit_arm_angles({shoulder, elbow, wrist, neutral_hand(elbow - shoulder, wrist - elbow)})
          .angles;
  for (int k = 0; k < 3; ++k) arm.angles[4 + k] = state[kPronation + k];
  arm.pose = human::arm_pose(shoulder, subject.body.arm, arm.angles);
  return arm;
}

}  // namespace morphe::synthesize
