#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "pipeline/planning/place_movement.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "tests/pipeline/planning/robot_demonstration.hpp"

namespace morphe::planning {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The person's left arm reaches straight for the robot's elbow, across the plane of its arm, is
/// there at 0.75 s and leaves again: `gap_m` is between the elbow's centre and the fingertips.
Demonstration other_arm_at_the_elbow(const test::RobotDemonstration& of, double gap_m) {
  const HumanMotion& motion = of.motion;
  const Vec3 normal =
      (motion.elbow[75] - motion.shoulder[75]).cross(motion.wrist[75] - motion.elbow[75]);
  const Vec3 out = normal.normalized(), aside = normal.unitOrthogonal();
  Demonstration demonstration;
  demonstration.name = "robot";
  BodyStream& body = demonstration.streams.skeleton.emplace();
  body.names = {"left_shoulder", "left_elbow", "left_wrist"};
  body.parents = {"", "left_shoulder", "left_elbow"};
  body.time = motion.time;
  body.position = Array2D<Vec3>(motion.time.size(), 3, unknown_point());
  body.orientation = Array2D<Quat>(motion.time.size(), 3, unknown_rotation());
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    const double away_m = 0.4 * std::pow(std::sin(M_PI / 2 * (motion.time[i] - 0.75)), 2);
    const Vec3 tips = motion.elbow[75] + (gap_m + away_m) * out;
    const Vec3 wrist = tips + 0.25 * 0.108 / 0.146 * out, elbow = wrist + 0.25 * out;
    body.position(i, 2) = wrist;
    body.position(i, 1) = elbow;
    body.position(i, 0) = elbow + 0.3 * aside;
  }
  return demonstration;
}

/// Least distance from the robot to an object of that name, at the trajectory's samples: capsules
/// against capsules by points along them, as nothing in the planner does it.
double least_distance(const robot::Robot& robot, const Trajectory& trajectory,
                      const SceneObject& object) {
  constexpr int kPoints = 60;
  double least_m = kInfinity;
  std::vector<Pose> frames;
  for (std::size_t i = 0; i < trajectory.samples(); ++i) {
    const JointVector q = trajectory.position.row(static_cast<Eigen::Index>(i)).transpose();
    robot::forward_kinematics(robot, q, frames);
    const Pose pose = recorded_pose(object, trajectory.demonstration_time[i]);
    for (const RobotModel::Capsule& capsule : robot.capsules) {
      const Pose base_from_frame =
          capsule.frame < 0 ? Pose::Identity() : frames[static_cast<std::size_t>(capsule.frame)];
      const Vec3 from = pose.inverse() * (base_from_frame * capsule.from),
                 to = pose.inverse() * (base_from_frame * capsule.to);
      for (int k = 0; k <= kPoints; ++k) {
        const Vec3 point = from + static_cast<double>(k) / kPoints * (to - from);
        const double half_m = object.size[1] / 2;
        const Vec3 on_axis(0, 0, std::clamp(point.z(), -half_m, half_m));
        least_m = std::min(least_m, (point - on_axis).norm() - capsule.radius - object.size[0]);
      }
    }
  }
  return least_m;
}

Plan plan_beside(const test::RobotDemonstration& of, Demonstration demonstration,
                 std::vector<std::string>& notes) {
  std::ranges::copy(other_arm_obstacles(of.planner(), demonstration, notes),
                    std::back_inserter(demonstration.objects));
  return plan_movement(of.planner(), demonstration, of.motion, of.movement);
}

TEST(OtherArm, IsPassedAtTheMarginOnlyIfAskedFor) {
  test::RobotDemonstration of;
  const Demonstration demonstration = other_arm_at_the_elbow(of, 0.06);
  std::vector<std::string> notes;
  const Plan through = plan_beside(of, demonstration, notes);
  ASSERT_TRUE(through.executable()) << through.detail;
  EXPECT_THAT(through.scene.objects, IsEmpty());
  EXPECT_THAT(notes, IsEmpty());

  of.config.scene.other_arm = true;
  const Plan around = plan_beside(of, demonstration, notes);
  ASSERT_EQ(around.scene.objects.size(), 3u);
  ASSERT_TRUE(around.executable()) << around.detail;
  EXPECT_TRUE(around.repaired);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("no fingertip seen in 201 of 201 frames")));
  const auto found = std::ranges::any_of(around.findings, [](const Finding& finding) {
    return finding.other_body == "other hand" || finding.subject == "other hand";
  });
  EXPECT_TRUE(found) << "what was in the way stays on record under its name";
  for (const SceneObject& part : around.scene.objects) {
    EXPECT_GE(least_distance(of.robot, around.trajectory, part),
              around.tolerances.required_clearance - 1e-6)
        << part.name;
  }
  EXPECT_LT(least_distance(of.robot, through.trajectory, around.scene.objects[2]), -0.01);
}

TEST(OtherArm, OneThatIsNoPersonsIsSaidToBeSo) {
  // Straight back from the shoulder, palm up.
  test::RobotDemonstration of;
  of.config.scene.other_arm = true;
  Demonstration demonstration;
  BodyStream& body = demonstration.streams.skeleton.emplace();
  body.names = {"left_shoulder", "left_elbow", "left_wrist", "left_hand"};
  body.parents = {"", "left_shoulder", "left_elbow", "left_wrist"};
  body.time = of.motion.time;
  body.position = Array2D<Vec3>(body.time.size(), 4, unknown_point());
  body.orientation = Array2D<Quat>(body.time.size(), 4, unknown_rotation());
  Eigen::Matrix3d hand;
  hand.col(2) = -Vec3::UnitY();
  hand.col(0) = Vec3::UnitZ();
  hand.col(1) = hand.col(2).cross(hand.col(0));
  for (std::size_t i = 0; i < body.time.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double back_m = std::array{0.0, 0.3, 0.55, 0.55}[k];
      body.position(i, k) = Vec3(-0.2, -back_m, 1.4);
      body.orientation(i, k) = Quat(hand);
    }
  }
  std::vector<std::string> notes;
  EXPECT_EQ(other_arm_obstacles(of.planner(), demonstration, notes).size(), 3u);
  EXPECT_THAT(notes, testing::Contains(HasSubstr(
                         "other arm is implausible, but still an obstacle: elbow and wrist are")));
}

TEST(OtherArm, AHandAloneHasNone) {
  test::RobotDemonstration of;
  of.config.scene.other_arm = true;
  robot::Robot hand{robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/dlr_hit2.yaml").table};
  std::vector<std::string> notes;
  EXPECT_THAT(other_arm_obstacles({of.config, hand}, other_arm_at_the_elbow(of, 0.06), notes),
              IsEmpty());
  EXPECT_THAT(notes, ElementsAre(HasSubstr("a hand without an arm has no position in the world")));
}

TEST(OtherArm, ARecordedObjectOfThatNameStaysWhatItIs) {
  test::RobotDemonstration of;
  of.config.scene.other_arm = true;
  Demonstration demonstration = other_arm_at_the_elbow(of, 0.06);
  demonstration.objects.emplace_back().name = "other hand";
  std::vector<std::string> notes;
  const auto capsules = other_arm_obstacles(of.planner(), demonstration, notes);
  ASSERT_EQ(capsules.size(), 2u);
  EXPECT_EQ(capsules[1].name, "other forearm");
  EXPECT_THAT(notes, testing::Contains(HasSubstr("other hand was recorded as an object")));
}

}  // namespace
}  // namespace morphe::planning
