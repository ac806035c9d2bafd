#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include <memory>

#include "core/collision/fcl_engine.hpp"
#include "core/math/rotation.hpp"
#include "tests/core/collision/meshes.hpp"
#include "tests/core/collision/random_bodies.hpp"

namespace morphe::collision {
namespace {

std::unique_ptr<fcl::CollisionGeometry<double>> shape_of(const SceneObject& solid) {
  const std::vector<double>& size = solid.size;
  switch (solid.shape) {
    case Shape::sphere:
      return std::make_unique<fcl::Sphere<double>>(size[0]);
    case Shape::box:
      return std::make_unique<fcl::Box<double>>(size[0], size[1], size[2]);
    case Shape::cylinder:
      return std::make_unique<fcl::Cylinder<double>>(size[0], size[1]);
    default:
      return std::make_unique<fcl::Capsule<double>>(size[0], size[1]);
  }
}

double fcl_distance(const CapsuleBody& body, const SceneObject& solid, const Pose& pose) {
  const fcl::Capsule<double> capsule(body.radius, (body.to - body.from).norm());
  const Pose at = make_pose(0.5 * (body.from + body.to),
                            math::shortest_rotation(Vec3::UnitZ(), body.to - body.from));
  fcl::DistanceRequest<double> request;
  request.distance_tolerance = 1e-9;
  fcl::DistanceResult<double> result;
  return fcl::distance(&capsule, at, shape_of(solid).get(), pose, request, result);
}

class FclAgreement : public testing::TestWithParam<Shape> {};

TEST_P(FclAgreement, DistanceOfBodiesApart) {
  RandomBodies random(21);
  double worst = 0;
  for (int k = 0; k < 3000; ++k) {
    const SceneObject solid = random.solid(GetParam());
    const Pose pose = random.pose(0.5);
    const CapsuleBody body = random.capsule(0.5);
    const double distance = capsule_solid(body, solid, pose).distance;
    if (distance < 1e-3) continue;
    worst = std::max(worst, std::abs(distance - fcl_distance(body, solid, pose)));
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 1e-5);
}

/// A capsule of the base and one object, or two capsules.
struct Pair {
  RobotModel table;
  robot::Robot robot;
  Scene scene;
  CollisionWorld world;

  void add(const CapsuleBody& body, bool may_touch_target) {
    table.capsules.push_back({"part", -1, body.from, body.to, body.radius, may_touch_target});
  }
  CollisionWorld& make(double margin_m, double depth_m) {
    Tolerances tolerances;
    tolerances.required_clearance = margin_m;
    tolerances.max_penetration = depth_m;
    Movement movement;
    movement.target = "cup";
    movement.phases = {{PhaseKind::grasp, 1, 2, 1}};
    robot = robot::Robot(table);
    world = make_world(robot, scene, movement, tolerances);
    return world;
  }
};

TEST_P(FclAgreement, VerdictOnObjectsWithMarginAndWithContact) {
  RandomBodies random(22);
  CollisionScratch scratch;
  const JointVector q(0);
  int colliding = 0, sinking = 0;
  for (int k = 0; k < 8000; ++k) {
    Pair pair;
    SceneObject solid = random.solid(GetParam());
    solid.name = "cup";
    solid.position = {random.point(0.3)};
    solid.orientation = {Quat(random.pose(0).linear())};
    pair.scene.objects = {solid};
    pair.add(random.capsule(0.3), true);
    const double depth_m = random.uniform(0, 0.04);  // deeper than some radii
    const CollisionWorld& world = pair.make(random.uniform(0, 0.01), depth_m);
    for (const double time_s : {0.5, 1.5}) {
      const PairSeparation least = least_slack(world, q, time_s, scratch);
      ASSERT_DOUBLE_EQ(least.required_distance_m,
                       time_s < 1 ? world.tolerances.required_clearance : -depth_m);
      if (std::abs(least.slack()) < 1e-6) continue;
      EXPECT_EQ(FclEngine(world).is_free(q, time_s, scratch), least.slack() >= 0)
          << name_of(GetParam()) << " " << k << " slack " << least.slack();
      colliding += least.slack() < 0;
      sinking += least.slack() >= 0 && least.separation.distance < 0;
    }
  }
  EXPECT_GT(colliding, 1500);
  EXPECT_GT(sinking, 100);
}

INSTANTIATE_TEST_SUITE_P(Shapes, FclAgreement, testing::ValuesIn(kSolids),
                         [](const auto& shape) { return std::string(name_of(shape.param)); });

/// Closed and not convex, closed and cut open: FCL's hollow meshes with our word on what is inside.
TEST(FclAgreementOfMeshes, VerdictWithMarginAndWithContact) {
  RandomBodies random(24);
  CollisionScratch scratch;
  const JointVector q(0);
  int colliding = 0, sinking = 0;
  for (int k = 0; k < 3000; ++k) {
    Pair pair;
    SceneObject mesh = k % 3 == 0   ? torus_mesh(0.15, 0.06, 12, 8)
                       : k % 3 == 1 ? box_mesh(Vec3(0.1, 0.2, 0.3))
                                    : box_mesh(Vec3(0.2, 0.2, 0.2), 5);
    mesh.name = "cup";
    mesh.position = {random.point(0.2)};
    mesh.orientation = {Quat(random.pose(0).linear())};
    pair.scene.objects = {mesh};
    pair.add(random.capsule(0.2), true);
    const double depth_m = random.uniform(0, 0.04);
    const CollisionWorld& world = pair.make(random.uniform(0, 0.01), depth_m);
    for (const double time_s : {0.5, 1.5}) {
      const PairSeparation least = least_slack(world, q, time_s, scratch);
      if (std::abs(least.slack()) < 2e-5) continue;
      EXPECT_EQ(FclEngine(world).is_free(q, time_s, scratch), least.slack() >= 0)
          << k << " slack " << least.slack();
      colliding += least.slack() < 0;
      sinking += least.slack() >= 0 && least.separation.distance < 0;
    }
  }
  EXPECT_GT(colliding, 500);
  EXPECT_GT(sinking, 50);
}

TEST(FclAgreementOfCapsules, Verdict) {
  RandomBodies random(23);
  CollisionScratch scratch;
  const JointVector q(0);
  for (int k = 0; k < 10000; ++k) {
    Pair pair;
    pair.add(random.capsule(0.2), false);
    pair.add(random.capsule(0.2), false);
    CollisionWorld& world = pair.make(random.uniform(0, 0.01), 0);
    world.pairs = {*world.robot, {{0, 1}}};  // both of the base: no pair by themselves
    const double slack = least_slack(world, q, 0, scratch).slack();
    if (std::abs(slack) < 1e-6) continue;
    EXPECT_EQ(FclEngine(world).is_free(q, 0, scratch), slack >= 0) << k << " slack " << slack;
  }
}

}  // namespace
}  // namespace morphe::collision
