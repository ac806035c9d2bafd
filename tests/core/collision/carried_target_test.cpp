#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/collision/constants.hpp"
#include "core/collision/continuous_check.hpp"
#include "core/collision/fcl_engine.hpp"

namespace morphe::collision {
namespace {

SceneObject still_body(const std::string& name, Shape shape, std::vector<double> size,
                       const Vec3& position) {
  SceneObject body;
  body.name = name;
  body.shape = shape;
  body.size = std::move(size);
  body.time = {0};
  body.position = {position};
  body.orientation = {Quat::Identity()};
  return body;
}

/// A hand that slides along x and z with a cup of 0.1 m that stands on a table whose top is at 0.
/// The hand takes it at 1 s, lifts it, carries it along x and puts it down at 4 s.
struct Lifting {
  robot::Robot robot;
  Scene scene;
  Movement movement;
  std::vector<double> time = {0, 1, 1.5, 2, 3, 4, 5};
  JointRows position;
  CollisionWorld world;
  CollisionScratch scratch;

  explicit Lifting(double taken_m, double put_down_m, bool in_palm = true) {
    RobotModel model;
    model.joint_names = {"x", "z"};
    model.lower = JointVector::Constant(2, -3);
    model.upper = JointVector::Constant(2, 3);
    for (int joint = 0; joint < 2; ++joint) {
      RobotModel::Frame frame;
      frame.parent = joint - 1;
      frame.name = joint == 0 ? "slider" : "palm";
      frame.joint = joint;
      frame.prismatic = true;
      frame.axis = joint == 0 ? Vec3::UnitX() : Vec3::UnitZ();
      model.frames.push_back(frame);
    }
    model.capsules.push_back({"hand", 1, Vec3(0, 0, 0.2), Vec3(0, 0, 0.3), 0.02, true});
    robot = robot::Robot(model);
    SceneObject cup = still_body("cup", Shape::cylinder, {0.03, 0.1}, Vec3(0, 0, 0.05 + taken_m));
    cup.attach_s = 1;
    cup.release_s = 4;
    if (in_palm) cup.attached_frame = "palm";
    scene.objects = {cup, still_body("table", Shape::box, {2, 1, 0.1}, Vec3(0, 0, -0.05))};
    movement.target = "cup";
    movement.phases = {{PhaseKind::grasp, 0.5, 1, 1}, {PhaseKind::transport, 1, 4, 1}};
    position = JointRows::Zero(7, 2);
    position.col(0) << 0, 0, 0, 0, 0.5, 0.5, 0.5;
    const double end = put_down_m - taken_m;
    position.col(1) << 0, 0, 0.1, 0.2, 0.2, end, end;
    if (!in_palm) {
      SceneObject& target = scene.objects[0];
      for (int k = 2; k < 7; ++k) {
        target.time.push_back(time[static_cast<std::size_t>(k)]);
        target.position.push_back(target.position[0] + Vec3(position(k, 0), 0, position(k, 1)));
        target.orientation.push_back(Quat::Identity());
      }
      target.time[0] = 1;
    }
    attach();
  }
  void attach() {
    world = make_world(robot, scene, movement, {});
    attach_target(time, position, world);
  }
  void add(const SceneObject& body) {
    scene.objects.push_back(body);
    attach();
  }
  JointMotion between(int sample) const {
    const auto k = static_cast<std::size_t>(sample);
    return straight_motion(position.row(sample), position.row(sample + 1), time[k], time[k + 1]);
  }
  /// Returns "" if the whole motion is free, else the bodies of the first failure.
  std::string failure() {
    for (int k = 0; k + 1 < 7; ++k) {
      const MotionCheck check = check_motion(world, between(k), scratch);
      if (check.verdict != MotionVerdict::free)
        return first_body_name(world, check.pair) + "/" + second_body_name(world, check.pair);
    }
    return "";
  }
};

TEST(CarriedBody, StandsOnItsSupportUntilItIsLiftedAndFromWhenItIsPutDown) {
  for (const bool in_palm : {true, false}) {
    Lifting c(0, 0, in_palm);
    EXPECT_EQ(c.failure(), "");
    ASSERT_EQ(c.world.carried.supports.size(), 1u);
    EXPECT_EQ(c.world.carried.supports[0].lifted_s, 1.5);
    EXPECT_EQ(c.world.carried.supports[0].lowered_s, 3);
    // From hand to cup; from hand to table, without the cup, which may touch both.
    EXPECT_NEAR(clearance(c.world, c.position.row(0), 0, c.scratch), 0.08, 1e-9);
    EXPECT_NEAR(clearance(c.world, c.position.row(1), 1, c.scratch), 0.18, 1e-9);
    EXPECT_NEAR(clearance(c.world, c.position.row(3), 2, c.scratch), 0.2, 1e-9);
    EXPECT_GT(motion_clearance(c.world, c.between(2), c.scratch).lower_bound_m, 0.0999);
  }
}

TEST(CarriedBody, MayOverlapItsSupportByTheNoiseOfTwoMillimetres) {
  EXPECT_EQ(Lifting(-0.0019, -0.0019).failure(), "");
  EXPECT_EQ(Lifting(0.0019, 0.0015).failure(), "");
  EXPECT_EQ(Lifting(-0.003, 0).failure(), "cup/table");
  EXPECT_EQ(Lifting(0, -0.003).failure(), "cup/table");
  EXPECT_EQ(Lifting(0, -0.003, false).failure(), "cup/table");
  Lifting dipping(0, 0);
  dipping.position(2, 1) = -0.0019;
  dipping.attach();
  EXPECT_EQ(dipping.failure(), "");
  dipping.position(2, 1) = -0.0021;
  dipping.attach();
  EXPECT_EQ(dipping.failure(), "cup/table");
}

TEST(CarriedBody, MustNotTouchItsSupportWhileItIsCarried) {
  Lifting c(0, 0);
  c.time = {0, 1, 1.5, 2, 3, 3.5, 4};
  c.position.col(1) << 0, 0, 0.1, 0.0003, 0.2, 0.1, 0;
  c.attach();
  EXPECT_EQ(c.failure(), "cup/table");
}

TEST(CarriedBody, IsABodyOfTheRobotForEveryOtherObject) {
  const SceneObject block =
      still_body("block", Shape::box, {0.03, 0.03, 0.03}, Vec3(0.25, 0, 0.25));
  for (const bool in_palm : {true, false}) {
    Lifting c(0, 0, in_palm);
    c.add(block);
    EXPECT_EQ(c.failure(), "cup/block");
    // Half way between the samples, where the cup's middle is at the height of the block's.
    EXPECT_TRUE(is_free(c.world, c.position.row(3), 2, c.scratch));
    EXPECT_TRUE(is_free(c.world, c.position.row(4), 3, c.scratch));
    JointVector q;
    c.between(3).position(0.5, q);
    EXPECT_FALSE(is_free(c.world, q, 2.5, c.scratch));
    EXPECT_FALSE(FclEngine(c.world).is_free(q, 2.5, c.scratch));
    const PairSeparation least = least_slack(c.world, q, 2.5, c.scratch);
    EXPECT_EQ(first_body_name(c.world, least), "cup");
    // It leaves the block along y, across both diameters.
    EXPECT_NEAR(least.separation.distance, -0.045, 1e-6);
    EXPECT_LT(motion_clearance(c.world, c.between(3), c.scratch).distance, 0);
    std::vector<PairSeparation> ours, fcls;
    near_pairs(c.world, q, 2.5, 0, c.scratch, ours);
    FclEngine(c.world).colliding_pairs(q, 2.5, c.scratch, fcls);
    ASSERT_EQ(ours.size(), 1u);
    ASSERT_EQ(fcls.size(), 1u);
    EXPECT_EQ(ours[0].key(), fcls[0].key());
  }
}

TEST(CarriedBody, IsCheckedWhereItWasReleasedAgainstWhatMovesThere) {
  Lifting c(0, 0);
  SceneObject ball = still_body("ball", Shape::sphere, {0.02}, Vec3(1, 0, 0.03));
  ball.time = {4, 5};
  ball.position.push_back(Vec3(0.5, 0, 0.03));
  ball.orientation.push_back(Quat::Identity());
  c.add(ball);
  EXPECT_EQ(c.failure(), "cup/ball");
}

TEST(CarriedBody, TheWayAfterTheReleaseIsCheckedInOneMotion) {
  Lifting c(0, 0);
  c.position(6, 0) = 1;  // the hand leaves, into a post
  c.add(still_body("post", Shape::cylinder, {0.02, 0.4}, Vec3(1, 0, 0.2)));
  // Every border of the motion's parts is inside: contacts begin and end, the cup is taken, lifted,
  // lowered and released.
  ASSERT_EQ(c.world.touch_begin_s > 0 && c.world.touch_end_s < 5, true);
  ASSERT_EQ(c.world.carried.supports.size(), 1u);
  ASSERT_LT(c.world.carried.supports[0].lowered_s, 5);
  const JointMotion whole{0, 5,
                          [&](double s, JointVector& q) {
                            const auto after = std::ranges::upper_bound(c.time, s);
                            const auto k = std::min<std::ptrdiff_t>(after - c.time.begin(), 6) - 1;
                            const double share = (s - c.time[k]) / (c.time[k + 1] - c.time[k]);
                            q = (1 - share) * c.position.row(k) + share * c.position.row(k + 1);
                          },
                          [](double s0, double s1, JointVector& travel) {
                            travel = JointVector::Constant(2, 0.5 * (s1 - s0));  // 0.5 m/s at most
                          },
                          [](double s) { return s; }};
  const MotionCheck check = check_motion(c.world, whole, c.scratch);
  ASSERT_EQ(check.verdict, MotionVerdict::colliding);
  EXPECT_EQ(second_body_name(c.world, check.pair), "post");
  EXPECT_NEAR(motion_clearance(c.world, whole, c.scratch).distance, -0.04, 1e-3)
      << "axes cross: both radii";
}

TEST(CarriedBody, IsReleasedInTheAirFarFromEverything) {
  EXPECT_NEAR(Lifting(0, 0.0095).world.carried.release_gap_m, 0.0095, 1e-9);
  EXPECT_GT(Lifting(0, 0.02).world.carried.release_gap_m, 0.01);
  EXPECT_EQ(Lifting(0, -0.001).world.carried.release_gap_m, 0);
  EXPECT_EQ(Lifting(0.003, 0.02).world.carried.release_gap_m, 0) << "it stood on nothing";
  Lifting held(0, 0.02);
  held.scene.objects[0].release_s = 6;  // after the end of the path
  held.attach();
  EXPECT_EQ(held.world.carried.release_gap_m, 0);
}

TEST(CarriedBody, BeforeItIsTakenIsNotChecked) {
  Lifting c(0, 0);
  c.add(still_body("lid", Shape::box, {0.05, 0.05, 0.02}, Vec3(0, 0, 0.1)));
  EXPECT_TRUE(is_free(c.world, c.position.row(0), 0.5, c.scratch));
  EXPECT_FALSE(is_free(c.world, c.position.row(1), 1, c.scratch));
}

}  // namespace
}  // namespace morphe::collision
