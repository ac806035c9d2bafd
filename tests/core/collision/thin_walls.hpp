#pragma once

#include "core/collision/continuous_check.hpp"
#include "tests/core/collision/random_robot.hpp"

namespace morphe::collision {

/// A slim random robot (links 8 mm thin, fingers 2 mm), walls 1 mm thin about it, and a straight
inline RobotModel thin_robot(RandomBodies& random) {
  RobotModel robot = random_robot(random);
  for (RobotModel::Capsule& capsule : robot.capsules) capsule.radius *= 0.2;
  return robot;
}

/// motion from a place that is free.
struct ThinWalls {
  robot::Robot robot;
  Scene scene;
  CollisionWorld world;
  JointVector from, to;

  ThinWalls(const ThinWalls&) = delete;
  explicit ThinWalls(RandomBodies& random) : robot(thin_robot(random)) {
    for (int k = 0; k < 10; ++k) {
      SceneObject wall = random.solid(Shape::box);
      wall.name = "wall" + std::to_string(k);
      wall.size = {random.uniform(0.02, 0.1), random.uniform(0.02, 0.1), 0.001};
      wall.position = {random.uniform(0.3, 0.9) * random.direction()};
      wall.orientation = {Quat(random.pose(0).linear())};
      scene.objects.push_back(wall);
    }
    world = make_world(robot, scene, {}, {});
    CollisionScratch scratch;
    do {
      from = random_position(random, 8, 2);
    } while (!is_free(world, from, 0, scratch) && ++tries < 200);
    to = from + random_position(random, 8, random.uniform(0.02, 1));
  }
  int tries = 0;
};

/// What a sampler says of it: the least slack at samples so near that no point of the robot moves
/// farther than `step_m` from one to the next; or at so many equal steps.
inline double sampled_slack(const ThinWalls& walls, int steps, CollisionScratch& scratch) {
  double least = 1e9;
  for (int k = 0; k <= steps; ++k) {
    const JointVector q = walls.from + static_cast<double>(k) / steps * (walls.to - walls.from);
    least = std::min(least, least_slack(walls.world, q, 0, scratch).slack());
  }
  return least;
}

struct ThinWallCount {
  int motions = 0, free = 0, colliding = 0;
  int missed = 0;              ///< proved free, but the fine sampler collides
  int missed_by_ten = 0;       ///< free at ten steps, but the fine sampler collides
  int clear = 0, refused = 0;  ///< more room than margin and band; of those, not proved free
};
inline void count_thin_walls(RandomBodies& random, ThinWallCount& count,
                             CollisionScratch& scratch) {
  const ThinWalls walls(random);
  if (!is_free(walls.world, walls.from, 0, scratch)) return;
  const double travel_m =
      (walls.robot.capsule_motion_bounds * (walls.to - walls.from).cwiseAbs()).maxCoeff();
  const int steps = std::max(1, static_cast<int>(std::ceil(travel_m / 1e-4)));
  const double fine = sampled_slack(walls, steps, scratch);
  const double coarse = sampled_slack(walls, 10, scratch);
  const bool free =
      check_motion(walls.world, straight_motion(walls.from, walls.to, 0, 0), scratch).verdict ==
      MotionVerdict::free;
  ++count.motions;
  count.free += free;
  count.colliding += fine < 0;
  count.missed += free && fine < 0;
  count.missed_by_ten += fine < 0 && coarse >= 0;
  count.clear += fine >= 2e-4;  // the band, and what the samples may have missed
  count.refused += fine >= 2e-4 && !free;
}

}  // namespace morphe::collision
