#include "pipeline/synthesize/body_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morphe::synthesize {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// The hand's orientation on a forearm at zero pronation: x against the elbow's hinge.
Quat neutral_hand(const Vec3& upper_arm, const Vec3& forearm) {
  Eigen::Matrix3d axes;
  axes.col(2) = forearm.normalized();
  axes.col(0) = -upper_arm.cross(forearm).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return Quat(axes);
}

Unrest draw_waves(int count, double from_hz, double to_hz, const Vec3& amplitude,
                  math::RandomStream& random) {
  Unrest unrest;
  for (int k = 0; k < count; ++k) {
    Unrest::Wave& wave = unrest.waves.emplace_back();
    wave.amplitude = amplitude;
    wave.hz = random.uniform(from_hz, to_hz);
    for (double& phase : wave.phase) phase = random.uniform(0, kTurn);
  }
  return unrest;
}

}  // namespace

Vec3 Unrest::at(double time_s) const {
  Vec3 sum = Vec3::Zero();
  for (const Wave& wave : waves) {
    const Vec3 angle = Vec3::Constant(kTurn * wave.hz * time_s) + wave.phase;
    sum += wave.amplitude.cwiseProduct(angle.array().sin().matrix());
  }
  return sum;
}

bool Unrest::still() const {
  return std::ranges::all_of(waves, [](const Wave& wave) { return wave.amplitude.isZero(0); });
}

Unrest draw_drift(const SyntheticBody& options, math::RandomStream& random) {
  constexpr int kWaves = 3;
  const double amplitude = options.drift * std::sqrt(2.0 / kWaves);
  return draw_waves(kWaves, 0.05, 0.3, Vec3::Constant(amplitude), random);
}

Unrest draw_tremor(const SyntheticBody& options, math::RandomStream& random) {
  constexpr int kWaves = 3;
  constexpr double kHalfBand = 0.4;  // [Hz]
  const double hz = random.uniform(options.tremor_hz);
  const Vec3 along = random.normals().normalized();
  return draw_waves(kWaves, hz - kHalfBand, hz + kHalfBand, options.tremor / kWaves * along,
                    random);
}

ArmState arm_state(const BodyMotion& motion, double time_s) {
  ArmState state = motion.arm.at(time_s);
  state.segment<3>(kWristAt) += motion.drift.at(time_s);
  return state;
}

ArmAt arm_at(const Subject& subject, const ArmState& state) {
  const Vec3 shoulder = state.segment<3>(kShoulderAt), wrist = state.segment<3>(kWristAt);
  const Vec3 elbow = human::natural_elbow(shoulder, wrist, subject.body.arm, state[kSwivel]);
  ArmAt arm;
  arm.angles =
      human::fit_arm_angles({shoulder, elbow, wrist, neutral_hand(elbow - shoulder, wrist - elbow)})
          .angles;
  for (int k = 0; k < 3; ++k) {
    arm.angles[static_cast<std::size_t>(4 + k)] = state[kPronation + k];
  }
  arm.pose = human::arm_pose(shoulder, subject.body.arm, arm.angles);
  return arm;
}

}  // namespace morphe::synthesize
