#include "pipeline/synthesize/simulated_sensors.hpp"

namespace morphe::synthesize {
namespace {

NoiseModel noise_law(const SyntheticSensors& o) {
  return {o.correlated_noise_share, o.correlation_time_s, o.rate_hz};
}

/// The position and orientation noise of one tracked body.
class PoseNoise {
 public:
  PoseNoise(const SyntheticSensors& o, math::RandomStream& random)
      : position_(noise_law(o), o.position_noise, random),
        rotation_(noise_law(o), o.orientation_noise, random) {}
  void add_to(Vec3& position, Quat& orientation) {
    position += position_.next();
    const Vec3 half_turn = 0.5 * rotation_.next();
    orientation *= Quat(1, half_turn.x(), half_turn.y(), half_turn.z());
    orientation.normalize();
  }

 private:
  SensorNoise<3> position_, rotation_;
};

/// Returns axes fixed to the upper arm: z along it, x along the hinge of the elbow, which is bent.
Quat upper_arm_axes(const human::ArmPose& arm) {
  Eigen::Matrix3d axes;
  axes.col(2) = (arm.shoulder - arm.elbow).normalized();
  axes.col(0) = axes.col(2).cross(arm.elbow - arm.wrist).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return Quat(axes);
}

}  // namespace

SensorMounts draw_mounts(const SyntheticSensors& options, math::RandomStream& random) {
  SensorMounts mounts;
  for (Pose& mount : mounts.segment_from_sensor) {
    const Vec3 away = random.normal_vector3().normalized() * random.uniform(options.sensor_offset);
    mount = make_pose(away, random.rotation());
  }
  return mounts;
}

BodyStream simulate_sensors(const SyntheticSensors& options, const SensorMounts& mounts,
                            const std::vector<ArmSample>& arm, math::RandomStream& random) {
  BodyStream stream;
  stream.names = {"shoulder", "elbow", "wrist"};
  stream.position = Array2D<Vec3>(arm.size(), 3, Vec3::Zero());
  stream.orientation = Array2D<Quat>(arm.size(), 3, Quat::Identity());
  std::array<Quat, 3> segment_from_sensor;
  for (std::size_t k = 0; k < 3; ++k) {
    segment_from_sensor[k] = Quat(mounts.segment_from_sensor[k].linear());
  }
  std::array<PoseNoise, 3> noise{PoseNoise(options, random), PoseNoise(options, random),
                                 PoseNoise(options, random)};
  for (std::size_t i = 0; i < arm.size(); ++i) {
    stream.time.push_back(static_cast<double>(i) / options.rate_hz);
    const human::ArmPose& pose = arm[i].pose;
    const std::array<Vec3, 3> joint = {pose.shoulder, pose.elbow, pose.wrist};
    const std::array<Quat, 3> segment = {Quat::Identity(), upper_arm_axes(pose),
                                         pose.world_from_hand};
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3& position = stream.position(i, k);
      Quat& orientation = stream.orientation(i, k);
      position = joint[k] + segment[k] * mounts.segment_from_sensor[k].translation();
      orientation = segment[k] * segment_from_sensor[k];
      noise[k].add_to(position, orientation);
    }
  }
  return stream;
}

void drop(const SyntheticSensors& options, math::RandomStream& random, BodyStream& sensors) {
  for (std::size_t k = 0; k < sensors.names.size(); ++k) {
    const std::vector<bool> lost = draw_dropouts(sensors.time.size(), options.rate_hz,
                                                 options.dropout_share, options.dropout_s, random);
    for (std::size_t i = 0; i < lost.size(); ++i) {
      if (!lost[i]) continue;
      sensors.position(i, k) = unknown_point();
      sensors.orientation(i, k) = unknown_rotation();
    }
  }
}

void add_noise(const SyntheticSensors& options, math::RandomStream& random, SceneObject& object) {
  PoseNoise noise(options, random);
  for (std::size_t i = 0; i < object.time.size(); ++i) {
    noise.add_to(object.position[i], object.orientation[i]);
  }
}

}  // namespace morphe::synthesize
