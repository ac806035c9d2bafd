#include "stages/certify/grasp.hpp"

#include <gtest/gtest.h>

#include "tests/stages/certify/planar_arm.hpp"

namespace morphe::certify {
namespace {

/// The index opens to 1 rad at 0.4 s and closes again until 1 s.
Trajectory opening() {
  Trajectory t;
  for (int i = 0; i <= 10; ++i) t.time.push_back(0.1 * i);
  t.demonstration_time = t.time;
  t.position = t.velocity = t.acceleration = JointRows::Zero(11, 3);
  for (int i = 0; i <= 10; ++i) {
    t.position(i, 0) = 0.05 * i;
    t.position(i, 2) = i <= 4 ? -0.25 * i : -(10 - i) / 6.0;
  }
  return t;
}

struct Scenery {
  Scene scene;
  Movement movement;
  Scenery() {
    SceneObject cup;
    cup.name = "cup";
    cup.shape = Shape::cylinder;
    cup.size = {0.03, 0.1};
    cup.time = {0};
    cup.position = {Vec3(0.5, 0.2, 0)};
    cup.orientation = {Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()))};
    scene.objects = {cup};
    movement.target = "cup";
    movement.phases = {{PhaseKind::reach, 0, 0.8, 1}, {PhaseKind::grasp, 0.8, 1, 1}};
  }
};

TEST(Grasp, InTheObjectsFrame) {
  const Scenery s;
  const Trajectory t = opening();
  const Grasp grasp = find_grasp(planar_arm(), s.scene, s.movement, t);
  ASSERT_EQ(grasp.sample, 8);
  const double shoulder = 0.4, index = -2 / 6.0;
  const Eigen::Rotation2Dd arm(shoulder), whole(shoulder + index);
  // Turning by -90° takes base coordinates into the object's: (x, y) -> (y, -x).
  const auto in_object = [](const Eigen::Vector2d& p) {
    return Vec3(p.y() - 0.2, -(p.x() - 0.5), 0);
  };
  const Eigen::Vector2d wrist = arm * Eigen::Vector2d(0.55, 0);
  ASSERT_EQ(grasp.tips_in_object.size(), 2u);
  EXPECT_LT((grasp.tips_in_object[0] - in_object(arm * Eigen::Vector2d(0.55, 0.04))).norm(), 1e-12);
  EXPECT_LT((grasp.tips_in_object[1] - in_object(wrist + whole * Eigen::Vector2d(0, -0.04))).norm(),
            1e-12);
  const Vec3 palm = grasp.object_from_palm.translation();
  EXPECT_LT((palm - in_object(arm * Eigen::Vector2d(0.3, 0))).norm(), 1e-12);
  // The palm's chords to the samples before are 15, 30, 45 and 60 mm.
  const Eigen::Vector2d earlier = Eigen::Rotation2Dd(0.2) * Eigen::Vector2d(0.3, 0);
  const Vec3 way = palm - in_object(earlier);
  EXPECT_LT((grasp.approach_direction - way / way.norm()).norm(), 1e-12);
  // Turned by the shoulder's angle less the object's quarter turn.
  EXPECT_TRUE(grasp.object_from_palm.linear().isApprox(
      Eigen::AngleAxisd(shoulder - M_PI / 2, Vec3::UnitZ()).toRotationMatrix(), 1e-12));
  EXPECT_LT((grasp.base_from_object.translation() - Vec3(0.5, 0.2, 0)).norm(), 1e-15);
  EXPECT_NEAR(grasp.grasp_posture[0], shoulder, 1e-12);
  EXPECT_NEAR(grasp.grasp_posture[2], index, 1e-12);
}

TEST(Grasp, AMovingObjectCountsWhereItIsThen) {
  Scenery s;
  SceneObject& cup = s.scene.objects[0];
  cup.time = {0.7, 0.9};
  cup.position = {Vec3(0.4, 0.2, 0), Vec3(0.6, 0.2, 0.1)};
  cup.orientation = {Quat::Identity(), Quat(Eigen::AngleAxisd(0.8, Vec3::UnitX()))};
  const Grasp grasp = find_grasp(planar_arm(), s.scene, s.movement, opening());
  const Pose middle = make_pose(Vec3(0.5, 0.2, 0.05), Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX())));
  EXPECT_TRUE(grasp.base_from_object.isApprox(middle, 1e-12));
  EXPECT_TRUE((grasp.base_from_object * grasp.object_from_palm)
                  .isApprox(make_pose(Eigen::AngleAxisd(0.4, Vec3::UnitZ()) * Vec3(0.3, 0, 0),
                                      Quat(Eigen::AngleAxisd(0.4, Vec3::UnitZ()))),
                            1e-12));
}

TEST(Grasp, PregraspIsTheWidestOpening) {
  // Thumb at +0.04 beside the wrist, index tip turning about it: farthest apart at 0 rad.
  const Scenery s;
  Trajectory t = opening();
  t.position.col(2).array() += 1;
  const Grasp grasp = find_grasp(planar_arm(), s.scene, s.movement, t);
  EXPECT_NEAR(grasp.pregrasp_posture[2], 0, 1e-12);
  EXPECT_NEAR(grasp.pregrasp_posture[0], 0.2, 1e-12);
}

TEST(Grasp, APalmThatHardlyMovesComesFromNowhere) {
  const Scenery s;
  Trajectory t = opening();
  t.position.col(0).setZero();
  EXPECT_FALSE(is_known(find_grasp(planar_arm(), s.scene, s.movement, t).approach_direction));
}

TEST(Grasp, NoneWithoutTargetOrPhase) {
  Scenery s;
  EXPECT_EQ(find_grasp(planar_arm(), s.scene, s.movement, Trajectory{}).sample, -1);
  s.movement.target = "plate";
  EXPECT_EQ(find_grasp(planar_arm(), s.scene, s.movement, opening()).sample, -1);
  s = Scenery();
  s.movement.phases = {{PhaseKind::reach, 0, 1, 1}};
  EXPECT_EQ(find_grasp(planar_arm(), s.scene, s.movement, opening()).sample, -1);
}

}  // namespace
}  // namespace morphe::certify
