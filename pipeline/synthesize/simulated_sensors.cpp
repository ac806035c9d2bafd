#include "pipeline/synthesize/simulated_sensors.hpp"

namespace morphe::synthesize {
namespace {

NoiseModel noise_model(const SyntheticSensors& o) {
  return {o.correlated_noise_share, o.correlation_time_s, o.rate_hz};
}
class PoseNoise {
 public:
  PoseNoise(const SyntheticSensors& o, math::RandomStream& random)
      : position_(noise_model(o), o.position_noise, random),
        rotation_(noise_model(o), o.orientation_noise, random) {}
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
  for (int k = 0; k < 3; ++k) segment_from_sensor[k] = Quat(mounts.segment_from_sensor[k].linear());
  std::array<PoseNoise, 3> noise{PoseNoise(options, random), PoseNoise(options, random),
                                 PoseNoise(options, random)};
  for (int i = 0; i < std::ssize(arm); ++i) {
    stream.time.push_back(i / options.rate_hz);
    const human::ArmPose& pose = arm[i].pose;
    const std::array<Vec3, 3> joint = {pose.shoulder, pose.elbow, pose.wrist};
    const std::array<Quat, 3> axes = {Quat::Identity(), upper_arm_axes(pose), pose.world_from_hand};
    for (int k = 0; k < 3; ++k) {
      Vec3& position = stream.position(i, k);
      Quat& orientation = stream.orientation(i, k);
      position = joint[k] + axes[k] * mounts.segment_from_sensor[k].translation();
      orientation = axes[k] * segment_from_sensor[k];
      noise[k].add_to(position, orientation);
    }
  }
  return stream;
}

void apply_dropouts(const SyntheticSensors& options, math::RandomStream& random, BodyStream& body) {
  for (int k = 0; k < std::ssize(body.names); ++k) {
    const std::vector<bool> lost = draw_dropouts(body.time.size(), options.rate_hz,
                                                 options.dropout_share, options.dropout_s, random);
    for (int i = 0; i < std::ssize(lost); ++i) {
      if (!lost[i]) continue;
      body.position(i, k) = unknown_point();
      body.orientation(i, k) = unknown_rotation();
    }
  }
}

void add_noise(const SyntheticSensors& options, math::RandomStream& random, SceneObject& object) {
  PoseNoise noise(options, random);
  for (int i = 0; i < std::ssize(object.time); ++i)
    noise.add_to(object.position[i], object.orientation[i]);
}

}  // namespace morphe::synthesize
