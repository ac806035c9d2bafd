#include "pipeline/collision/certified.hpp"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "tests/pipeline/collision/random_robot.hpp"
#include "tests/support/two_link_arm.hpp"

namespace morphe {
namespace {

TEST(CapsuleReach, IsNeverExceeded) {
  RandomBodies random(41);
  double tightest = 0;
  for (int k = 0; k < 200; ++k) {
    const RobotTable robot = random_robot(random);
    const Scene empty;
    const CollisionWorld world = make_world(robot, empty, {}, {});
    const JointRows reach = capsule_reach(robot);
    CollisionScratch here, there;
    for (int motion = 0; motion < 20; ++motion) {
      const JointVector q = random_position(random, 8, 3);
      JointVector step = random_position(random, 8, std::pow(10.0, random.between(-5, 0)));
      if (motion % 2) step = step[motion % 8] * JointVector::Unit(8, motion % 8);
      place_bodies(world, q, 0, here);
      place_bodies(world, q + step, 0, there);
      for (std::size_t c = 0; c < robot.capsules.size(); ++c) {
        const double bound = reach.row(static_cast<Eigen::Index>(c)).dot(step.cwiseAbs());
        const double from = (there.bodies[c].from - here.bodies[c].from).norm();
        const double to = (there.bodies[c].to - here.bodies[c].to).norm();
        EXPECT_LE(std::max(from, to), bound * (1 + 1e-9) + 1e-12);
        if (bound > 0) tightest = std::max(tightest, std::max(from, to) / bound);
      }
    }
  }
  EXPECT_GT(tightest, 0.5);
}

/// Two links of 0.5 m that turn about z, a capsule along the second one.
RobotTable two_links() {
  RobotTable robot = two_link_arm();
  robot.capsules.push_back({"forearm", 1, Vec3::Zero(), Vec3(0.5, 0, 0), 0.01, true});
  return robot;
}

TEST(CapsuleReach, OfTwoLinksByHand) {
  const JointRows reach = capsule_reach(two_links());
  EXPECT_DOUBLE_EQ(reach(0, 0), 1.01);
  EXPECT_DOUBLE_EQ(reach(0, 1), 0.51);
}

SceneObject thin_post(double x, double y) {
  SceneObject post;
  post.name = "post";
  post.shape = Shape::cylinder;
  post.size = {0.0005, 0.3};
  post.time = {0};
  post.position = {Vec3(x, y, 0)};
  post.orientation = {Quat::Identity()};
  return post;
}

TEST(CheckMotion, FindsAThinPostBetweenTwoFreeSamples) {
  const RobotTable robot = two_links();
  const JointRows reach = capsule_reach(robot);
  Scene scene;
  scene.objects = {thin_post(0.8, 0)};
  const CollisionWorld world = make_world(robot, scene, {}, {});
  CollisionScratch scratch;
  const JointVector from = Eigen::Vector2d(-0.1, 0), to = Eigen::Vector2d(0.08, 0);
  EXPECT_GT(least_slack(world, from, 0, scratch).slack(), 0.03);
  EXPECT_GT(least_slack(world, to, 0, scratch).slack(), 0.03);
  const MotionCheck check = check_motion(world, reach, straight_motion(from, to, 0, 0), scratch);
  EXPECT_EQ(check.verdict, MotionVerdict::colliding);
  EXPECT_NEAR(check.at, 0.1 / 0.18, 0.0125 / 0.18 / 0.8);
  EXPECT_LT(check.pair.slack(), 0);
  EXPECT_EQ(second_name(world, check.pair), "post");
  // Past its far end there is room.
  scene.objects = {thin_post(1.02, 0)};
  const MotionCheck past = check_motion(world, reach, straight_motion(from, to, 0, 0), scratch);
  EXPECT_EQ(past.verdict, MotionVerdict::free);
  EXPECT_NEAR(past.pair.slack(), 1.02 - 1.01 - 0.0005 - 0.001, 2e-4);
  // Room for the margin but for half the band: cannot be told.
  scene.objects = {thin_post(1.01 + 0.0005 + 0.001 + 1e-9, 0)};
  EXPECT_EQ(check_motion(world, reach, straight_motion(from, to, 0, 0), scratch).verdict,
            MotionVerdict::undecided);
}

TEST(CheckMotion, StandingStillIsJudgedByTheSlackAlone) {
  const RobotTable robot = two_links();
  Scene scene;
  scene.objects = {thin_post(0.8, 0.01 + 0.0005 + 0.001 + 1e-9)};
  const CollisionWorld world = make_world(robot, scene, {}, {});
  CollisionScratch scratch;
  const JointVector q = Eigen::Vector2d::Zero();
  const JointMotion still = straight_motion(q, q, 0, 1);
  EXPECT_EQ(check_motion(world, capsule_reach(robot), still, scratch).verdict, MotionVerdict::free);
}

TEST(CheckMotion, ContactIsAllowedUntilReleaseOnly) {
  const RobotTable robot = two_links();
  Scene scene;
  scene.objects = {thin_post(0.8, 0.009)};
  scene.objects[0].name = "cup";
  Movement movement;
  movement.target = "cup";
  movement.phases = {{"grasp", 1, 2, 1}};
  const CollisionWorld world = make_world(robot, scene, movement, {});
  CollisionScratch scratch;
  const JointVector q = Eigen::Vector2d::Zero(), nudged = Eigen::Vector2d(1e-4, 0);
  const JointRows reach = capsule_reach(robot);
  const auto verdict = [&](double from_s, double to_s) {
    return check_motion(world, reach, straight_motion(q, nudged, from_s, to_s), scratch).verdict;
  };
  EXPECT_EQ(verdict(1, 2), MotionVerdict::free);
  EXPECT_EQ(verdict(1.5, 1.5), MotionVerdict::free);
  EXPECT_EQ(verdict(0.99, 2), MotionVerdict::colliding);
  EXPECT_EQ(verdict(1.5, 2.000001), MotionVerdict::colliding);
  EXPECT_EQ(verdict(0, 3), MotionVerdict::colliding);
}

TEST(CheckMotion, VerdictsHoldUnderDenseSampling) {
  RandomBodies random(42);
  CollisionScratch scratch;
  std::vector<MotionCheck> failing;
  std::vector<PairSeparation> near;
  Movement movement;
  movement.target = "cup";
  movement.phases = {{"grasp", 0.3, 0.6, 1}};
  int free = 0, colliding = 0, undecided = 0;
  for (int k = 0; k < 300; ++k) {
    const RobotTable robot = random_robot(random);
    const Scene scene = random_scene(random);
    const CollisionWorld world = make_world(robot, scene, movement, {});
    const JointRows reach = capsule_reach(robot);
    JointVector from = random_position(random, 8, 2);
    for (int again = 0; again < 20 && least_slack(world, from, 0, scratch).slack() < 0; ++again) {
      from = random_position(random, 8, 2);
    }
    const JointVector to = from + random_position(random, 8, random.between(0.01, 0.3));
    const JointMotion motion =
        straight_motion(from, to, random.between(0, 0.5), random.between(0.5, 1));
    const MotionCheck check = check_motion(world, reach, motion, scratch);
    failing_pairs(world, reach, motion, scratch, failing);
    EXPECT_EQ(check.verdict == MotionVerdict::free, failing.empty());
    std::set<std::tuple<bool, int, int>> failed;
    for (const MotionCheck& one : failing) {
      failed.insert({one.pair.object, one.pair.capsule, one.pair.other});
      EXPECT_LT(one.pair.slack(), one.verdict == MotionVerdict::colliding ? 0 : 1e-4);
    }
    EXPECT_EQ(failed.size(), failing.size());
    free += check.verdict == MotionVerdict::free;
    colliding += check.verdict == MotionVerdict::colliding;
    undecided += check.verdict == MotionVerdict::undecided;

    JointVector q;
    double least_m = 1e9;
    for (int s = 0; s <= 200; ++s) {
      motion.position(s / 200.0, q);
      const double time_s = motion.demonstration_time(s / 200.0);
      least_m = std::min(least_m, least_slack(world, q, time_s, scratch).slack());
      near_pairs(world, q, time_s, 0, scratch, near);
      for (const PairSeparation& pair : near) {
        EXPECT_TRUE(failed.contains({pair.object, pair.capsule, pair.other}))
            << k << " " << s << " slack " << pair.slack();
      }
    }
    EXPECT_TRUE(check.verdict != MotionVerdict::free || least_m >= 0);
  }
  EXPECT_GT(free, 20);
  EXPECT_GT(colliding, 100);
  EXPECT_LT(undecided, 10);
}

TEST(ObjectTravel, HoldsForEveryPointOfTheObject) {
  RandomBodies random(43);
  for (int k = 0; k < 200; ++k) {
    const SceneObject cup = random_scene(random).objects.back();
    const double middle_s = random.between(0, 1), half_s = random.between(0, 0.5);
    const double bound = object_travel(cup, middle_s - half_s, middle_s, middle_s + half_s);
    const Vec3 corner = 0.5 * Vec3(cup.size[0], cup.size[1], cup.size[2]);
    const Vec3 there = recorded_pose(cup, middle_s) * corner;
    for (int s = -20; s <= 20; ++s) {
      const Vec3 here = recorded_pose(cup, middle_s + half_s * s / 20) * corner;
      EXPECT_LE((here - there).norm(), bound + 1e-12);
    }
  }
}

}  // namespace
}  // namespace morphe
