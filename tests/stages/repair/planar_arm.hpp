#pragma once

#include <vector>

#include "core/collision/continuous_check.hpp"
#include "core/motion/plan.hpp"

namespace morphe::test {

/// Three links of 0.4 m in the plane z = 0, joints about z, one capsule a link.
RobotModel planar_arm();

/// A cylinder of radius 0.04 m that stands on the plane's point (x, y).
SceneObject post(const std::string& name, double x, double y);

/// The sweep of most tests.
inline const JointVector kFrom = Vec3(-0.9, 0.3, 0.3), kTo = Vec3(0.9, 0.3, 0.3);

/// 101 samples in 1 s from `from` to `to`, a straight line in joint space at minimum jerk.
JointPath sweep(const JointVector& from, const JointVector& to);

/// Robot, scene and world that belong together; not to be copied, as the world points into it.
struct Bench {
  robot::Robot robot;
  Scene scene;
  collision::CollisionWorld world;
  JointRows reach;

  explicit Bench(std::vector<SceneObject> objects, RobotModel of = planar_arm());
  Bench(const Bench&) = delete;

  /// Certified collisions of a path, one finding a run of bad edges.
  std::vector<Finding> collisions(const JointPath& path) const;
  /// Least slack over 20 states an edge.
  double densely_sampled_slack(const JointPath& path) const;
};

}  // namespace morphe::test
