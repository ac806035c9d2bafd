#include "core/collision/continuous_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "tests/core/collision/random_robot.hpp"
#include "tests/support/two_link_arm.hpp"

namespace morphe::collision {
namespace {

TEST(CapsuleReach, IsNeverExceeded) {
  RandomBodies random(41);
  double tightest = 0;
  for (int k = 0; k < 200; ++k) {
    const robot::Robot robot(random_robot(random));
    const Scene empty;
    const CollisionWorld world = make_world(robot, empty, {}, {});
    CollisionScratch here, there;
    for (int motion = 0; motion < 20; ++motion) {
      const JointVector q = random_position(random, 8, 3);
      JointVector step = random_position(random, 8, std::pow(10.0, random.uniform(-5, 0)));
      if (motion % 2) step = step[motion % 8] * JointVector::Unit(8, motion % 8);
      update_bodies(world, q, 0, here);
      update_bodies(world, q + step, 0, there);
      for (std::size_t c = 0; c < robot.capsules.size(); ++c) {
        const double bound =
            robot.capsule_motion_bounds.row(static_cast<Eigen::Index>(c)).dot(step.cwiseAbs());
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
RobotModel two_links() {
  robot::Robot robot{two_link_arm()};
  robot.capsules.push_back({"forearm", 1, Vec3::Zero(), Vec3(0.5, 0, 0), 0.01, true});
  return robot;
}

TEST(CapsuleReach, OfTwoLinksByHand) {
  const JointRows levers = robot::Robot(two_links()).capsule_motion_bounds;
  EXPECT_DOUBLE_EQ(levers(0, 0), 1.01);
  EXPECT_DOUBLE_EQ(levers(0, 1), 0.51);
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
  const robot::Robot robot(two_links());
  Scene scene;
  scene.objects = {thin_post(0.8, 0)};
  const CollisionWorld world = make_world(robot, scene, {}, {});
  CollisionScratch scratch;
  const JointVector from = Eigen::Vector2d(-0.1, 0), to = Eigen::Vector2d(0.08, 0);
  EXPECT_GT(least_slack(world, from, 0, scratch).slack(), 0.03);
  EXPECT_GT(least_slack(world, to, 0, scratch).slack(), 0.03);
  const MotionCheck check = check_motion(world, straight_motion(from, to, 0, 0), scratch);
  EXPECT_EQ(check.verdict, MotionVerdict::colliding);
  EXPECT_NEAR(check.parameter, 0.1 / 0.18, 0.0125 / 0.18 / 0.8);
  EXPECT_LT(check.pair.slack(), 0);
  EXPECT_EQ(second_body_name(world, check.pair), "post");
  // Past its far end there is room.
  scene.objects = {thin_post(1.02, 0)};
  const MotionCheck past = check_motion(world, straight_motion(from, to, 0, 0), scratch);
  EXPECT_EQ(past.verdict, MotionVerdict::free);
  EXPECT_NEAR(past.pair.slack(), 1.02 - 1.01 - 0.0005 - 0.001, 2e-4);
  // Room for the margin but for half the band: cannot be told.
  scene.objects = {thin_post(1.01 + 0.0005 + 0.001 + 1e-9, 0)};
  EXPECT_EQ(check_motion(world, straight_motion(from, to, 0, 0), scratch).verdict,
            MotionVerdict::undecided);
}

TEST(CheckMotion, StandingStillIsJudgedByTheSlackAlone) {
  const robot::Robot robot(two_links());
  Scene scene;
  scene.objects = {thin_post(0.8, 0.01 + 0.0005 + 0.001 + 1e-9)};
  const CollisionWorld world = make_world(robot, scene, {}, {});
  CollisionScratch scratch;
  const JointVector q = Eigen::Vector2d::Zero();
  const JointMotion still = straight_motion(q, q, 0, 1);
  EXPECT_EQ(check_motion(world, still, scratch).verdict, MotionVerdict::free);
}

TEST(CheckMotion, ContactIsAllowedUntilReleaseOnly) {
  const robot::Robot robot(two_links());
  Scene scene;
  scene.objects = {thin_post(0.8, 0.009)};
  scene.objects[0].name = "cup";
  Movement movement;
  movement.target = "cup";
  movement.phases = {{PhaseKind::grasp, 1, 2, 1}};
  const CollisionWorld world = make_world(robot, scene, movement, {});
  CollisionScratch scratch;
  const JointVector q = Eigen::Vector2d::Zero(), nudged = Eigen::Vector2d(1e-4, 0);
  const auto verdict = [&](double from_s, double to_s) {
    return check_motion(world, straight_motion(q, nudged, from_s, to_s), scratch).verdict;
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
  movement.phases = {{PhaseKind::grasp, 0.3, 0.6, 1}};
  int free = 0, colliding = 0, undecided = 0;
  for (int k = 0; k < 300; ++k) {
    const robot::Robot robot(k % 5 ? random_robot(random) : random_robot_of_clusters(random));
    const Scene scene = random_scene(random);
    const CollisionWorld world = make_world(robot, scene, movement, {});
    JointVector from = random_position(random, 8, 2);
    for (int again = 0; again < 20 && least_slack(world, from, 0, scratch).slack() < 0; ++again) {
      from = random_position(random, 8, 2);
    }
    const JointVector to = from + random_position(random, 8, random.uniform(0.01, 0.3));
    const JointMotion motion =
        straight_motion(from, to, random.uniform(0, 0.5), random.uniform(0.5, 1));
    const MotionCheck check = check_motion(world, motion, scratch);
    failing_pairs(world, motion, scratch, failing);
    EXPECT_EQ(check.verdict == MotionVerdict::free, failing.empty());
    std::set<std::tuple<bool, int, int>> failed;
    for (const MotionCheck& one : failing) {
      failed.insert({one.pair.other_is_object, one.pair.first, one.pair.other});
      EXPECT_LT(one.pair.slack(), one.verdict == MotionVerdict::colliding ? 0 : 1e-4);
      EXPECT_GE(one.parameter, one.begin);
      EXPECT_LE(one.parameter, one.end);
    }
    const MotionClearance clear = motion_clearance(world, motion, scratch);
    EXPECT_LE(clear.lower_bound_m, clear.distance);
    EXPECT_GE(clear.lower_bound_m, clear.distance - 1e-4 - 1e-12);
    const auto kinds = clearance_by_kind(world, motion, scratch);
    EXPECT_EQ(clear.lower_bound_m,
              std::ranges::min_element(kinds, {}, &MotionClearance::lower_bound_m)->lower_bound_m);
    free += check.verdict == MotionVerdict::free;
    colliding += check.verdict == MotionVerdict::colliding;
    undecided += check.verdict == MotionVerdict::undecided;

    JointVector q;
    double least_m = 1e9, clear_m = 1e9;
    for (int s = 0; s <= 200; ++s) {
      motion.position(s / 200.0, q);
      const double time_s = motion.demonstration_time(s / 200.0);
      least_m = std::min(least_m, least_slack(world, q, time_s, scratch).slack());
      clear_m = std::min(clear_m, clearance(world, q, time_s, scratch));
      near_pairs(world, q, time_s, s % 20 == 0 ? 1 : 0, scratch, near);
      for (const PairSeparation& pair : near) {
        const auto kind = static_cast<std::size_t>(kind_of(world, pair));
        if (may_touch(world, pair, time_s)) continue;
        EXPECT_GE(pair.separation.distance, kinds[kind].lower_bound_m - 1e-12);
      }
      std::erase_if(near, [](const PairSeparation& pair) { return !(pair.slack() < 0); });
      for (const PairSeparation& pair : near) {
        const bool known = std::ranges::any_of(failing, [&](const MotionCheck& one) {
          return one.pair.other_is_object == pair.other_is_object && one.pair.first == pair.first &&
                 one.pair.other == pair.other && one.begin <= s / 200.0 && one.end >= s / 200.0;
        });
        EXPECT_TRUE(known) << k << " " << s << " slack " << pair.slack();
      }
    }
    EXPECT_GE(clear_m, clear.lower_bound_m - 1e-12);
    EXPECT_TRUE(check.verdict != MotionVerdict::free || least_m >= 0);
  }
  EXPECT_GT(free, 20);
  EXPECT_GT(colliding, 100);
  EXPECT_LT(undecided, 10);
}

TEST(FailingPairs, EveryIntervalIsTold) {
  // The forearm sweeps past two posts; both stand between free ends.
  const robot::Robot robot(two_links());
  Scene scene;
  scene.objects = {thin_post(0.8, 0), thin_post(0.8 * std::cos(0.3), 0.8 * std::sin(0.3))};
  scene.objects[1].name = "second";
  const CollisionWorld world = make_world(robot, scene, {}, {});
  CollisionScratch scratch;
  const JointVector from = Eigen::Vector2d(-0.1, 0), to = Eigen::Vector2d(0.5, 0);
  std::vector<MotionCheck> failing;
  failing_pairs(world, straight_motion(from, to, 0, 0), scratch, failing);
  ASSERT_EQ(failing.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    // The capsule's side is 10 mm from its axis, the post 0.5 mm thick, the margin 1 mm.
    const double middle = 0.3 * static_cast<double>(k), half = std::asin(0.0115 / 0.8);
    EXPECT_EQ(failing[k].verdict, MotionVerdict::colliding);
    EXPECT_EQ(second_body_name(world, failing[k].pair), k == 0 ? "post" : "second");
    const double tolerance = 1e-4 * 1.01 / 0.8;
    EXPECT_NEAR(-0.1 + 0.6 * failing[k].begin, middle - half, tolerance);
    EXPECT_NEAR(-0.1 + 0.6 * failing[k].end, middle + half, tolerance);
    EXPECT_LE(-0.1 + 0.6 * failing[k].begin, middle - half);
    EXPECT_GE(-0.1 + 0.6 * failing[k].end, middle + half);
  }
  // One pair that fails twice, going there and back again.
  JointMotion back = straight_motion(from, to, 0, 0);
  back.position = [&](double s, JointVector& q) {
    q = from + (1 - std::abs(2 * s - 1)) * 0.5 * (to - from);
  };
  back.travel = [&](double s0, double s1, JointVector& travel) {
    travel = 0.5 * (s1 - s0) * (to - from).cwiseAbs();
  };
  failing_pairs(world, back, scratch, failing);
  ASSERT_EQ(failing.size(), 2u);
  EXPECT_EQ(failing[0].pair.other, failing[1].pair.other);
  EXPECT_LT(failing[0].end, 0.5);
  EXPECT_GT(failing[1].begin, 0.5);
}

TEST(MotionClearance, IsThatOfTheNearestPlace) {
  const robot::Robot robot(two_links());
  Scene scene;
  scene.objects = {thin_post(1.02, 0), thin_post(0.3, 0.4)};
  const CollisionWorld world = make_world(robot, scene, {}, {});
  CollisionScratch scratch;
  const JointVector from = Eigen::Vector2d(-0.2, 0), to = Eigen::Vector2d(0.1, 0);
  const MotionClearance clear =
      motion_clearance(world, straight_motion(from, to, 0, 0), scratch, 1e-5);
  EXPECT_NEAR(clear.distance, 1.02 - 1.01 - 0.0005, 1e-5);
  EXPECT_GE(clear.lower_bound_m, clear.distance - 1e-5);
  EXPECT_NEAR(-0.2 + 0.3 * clear.parameter, 0, 0.01);
  EXPECT_EQ(clear.pair.other, 0);
}

/// A cup on the palm of an arm of two links; a part of the base hangs over its way, higher than the
/// forearm, lower than the cup.
struct Carrying {
  robot::Robot robot;
  Scene scene;
  Movement movement;
  std::vector<double> time;
  JointRows position;
  CollisionWorld world;

  Carrying() {
    RobotModel table = two_links();
    table.frames[1].name = "palm";
    table.capsules[0].may_touch_target = false;
    table.capsules.push_back({"base", -1, Vec3(0, 0.8, 0.08), Vec3(0, 0.8, 0.2), 0.05, false});
    robot = robot::Robot(table);
    SceneObject cup = thin_post(0.8, 0.1);
    cup.name = "cup";
    cup.size = {0.03, 0.1};
    cup.attached_frame = "palm";
    cup.attach_s = 1;
    cup.release_s = 2;
    scene.objects = {cup};
    movement.target = "cup";
    movement.phases = {{PhaseKind::grasp, 0.9, 1, 1}, {PhaseKind::transport, 1, 2, 1}};
    // Still until 1 s, half a turn until 2 s, and a bit back.
    time = {0, 0.5, 1, 1.5, 2, 2.5};
    position = JointRows::Zero(6, 2);
    position.col(0) << 0, 0, 0, 1, 2, 1.8;
    world = make_world(robot, scene, movement, {});
    attach_target(time, position, world);
  }
  JointVector at(int sample) const { return position.row(sample); }
};

TEST(CarriedTarget, MovesWithTheHandFromGraspToRelease) {
  const Carrying c;
  ASSERT_EQ(c.world.attached.frame, 1);
  CollisionScratch scratch;
  const auto cup = [&](int sample) {
    update_bodies(c.world, c.at(sample), c.time[static_cast<std::size_t>(sample)], scratch);
    return scratch.object_poses[0].translation();
  };
  EXPECT_TRUE(cup(1).isApprox(Vec3(0.8, 0.1, 0), 1e-12));
  EXPECT_TRUE(cup(2).isApprox(Vec3(0.8, 0.1, 0), 1e-12));
  for (const int sample : {3, 4, 5}) {
    const double turned = sample == 3 ? 1 : 2;  // it stays where it was released
    const Vec3 there = Eigen::AngleAxisd(turned, Vec3::UnitZ()) * Vec3(0.8, 0.1, 0);
    EXPECT_TRUE(cup(sample).isApprox(there, 1e-12));
  }
  // On the way nothing but the base is in danger of being hit.
  const MotionCheck check =
      check_motion(c.world, straight_motion(c.at(2), c.at(3), 1, 1.5), scratch);
  EXPECT_EQ(check.verdict, MotionVerdict::free);
  const MotionCheck hit = check_motion(c.world, straight_motion(c.at(3), c.at(4), 1.5, 2), scratch);
  EXPECT_EQ(hit.verdict, MotionVerdict::colliding);
  EXPECT_EQ(first_body_name(c.world, hit.pair), "base");
  EXPECT_EQ(second_body_name(c.world, hit.pair), "cup");
  // Without being carried it would have stayed behind.
  CollisionWorld left = c.world;
  left.attached = {};
  EXPECT_EQ(check_motion(left, straight_motion(c.at(3), c.at(4), 1.5, 2), scratch).verdict,
            MotionVerdict::free);
}

TEST(CarriedTarget, WhatEndsAtTheGraspCarriesNothing) {
  Carrying c;
  c.time = {0, 0.2, 0.4, 0.6, 0.8, 1};
  attach_target(c.time, c.position, c.world);
  EXPECT_EQ(c.world.attached.frame, -1);
  Carrying nobody;
  nobody.scene.objects[0].attached_frame = "nobody";
  attach_target(nobody.time, nobody.position, nobody.world);
  EXPECT_EQ(nobody.world.attached.frame, -1);
}

TEST(CarriedTarget, VerdictsHoldUnderDenseSampling) {
  RandomBodies random(44);
  CollisionScratch scratch;
  Movement movement;
  movement.target = "cup";
  movement.phases = {{PhaseKind::grasp, 0.2, 0.4, 1}, {PhaseKind::transport, 0.4, 0.7, 1}};
  int free = 0, moved = 0;
  for (int k = 0; k < 300; ++k) {
    robot::Robot robot(random_robot(random));
    for (std::size_t f = 0; f < robot.frames.size(); ++f) {
      robot.frames[f].name = "f" + std::to_string(f);
    }
    Scene scene = random_scene(random);
    SceneObject& cup = scene.objects.back();
    cup.attached_frame = "f4";  // the palm
    cup.attach_s = random.uniform(0, 0.5);
    cup.release_s = random.uniform(0.5, 1);
    CollisionWorld world = make_world(robot, scene, movement, {});
    const JointVector from = random_position(random, 8, 2);
    const JointVector to = from + random_position(random, 8, random.uniform(0.05, 0.5));
    const int samples = 6;
    JointRows position(samples, 8);
    std::vector<double> time;
    for (int s = 0; s < samples; ++s) {
      time.push_back(static_cast<double>(s) / (samples - 1));
      position.row(s) = from + time.back() * (to - from);
    }
    attach_target(time, position, world);
    moved += world.attached.frame == 4;
    const JointMotion motion = straight_motion(from, to, 0, 1);
    const MotionCheck check = check_motion(world, motion, scratch);
    free += check.verdict == MotionVerdict::free;
    JointVector q;
    double least_m = 1e9;
    for (int s = 0; s <= 300; ++s) {
      motion.position(s / 300.0, q);
      least_m = std::min(least_m, least_slack(world, q, s / 300.0, scratch).slack());
    }
    EXPECT_TRUE(check.verdict != MotionVerdict::free || least_m >= 0) << k << " " << least_m;
  }
  EXPECT_GT(free, 10);
  EXPECT_GT(moved, 250);
}

TEST(ObjectTravel, HoldsForEveryPointOfTheObject) {
  RandomBodies random(43);
  for (int k = 0; k < 200; ++k) {
    const SceneObject cup = random_scene(random).objects.back();
    const double middle_s = random.uniform(0, 1), half_s = random.uniform(0, 0.5);
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
}  // namespace morphe::collision
