#include "pipeline/synthesize/calibration_pose.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::synthesize {
namespace {

/// Returns the knuckles of the flat hand in the hand frame: index, middle, little.
std::array<Vec3, 3> knuckles(const RobotModel& hand) {
  std::vector<Pose> hand_from_frame;
  robot::forward_kinematics(hand, flat_hand(), hand_from_frame);
  std::array<Vec3, 3> points;
  constexpr const char* kNames[] = {"index_mcp", "middle_mcp", "little_mcp"};
  for (int k = 0; k < std::ssize(points); ++k) {
    const auto frame = std::ranges::find(hand.frames, kNames[k], &RobotModel::Frame::name);
    points[k] = hand_from_frame[frame - hand.frames.begin()].translation();
  }
  return points;
}

MarkerStream digitise(const SyntheticSensors& options, const Subject& subject,
                      const human::ArmPose& pose, math::RandomStream& random) {
  MarkerStream markers;
  markers.names = {"shoulder", "elbow", "wrist", "index_mcp", "middle_mcp", "little_mcp"};
  std::vector<Vec3> points = {pose.shoulder, pose.elbow, pose.wrist};
  for (const Vec3& knuckle : knuckles(subject.hand))
    points.push_back(pose.wrist + pose.world_from_hand * knuckle);
  const int count = options.digitisation_count;
  markers.position = Array2D<Vec3>(count, points.size(), Vec3::Zero());
  for (int i = 0; i < count; ++i) {
    markers.time.push_back(options.calibration_s * i / count);
    for (int k = 0; k < std::ssize(points); ++k)
      markers.position(i, k) = points[k] + options.digitising_noise * random.normal_vector3();
  }
  return markers;
}

}  // namespace

Streams simulate_calibration(const SynthesizeOptions& options, const Subject& subject,
                             const ArmState& resting, const SensorMounts& mounts,
                             const GloveBias& bias, math::RandomStream& random) {
  ArmState straight = resting;
  straight[kFlexion] = straight[kDeviation] = 0;
  const ArmSample arm = arm_sample(subject, straight);
  const SyntheticSensors& o = options.sensors;
  const auto count = std::lround(std::floor(o.calibration_s * o.rate_hz)) + 1;
  Streams calibration;
  calibration.sensors = simulate_sensors(o, mounts, std::vector<ArmSample>(count, arm), random);
  calibration.markers = digitise(o, subject, arm.pose, random);
  calibration.hand = simulate_glove(
      options.glove, bias, [](double) { return human::GloveAngles{}; }, o.calibration_s, 0, random);
  return calibration;
}

}  // namespace morphe::synthesize
