#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/collision/random_bodies.hpp"

namespace morphe::collision {
namespace {

double point_to_segment(const Vec3& point, const CapsuleBody& body) {
  const Vec3 along = body.to - body.from;
  const double squared = along.squaredNorm();
  const double s =
      squared > 0 ? std::clamp((point - body.from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (point - body.from - s * along).norm();
}

/// Ternary search along the first segment: the distance to a convex set is convex.
double searched_distance(const CapsuleBody& a, const CapsuleBody& b) {
  double low = 0, high = 1;
  const auto at = [&](double s) { return point_to_segment(a.from + s * (a.to - a.from), b); };
  for (int k = 0; k < 100; ++k) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    (at(left) <= at(right) ? high : low) = at(left) <= at(right) ? right : left;
  }
  return std::min({at(low), at(0), at(1)}) - a.radius - b.radius;
}

void expect_consistent(const CapsuleBody& a, const CapsuleBody& b, double tolerance) {
  const Separation got = capsule_capsule(a, b);
  EXPECT_NEAR(got.distance, searched_distance(a, b), tolerance);
  EXPECT_NEAR(got.normal.norm(), 1, 1e-12);
  EXPECT_NEAR((got.on_first - got.on_second - got.distance * got.normal).norm(), 0, 1e-11);
  EXPECT_NEAR(point_to_segment(got.on_first, a), a.radius, 1e-9);
  EXPECT_NEAR(point_to_segment(got.on_second, b), b.radius, 1e-9);
}

TEST(CapsuleCapsule, EqualsSearchOnRandomPairs) {
  RandomBodies random(1);
  for (int k = 0; k < 5000; ++k) {
    const CapsuleBody a = random.capsule(0.4), b = random.capsule(0.4);
    expect_consistent(a, b, 1e-8);
  }
}

TEST(CapsuleCapsule, EqualsSearchOnPointsAndParallels) {
  RandomBodies random(2);
  for (int k = 0; k < 5000; ++k) {
    CapsuleBody a = random.capsule(0.4), b = random.capsule(0.4);
    const double tilt = std::pow(10.0, random.uniform(-14, -2));
    const Vec3 aside = tilt * random.direction();
    switch (k % 4) {
      case 0:
        a.to = a.from;
        break;
      case 1:
        b.to = b.from;
        break;
      case 2:
        a.to = a.from;
        b.to = b.from;
        break;
      default:
        b.to = b.from + random.uniform(-2, 2) * (a.to - a.from) + aside;
    }
    expect_consistent(a, b, 1e-8);
  }
}

TEST(CapsuleCapsule, NormalIsThatOfFiniteDifferences) {
  RandomBodies random(3);
  const double step_m = 1e-6;
  for (int k = 0; k < 2000; ++k) {
    const CapsuleBody a = random.capsule(0.4), b = random.capsule(0.4);
    const Separation here = capsule_capsule(a, b);
    if (here.distance + a.radius + b.radius < 1e-3) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 u = step_m * Vec3::Unit(axis);
      const double more = capsule_capsule({a.from + u, a.to + u, a.radius}, b).distance;
      const double less = capsule_capsule({a.from - u, a.to - u, a.radius}, b).distance;
      EXPECT_NEAR(here.normal[axis], (more - less) / (2 * step_m), 1e-3);
    }
  }
}

TEST(CapsuleCapsule, AxesThatTouchHaveTheirCommonPerpendicular) {
  const CapsuleBody along_x{{-1, 0, 0}, {1, 0, 0}, 0.1}, along_y{{0, -1, 0}, {0, 1, 0}, 0.2};
  const Separation crossed = capsule_capsule(along_x, along_y);
  EXPECT_NEAR(crossed.distance, -0.3, 1e-15);
  EXPECT_NEAR(std::abs(crossed.normal.z()), 1, 1e-15);
  const Separation same = capsule_capsule(along_x, along_x);
  EXPECT_NEAR(same.distance, -0.2, 1e-15);
  EXPECT_NEAR(same.normal.norm(), 1, 1e-15);
  EXPECT_NEAR(same.normal.x(), 0, 1e-15);
  const CapsuleBody point{Vec3::Zero(), Vec3::Zero(), 0.1};
  EXPECT_NEAR(capsule_capsule(point, point).normal.norm(), 1, 1e-15);
}

}  // namespace
}  // namespace morphe::collision
