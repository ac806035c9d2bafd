#include "stages/map/nearest_errors.hpp"

#include <gtest/gtest.h>

#include "stages/map/map_options.hpp"
#include "tests/support/two_link_arm.hpp"

namespace morphe::map {
namespace {

/// Two links of 0.5 m reach every point of their plane within 1 m: what is left of a goal is how
/// far it lies from there.
TEST(NearestErrors, AreDistancesFromWhatTheLinksReach) {
  RobotModel table = two_link_arm();
  table.velocity = table.acceleration = table.jerk = JointVector::Constant(2, 1);
  RobotModel::Tip tip;
  tip.frame = 1;
  tip.transform.translation() = Vec3(0.5, 0, 0);
  table.tips = {tip};
  const robot::Robot robot(table);
  const Scene scene;
  const collision::CollisionWorld world = collision::make_world(robot, scene, {}, {});
  MappingProblem problem;
  problem.robot = &robot;
  problem.objective = default_objective();
  problem.world = &world;
  const std::vector<Vec3> places = {
      {1.2, 0.3, 0}, {1.5, 0, 0}, {0.3, 0.4, 0.25}, {0.5, 0.5, 0}, unknown_point()};
  for (std::size_t f = 0; f < places.size(); ++f) {
    problem.time.push_back(0.01 * static_cast<double>(f));
    problem.goals.emplace_back().tip_position = {places[f]};
    problem.goals.back().tip_orientation = {unknown_rotation()};
  }
  const JointRows near = (JointRows(1, 2) << 0.1, 0.5).finished().replicate(5, 1);
  const JointRows errors = nearest_errors(problem, near, {false, false, false, true, false}, {});
  EXPECT_NEAR(errors(0, 0), Vec3(1.2, 0.3, 0).norm() - 1, 1e-6);
  EXPECT_NEAR(errors(1, 0), 0.5, 1e-6);
  EXPECT_NEAR(errors(2, 0), 0.25, 1e-6) << "above the plane";
  EXPECT_TRUE(std::isnan(errors(3, 0))) << "within reach";
  EXPECT_TRUE(std::isnan(errors(4, 0))) << "no goal";
}

}  // namespace
}  // namespace morphe::map
