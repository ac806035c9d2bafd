#include "core/collision/constants.hpp"
#include "core/collision/fcl_engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/core/collision/random_robot.hpp"

namespace morphe::collision {
namespace {

Movement grasping() {
  Movement movement;
  movement.target = "cup";
  movement.phases = {{PhaseKind::reach, 0, 0.4, 1},       {PhaseKind::preshape, 0.2, 0.4, 1},
                     {PhaseKind::grasp, 0.4, 0.5, 1},     {PhaseKind::hold, 0.5, 0.6, 1},
                     {PhaseKind::transport, 0.6, 0.7, 1}, {PhaseKind::return_phase, 0.7, 1, 1}};
  return movement;
}

TEST(MakeWorld, LeavesOutAllowedAndRigidPairs) {
  RandomBodies random(31);
  const robot::Robot robot(random_robot(random));
  const CollisionWorld world = make_world(robot, {}, {}, {});
  // 12 capsules: 66 pairs, 11 of neighbours allowed. The palm (5) moves with the last link (4),
  // which is one of those already.
  EXPECT_EQ(world.pairs.size(), 55u);
  RobotModel stiff = robot;
  stiff.allowed_collision_pairs.clear();
  EXPECT_EQ(make_world(robot::Robot(stiff), {}, {}, {}).pairs.size(), 65u);
  stiff.allowed_collision_pairs = {{7, 2}};
  EXPECT_EQ(make_world(robot::Robot(stiff), {}, {}, {}).pairs.size(), 64u);
  stiff.capsules[1].frame = -1;
  EXPECT_EQ(make_world(robot::Robot(stiff), {}, {}, {}).pairs.size(), 63u);
}

TEST(CapsulePairs, ClustersContainTheirCapsulesAndPartnersAllPairs) {
  RandomBodies random(35);
  const robot::Robot robot(random_robot_of_clusters(random));
  const CapsulePairs pairs = make_world(robot, {}, {}, {}).pairs;
  std::size_t largest = 0;
  for (const CapsuleCluster& cluster : pairs.clusters()) {
    largest = std::max(largest, cluster.capsules.size());
    for (const int i : cluster.capsules) {
      const RobotModel::Capsule& capsule = robot.capsules[static_cast<std::size_t>(i)];
      EXPECT_EQ(capsule.frame, cluster.frame);
      for (const Vec3& end : {capsule.from, capsule.to}) {
        const Vec3 from_centre = end - cluster.centre;
        EXPECT_LE(from_centre.norm() + capsule.radius, cluster.radius);
        EXPECT_TRUE(
            (from_centre.array().abs() + capsule.radius <= cluster.half_size.array()).all());
      }
    }
  }
  EXPECT_LE(largest, static_cast<std::size_t>(kMaxClusterCapsules));
  EXPECT_GT(pairs.clusters().size(), 15u);  // of 12 frames with the base
  for (const auto& [i, j] : pairs) {
    EXPECT_TRUE(pairs.contains(i, j));
    const auto& cluster = pairs.clusters()[static_cast<std::size_t>(pairs.cluster_of(i))];
    EXPECT_TRUE(std::ranges::binary_search(cluster.partners, pairs.cluster_of(j)));
  }
}

TEST(MakeWorld, TouchingLastsFromPreshapeToRelease) {
  RandomBodies random(32);
  const robot::Robot robot(random_robot(random));
  const Scene scene = random_scene(random);
  CollisionWorld world = make_world(robot, scene, grasping(), {});
  EXPECT_EQ(world.target, 4);
  EXPECT_NEAR(world.touch_begin_s, 0.2, 1.1e-9);
  EXPECT_NEAR(world.touch_end_s, 0.7, 1.1e-9);
  EXPECT_TRUE(may_touch(world, 5, 4, 0.2));
  EXPECT_TRUE(may_touch(world, 5, 4, 0.7));
  EXPECT_FALSE(may_touch(world, 5, 4, 0.71));
  EXPECT_TRUE(may_touch(world, 5, 4, std::nextafter(0.2, 0))) << "rounding, as verify takes it";
  EXPECT_TRUE(may_touch(world, 5, 4, std::nextafter(0.7, 1)));
  EXPECT_FALSE(may_touch(world, 5, 3, 0.5));
  EXPECT_FALSE(may_touch(world, 4, 4, 0.5));
  EXPECT_EQ(required_distance_m(world, 5, 4, 0.5), -world.tolerances.max_penetration);
  EXPECT_EQ(required_distance_m(world, 5, 4, 0.1), world.tolerances.required_clearance);

  Movement movement = grasping();
  movement.phases.erase(movement.phases.begin() + 1);
  EXPECT_NEAR(make_world(robot, scene, movement, {}).touch_begin_s, 0.4, 1.1e-9);
  movement.phases = {{PhaseKind::reach, 0, 1, 1}};
  world = make_world(robot, scene, movement, {});
  EXPECT_FALSE(may_touch(world, 5, 4, 0.5));
  movement = grasping();
  movement.target = "";
  EXPECT_EQ(make_world(robot, scene, movement, {}).target, -1);
}

TEST(MakeWorld, LinksThatAreNoPadsHaveADepthOfTheirOwn) {
  RandomBodies random(33);
  RobotModel table = random_robot(random);
  table.tips.push_back({"tip", static_cast<int>(table.frames.size()) - 1, Pose::Identity(), 1});
  const robot::Robot robot(table);
  const Scene scene = random_scene(random);
  CollisionWorld world = make_world(robot, scene, grasping(), {});
  const int pad = static_cast<int>(table.capsules.size()) - 1;
  EXPECT_EQ(required_distance_m(world, pad - 1, 4, 0.5), -0.005);
  world.tolerances.max_link_penetration = 0.0005;
  EXPECT_EQ(required_distance_m(world, pad, 4, 0.5), -0.005);
  EXPECT_EQ(required_distance_m(world, pad - 1, 4, 0.5), -0.0005);
  EXPECT_EQ(required_distance_m(world, pad - 1, 4, 0.1), world.tolerances.required_clearance);
}

/// Every pair, without the shortcuts.
std::vector<PairSeparation> all_pairs(const CollisionWorld& world, double time_s,
                                      const CollisionScratch& scratch) {
  std::vector<PairSeparation> pairs;
  for (const auto& [i, j] : world.pairs) {
    pairs.push_back({{i, j, false},
                     capsule_capsule(scratch.bodies[static_cast<std::size_t>(i)],
                                     scratch.bodies[static_cast<std::size_t>(j)]),
                     world.tolerances.required_clearance});
  }
  for (std::size_t i = 0; i < scratch.bodies.size(); ++i) {
    for (std::size_t k = 0; k < world.scene->objects.size(); ++k) {
      const int capsule = static_cast<int>(i), object = static_cast<int>(k);
      const SceneObject& solid = world.scene->objects[k];
      pairs.push_back({{capsule, object, true},
                       capsule_solid(scratch.bodies[i], solid, recorded_pose(solid, time_s)),
                       required_distance_m(world, capsule, object, time_s)});
    }
  }
  return pairs;
}

TEST(World, QueriesEqualThoseOverAllPairs) {
  RandomBodies random(33);
  CollisionScratch scratch;
  std::vector<PairSeparation> near;
  for (int k = 0; k < 300; ++k) {
    const robot::Robot robot(k % 2 ? random_robot_of_clusters(random) : random_robot(random));
    const Scene scene = random_scene(random);
    CollisionWorld world = make_world(robot, scene, grasping(), {});
    if (k % 4 == 3)
      world.pairs.erase_if([](const auto& pair) { return (pair[0] + pair[1]) % 3 == 0; });
    const JointVector q = random_position(random, 8, 2);
    const double time_s = random.uniform(0, 1);
    const PairSeparation least = least_slack(world, q, time_s, scratch);
    const double below_m = random.uniform(0, 0.1);
    near_pairs(world, q, time_s, below_m, scratch, near);
    const double free_m = clearance(world, q, time_s, scratch);

    std::size_t next = 0;
    double least_m = std::numeric_limits<double>::infinity(), clear_m = least_m;
    for (const PairSeparation& pair : all_pairs(world, time_s, scratch)) {
      least_m = std::min(least_m, pair.slack());
      if (pair.required_distance_m >= 0) clear_m = std::min(clear_m, pair.separation.distance);
      if (pair.slack() >= below_m) continue;
      ASSERT_LT(next, near.size());
      EXPECT_EQ(near[next].first, pair.first);
      EXPECT_EQ(near[next].other, pair.other);
      EXPECT_EQ(near[next].other_is_object, pair.other_is_object);
      EXPECT_EQ(near[next++].separation.distance, pair.separation.distance);
    }
    EXPECT_EQ(next, near.size());
    EXPECT_EQ(least.slack(), least_m);
    EXPECT_EQ(free_m, clear_m);
    EXPECT_EQ(first_body_name(world, least).substr(0, 4), "part");
    EXPECT_FALSE(second_body_name(world, least).empty());
  }
}

TEST(World, NothingToHitLeavesInfiniteSlack) {
  RobotModel table;
  table.capsules.push_back({"base", -1, Vec3::Zero(), Vec3::UnitZ(), 0.1, false});
  const robot::Robot robot(table);
  const Scene empty;
  CollisionScratch scratch;
  const CollisionWorld world = make_world(robot, empty, {}, {});
  EXPECT_EQ(least_slack(world, JointVector(0), 0, scratch).slack(),
            std::numeric_limits<double>::infinity());
  EXPECT_TRUE(FclEngine(world).is_free(JointVector(0), 0, scratch));
}

TEST(World, FclAgreesOnWholeRobots) {
  RandomBodies random(34);
  CollisionScratch scratch;
  std::vector<PairSeparation> ours, fcls;
  int free = 0;
  for (int k = 0; k < 500; ++k) {
    const robot::Robot robot(random_robot(random));
    const Scene scene = random_scene(random);
    const CollisionWorld world = make_world(robot, scene, grasping(), {});
    const JointVector q = random_position(random, 8, 2);
    const double time_s = random.uniform(0, 1);
    near_pairs(world, q, time_s, 1e-6, scratch, ours);
    const bool too_near_to_tell = std::any_of(
        ours.begin(), ours.end(), [](const PairSeparation& p) { return p.slack() > -1e-6; });
    if (too_near_to_tell) continue;
    FclEngine(world).colliding_pairs(q, time_s, scratch, fcls);
    ASSERT_EQ(ours.size(), fcls.size());
    for (std::size_t p = 0; p < ours.size(); ++p) {
      EXPECT_EQ(ours[p].first, fcls[p].first);
      EXPECT_EQ(ours[p].other, fcls[p].other);
    }
    EXPECT_EQ(FclEngine(world).is_free(q, time_s, scratch), ours.empty());
    free += ours.empty();
  }
  EXPECT_GT(free, 20);
}

}  // namespace
}  // namespace morphe::collision
