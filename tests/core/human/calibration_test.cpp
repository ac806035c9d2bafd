#include "core/human/calibration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace morphe::human {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A hand that points along Y, thumb up: z forward, y up, palm to the left.
const Vec3 kShoulder(0.2, 0, 0.4), kElbow(0.25, 0.05, 0.1), kWrist(0.25, 0.3, 0.1);

struct Still {
  Streams streams;
  std::vector<Pose> world_from_sensor;
};

Still calibration_pose(int frames, double noise_m) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  const auto jitter = [&] {
    return Vec3(noise_m * Vec3(normal(random), normal(random), normal(random)));
  };
  Still still;
  MarkerStream markers;
  markers.names = {"little_mcp", "shoulder", "elbow", "wrist", "index_mcp", "middle_mcp"};
  const Vec3 at[] = {
      kWrist + Vec3(0.01, 0.07, -0.05), kShoulder, kElbow, kWrist, kWrist + Vec3(0.01, 0.09, 0.03),
      kWrist + Vec3(0, 0.09, 0)};
  BodyStream sensors;
  sensors.names = {"wrist", "shoulder", "elbow"};
  const Vec3 mounts[] = {{0.01, -0.02, 0.03}, {0, 0.04, 0.02}, {-0.03, 0.01, 0}};
  const Vec3 joints[] = {kWrist, kShoulder, kElbow};
  markers.position = Array2D<Vec3>(static_cast<std::size_t>(frames), 6, Vec3::Zero());
  sensors.position = Array2D<Vec3>(static_cast<std::size_t>(frames), 3, Vec3::Zero());
  sensors.orientation = Array2D<Quat>(static_cast<std::size_t>(frames), 3, Quat::Identity());
  for (std::size_t s = 0; s < 3; ++s) {
    const Quat turned(Eigen::AngleAxisd(0.5 + 1.2 * static_cast<double>(s),
                                        Vec3(1, 2, static_cast<double>(s)).normalized()));
    still.world_from_sensor.push_back(make_pose(joints[s] + mounts[s], turned));
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i) {
    markers.time.push_back(static_cast<double>(i) / 240);
    sensors.time.push_back(static_cast<double>(i) / 240);
    for (std::size_t k = 0; k < 6; ++k) markers.position(i, k) = at[k] + jitter();
    for (std::size_t s = 0; s < 3; ++s) {
      const Pose& pose = still.world_from_sensor[s];
      sensors.position(i, s) = pose.translation() + jitter();
      sensors.orientation(i, s) = Quat(pose.linear());
      if (i % 2 == 1) sensors.orientation(i, s).coeffs() *= -1;  // the same rotation
    }
  }
  still.streams.markers = markers;
  still.streams.sensors = sensors;
  return still;
}

TEST(SensorOffsets, CarryTheSensorsToJointsAndHand) {
  const Still still = calibration_pose(6, 0);
  std::vector<std::string> problems;
  const SensorOffsets offsets = sensor_offsets(still.streams, problems);
  EXPECT_THAT(problems, ElementsAre());
  ASSERT_THAT(offsets.sensors, ElementsAre("wrist", "shoulder", "elbow"));
  const Vec3 joints[] = {kWrist, kShoulder, kElbow};
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_LT((still.world_from_sensor[s] * offsets.joint_in_sensor[s] - joints[s]).norm(), 1e-12);
  }
  const Quat hand = Quat(still.world_from_sensor[0].linear()) * offsets.sensor_from_segment[0];
  Eigen::Matrix3d wanted;  // x to the left, y up, z forward
  wanted << -1, 0, 0, 0, 0, 1, 0, 1, 0;
  EXPECT_LT((hand.toRotationMatrix() - wanted).norm(), 1e-12);
  EXPECT_LT(angle_between(offsets.sensor_from_segment[1], Quat::Identity()), 1e-12);
}

TEST(SensorOffsets, AverageTheNoiseOfAStillPose) {
  const Still still = calibration_pose(400, 0.001);
  std::vector<std::string> problems;
  const SensorOffsets offsets = sensor_offsets(still.streams, problems);
  ASSERT_EQ(offsets.sensors.size(), 3U);
  EXPECT_LT((still.world_from_sensor[0] * offsets.joint_in_sensor[0] - kWrist).norm(), 0.0003);
}

TEST(SensorOffsets, SayWhatIsMissing) {
  std::vector<std::string> problems;
  EXPECT_TRUE(sensor_offsets({}, problems).sensors.empty());
  EXPECT_TRUE(problems.empty());

  Streams streams = calibration_pose(3, 0).streams;
  streams.markers->names[2] = "knee";
  streams.markers->names[4] = "nose";
  SensorOffsets offsets = sensor_offsets(streams, problems);
  EXPECT_THAT(offsets.sensors, ElementsAre("shoulder"));
  EXPECT_THAT(problems, ElementsAre(HasSubstr("middle_mcp, index_mcp and little_mcp; sensor wrist"),
                                    HasSubstr("no point elbow was digitised")));
  problems.clear();
  streams = calibration_pose(3, 0).streams;
  for (std::size_t i = 0; i < 3; ++i) streams.sensors->position(i, 1) = unknown_point();
  offsets = sensor_offsets(streams, problems);
  EXPECT_THAT(offsets.sensors, ElementsAre("wrist", "elbow"));
  EXPECT_THAT(problems, ElementsAre(HasSubstr("never both recorded; sensor shoulder")));
}

}  // namespace
}  // namespace morphe::human
