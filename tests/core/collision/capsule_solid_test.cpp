#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/collision/random_bodies.hpp"

namespace morphe::collision {
namespace {

bool contains(const SceneObject& solid, const Vec3& p) {
  const std::vector<double>& size = solid.size;
  switch (solid.shape) {
    case Shape::sphere:
      return p.norm() <= size[0];
    case Shape::box:
      return 2 * std::abs(p.x()) <= size[0] && 2 * std::abs(p.y()) <= size[1] &&
             2 * std::abs(p.z()) <= size[2];
    case Shape::cylinder:
      return p.head<2>().norm() <= size[0] && 2 * std::abs(p.z()) <= size[1];
    default: {
      const double z = std::clamp(p.z(), -0.5 * size[1], 0.5 * size[1]);
      return (p - Vec3(0, 0, z)).norm() <= size[0];
    }
  }
}

/// Where the ray from the centre leaves the solid, by halving.
Vec3 surface_point(const SceneObject& solid, const Vec3& direction) {
  double low = 0, high = 2;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (contains(solid, middle * direction) ? low : high) = middle;
  }
  return low * direction;
}

class CapsuleSolid : public testing::TestWithParam<Shape> {};

TEST_P(CapsuleSolid, SignedDistanceIsThatOfTheNearestSurfacePoint) {
  RandomBodies random(11);
  for (int k = 0; k < 300; ++k) {
    const SceneObject solid = random.solid(GetParam());
    const Vec3 point = random.point(0.4);
    Vec3 gradient, unused;
    const double distance = signed_distance(solid, point, gradient);
    EXPECT_EQ(distance <= 0, contains(solid, point));
    EXPECT_NEAR(gradient.norm(), 1, 1e-12);
    EXPECT_NEAR(signed_distance(solid, point - distance * gradient, unused), 0, 1e-12);
    for (int ray = 0; ray < 100; ++ray) {
      const Vec3 surface = surface_point(solid, random.direction());
      EXPECT_GE((surface - point).norm(), std::abs(distance) - 1e-12);
      EXPECT_LE(surface.norm(), bounding_radius(solid) + 1e-12);
    }
  }
}

TEST_P(CapsuleSolid, DistanceIsTheLeastAlongTheSegment) {
  RandomBodies random(12);
  for (int k = 0; k < 1000; ++k) {
    const SceneObject solid = random.solid(GetParam());
    const Pose pose = random.pose(0.2);
    CapsuleBody body = random.capsule(0.4);
    if (k % 10 == 0) body.to = body.from;
    const Separation got = capsule_solid(body, solid, pose);
    Vec3 unused;
    double least = 1e9;
    const int steps = 300;
    for (int s = 0; s <= steps; ++s) {
      const Vec3 point = body.from + double(s) / steps * (body.to - body.from);
      least = std::min(least, signed_distance(solid, pose.inverse() * point, unused));
    }
    EXPECT_LE(got.distance, least - body.radius + 1e-9);
    EXPECT_GE(got.distance,
              least - body.radius - 0.5 * (body.to - body.from).norm() / steps - 1e-9);
    EXPECT_NEAR(got.normal.norm(), 1, 1e-12);
    EXPECT_NEAR(signed_distance(solid, pose.inverse() * got.on_second, unused), 0, 1e-9);
    if (got.distance + body.radius < 0) continue;
    EXPECT_NEAR((got.on_first - got.on_second - got.distance * got.normal).norm(), 0, 1e-8);
  }
}

TEST_P(CapsuleSolid, NormalIsThatOfFiniteDifferences) {
  RandomBodies random(13);
  const double step_m = 1e-5;
  int checked = 0, creases = 0;
  for (int k = 0; k < 2000; ++k) {
    const SceneObject solid = random.solid(GetParam());
    const Pose pose = random.pose(0.2);
    const CapsuleBody body = random.capsule(0.3);
    const Separation here = capsule_solid(body, solid, pose);
    Vec3 slope;
    double bend = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 u = step_m * Vec3::Unit(axis);
      const double more =
          capsule_solid({body.from + u, body.to + u, body.radius}, solid, pose).distance;
      const double less =
          capsule_solid({body.from - u, body.to - u, body.radius}, solid, pose).distance;
      slope[axis] = (more - less) / (2 * step_m);
      bend = std::max(bend, std::abs(more + less - 2 * here.distance) / step_m);
    }
    if (bend > 1e-3 || slope.norm() < 1e-3) continue;  // on a kink, or right through
    ++checked;
    EXPECT_LT(slope.norm(), 1 + 1e-4);
    const bool crease = here.distance + body.radius < 0 && slope.norm() < 0.9999;
    creases += crease;
    if (crease) slope.normalize();
    EXPECT_LT((slope - here.normal).norm(), 2e-3);
  }
  EXPECT_GT(checked, 1500);
  EXPECT_LT(creases, checked / 2);
}

INSTANTIATE_TEST_SUITE_P(Shapes, CapsuleSolid, testing::ValuesIn(kSolids),
                         [](const auto& shape) { return std::string(name_of(shape.param)); });

SceneObject plate() {
  SceneObject box;
  box.shape = Shape::box;
  box.size = {1, 1, 0.02};
  return box;
}

TEST(CapsuleSolidByHand, DeepestPointUnderATable) {
  const Separation sunk =
      capsule_solid({{0, 0, 0.5}, {0, 0, 0.003}, 0.01}, plate(), Pose::Identity());
  EXPECT_NEAR(sunk.distance, -0.017, 1e-12);
  EXPECT_NEAR((sunk.normal - Vec3::UnitZ()).norm(), 0, 1e-12);
  EXPECT_NEAR((sunk.on_first - Vec3(0, 0, -0.007)).norm(), 0, 1e-12);
  EXPECT_NEAR((sunk.on_second - Vec3(0, 0, 0.01)).norm(), 0, 1e-12);
}

TEST(CapsuleSolidByHand, RightThroughAPlateTheNormalIsTheLongSide) {
  const CapsuleBody body{{0.1, 0, 0.3}, {0, 0, -0.1}, 0.01};
  const Separation through = capsule_solid(body, plate(), Pose::Identity());
  EXPECT_NEAR(through.distance, -0.02, 1e-9);
  EXPECT_NEAR((through.normal - Vec3::UnitZ()).norm(), 0, 1e-12);
  const Separation other =
      capsule_solid({-body.from, -body.to, body.radius}, plate(), Pose::Identity());
  EXPECT_NEAR((other.normal + Vec3::UnitZ()).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace morphe::collision
