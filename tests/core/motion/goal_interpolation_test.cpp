#include "core/motion/goal_interpolation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace morphe {
namespace {

Goals two_frames() {
  Goals goals;
  goals.time = {1, 3};
  goals.tip_position = {2, 2, unknown_point()};
  goals.tip_position(0, 0) = Vec3(0, 0, 0);
  goals.tip_position(1, 0) = Vec3(4, 0, -2);
  goals.tip_position(0, 1) = Vec3(1, 1, 1);  // not seen in the second frame
  return goals;
}

TEST(GoalsAt, LinearBetweenFramesAndHeldAtTheEnds) {
  const Goals goals = two_frames();
  EXPECT_LT((tip_goal_at(goals, 0, 1.5) - Vec3(1, 0, -0.5)).norm(), 1e-15);
  EXPECT_EQ(tip_goal_at(goals, 0, 3), goals.tip_position(1, 0));
  EXPECT_EQ(tip_goal_at(goals, 0, 7), goals.tip_position(1, 0));
  EXPECT_EQ(tip_goal_at(goals, 0, -1), goals.tip_position(0, 0));
  EXPECT_TRUE(is_known(tip_goal_at(goals, 1, 1)));
  EXPECT_FALSE(is_known(tip_goal_at(goals, 1, 1.001)));
}

TEST(GoalsAt, OrientationsTurnAtAnEvenRate) {
  Goals goals = two_frames();
  EXPECT_FALSE(is_known(tip_orientation_goal_at(goals, 0, 2))) << "none at all";
  goals.tip_orientation = {2, 2, unknown_rotation()};
  goals.tip_orientation(0, 0) = Quat::Identity();
  goals.tip_orientation(1, 0) = Quat(Eigen::AngleAxisd(1.2, Vec3::UnitZ()));
  const Quat third(Eigen::AngleAxisd(0.4, Vec3::UnitZ()));
  EXPECT_LT(tip_orientation_goal_at(goals, 0, 1 + 2.0 / 3).angularDistance(third), 1e-12);
  EXPECT_FALSE(is_known(tip_orientation_goal_at(goals, 1, 2)));
}

TEST(GoalsAt, AColumnOfPoints) {
  const FrameInterpolation at = frame_interpolation(two_frames(), 2);
  EXPECT_EQ(interpolate_point({Vec3(1, 0, 0), Vec3(2, 0, 0)}, at), Vec3(1.5, 0, 0));
  EXPECT_FALSE(is_known(interpolate_point({}, at)));
}

TEST(ObjectNamed, TheFirstOrNone) {
  std::vector<SceneObject> objects(3);
  objects[1].name = objects[2].name = "cup";
  EXPECT_EQ(find_object(objects, "cup"), &objects[1]);
  EXPECT_EQ(find_object(objects, "table"), nullptr);
}

}  // namespace
}  // namespace morphe
