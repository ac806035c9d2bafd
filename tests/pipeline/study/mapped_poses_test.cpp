#include "pipeline/study/mapped_poses.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/robot/files/generate.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::study {
namespace {

const std::filesystem::path kRecordings =
    std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/ue-adl/recordings.yaml";
constexpr human::ArmLengths kLengths{0.323, 0.254};

TEST(HumanPoses, HaveTheLengthsAskedForAndTheDirectionsRecorded) {
  const std::vector<HumanPoses> series = arm_poses(kRecordings, kLengths, 0.1);
  const std::vector<HumanPoses> longer = arm_poses(kRecordings, {0.5, 0.4}, 0.1);
  ASSERT_EQ(series.size(), 5u);
  ASSERT_EQ(longer.size(), 5u);
  for (std::size_t k = 0; k < series.size(); ++k) {
    ASSERT_GT(series[k].size(), 8u);
    ASSERT_EQ(series[k].size(), longer[k].size());
    for (std::size_t f = 0; f < series[k].size(); ++f) {
      const HumanPose &one = series[k][f], &other = longer[k][f];
      EXPECT_NEAR(one.elbow.norm(), kLengths.upper_arm, 1e-12);
      EXPECT_NEAR((one.wrist - one.elbow).norm(), kLengths.forearm, 1e-12);
      EXPECT_LT((one.elbow.normalized() - other.elbow.normalized()).norm(), 1e-12);
      EXPECT_LT((one.tip[1] - one.wrist - other.tip[1] + other.wrist).norm(), 1e-12);
    }
  }
}

/// Goals that an arm takes itself are met, with an elbow on its only centre at no cost.
TEST(MappedPoses, FindsThePosturesThatMadeTheGoals) {
  const robot::Robot robot(robot::generate_arm({.joints = 6, .length = 0.6}));
  HumanPoses poses;
  std::vector<Pose> frames;
  for (int f = 0; f < 12; ++f) {
    JointVector q(6);
    for (int j = 0; j < 6; ++j) q[j] = 0.7 * std::sin(0.15 * f + 1.3 * j);
    robot::forward_kinematics(robot, q, frames);
    HumanPose pose;
    const Pose wrist = robot::tip_pose(robot, frames, 0);
    pose.wrist = wrist.translation();
    pose.hand = Quat(wrist.linear());
    ASSERT_EQ(robot.joint_centres.size(), 1u);
    pose.elbow = frames[static_cast<std::size_t>(robot.joint_centres[0].frame)].translation();
    poses.push_back(pose);
  }
  const std::vector<humanlike::FrameGoal> goals = goals_of(robot, poses, Pose::Identity());
  for (const char* algorithm : {"trust_region", "tnewton"}) {
    solve::MinimiseOptions options;
    options.algorithm = algorithm;
    const MappedPoses mapped = map_poses(robot, goals, {}, options, 8, 1);
    for (std::size_t f = 0; f < poses.size(); ++f) {
      EXPECT_LT(mapped.position_m[f], 1e-6) << algorithm << f;
      EXPECT_LT(mapped.orientation_rad[f], 1e-4) << algorithm << f;
      EXPECT_LT(mapped.humanlike_m2[f], 1e-9) << algorithm << f;
    }
    const MappedPoses again = measure_poses(robot, goals, mapped.q);
    EXPECT_EQ(again.position_m, mapped.position_m);
    EXPECT_EQ(again.humanlike_m2, mapped.humanlike_m2);
  }
}

}  // namespace
}  // namespace morphe::study
