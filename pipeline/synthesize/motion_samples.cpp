#include "pipeline/synthesize/motion_samples.hpp"

#include <cmath>

namespace morphe::synthesize {

MotionSamples sample_motion(const Subject& subject, const Script& script, double rate_hz) {
  MotionSamples samples;
  samples.rate_hz = rate_hz;
  const auto count = std::lround(std::floor(script.length_s * rate_hz)) + 1;
  samples.tip = Array2D<Vec3>(count, kFingerCount, Vec3::Zero());
  const bool trembles = !script.motion.tremor.is_zero();
  std::vector<Pose> frames;
  for (int i = 0; i < count; ++i) {
    const double t = samples.time(i);
    const ArmState state = arm_state(script.motion, t);
    ArmState trembling = state;
    if (trembles) trembling.segment<3>(kWristPosition) += script.motion.tremor.at(t);
    samples.arm.push_back(arm_sample(subject, trembling));
    samples.hand.push_back(script.motion.hand.at(t));
    const human::HandPoints points =
        human::hand_points(subject.hand, hand_angles(samples.hand.back()), frames);
    const human::ArmPose& pose = samples.arm.back().pose;
    for (std::size_t finger = 0; finger < kFingerCount; ++finger)
      samples.tip(i, finger) = pose.wrist + pose.world_from_hand * points.tip[finger];
    samples.aperture.push_back((points.tip[0] - points.tip[1]).norm());
    if (trembles) {
      const human::ArmPose steady = arm_sample(subject, state).pose;
      samples.index_without_tremor.push_back(steady.wrist + steady.world_from_hand * points.tip[1]);
    } else {
      samples.index_without_tremor.push_back(samples.tip(i, 1));
    }
  }
  return samples;
}

}  // namespace morphe::synthesize
