#include "core/closure/nearest_point.hpp"

#include <gtest/gtest.h>

#include "tests/core/closure/grasps.hpp"

namespace morphe::closure {
namespace {

const BoundTolerance kExact{0, 1e-9, 2000};

Bounds distance(const ContactSet& set) {
  return negative_origin_distance(make_wrench_set(set, ForceLimit::sum), kExact);
}

TEST(NearestPoint, OneFingerWithoutTorque) {
  // Straight through the centre: the cone's axis is nearest, whatever the friction.
  const Bounds found = distance(unit_set({{0, 0, -0.5}}, {{0, 0, 1}}, 0.7, 0));
  EXPECT_NEAR(found.upper, -1, 1e-9);
  EXPECT_NEAR(found.lower, -1, 1e-9);
}

TEST(NearestPoint, OneFingerBesideTheCentre) {
  // The force (t, 0, 1) at (r, 0, -l) has the torque t l - ... about y: (f, tau) = (t, 1, -l t -
  // r).
  const double r = 0.4, l = 0.5, mu = 0.2;
  const Bounds found = distance(unit_set({{r, 0, -l}}, {{0, 0, 1}}, mu, 0));
  const double t = std::clamp(-r * l / (1 + l * l), -mu, mu);
  EXPECT_NEAR(found.upper, -std::hypot(t, 1, l * t + r), 1e-8);
  EXPECT_GE(found.upper, found.lower);
}

TEST(NearestPoint, TwoFingersAtAnAngleBeyondFriction) {
  // Both normals 0.5 rad off the line, mu below tan(0.5): what is left over points along z.
  const double angle = 0.5, mu = 0.3;
  const Vec3 left(std::cos(angle), 0, std::sin(angle)), right(-std::cos(angle), 0, std::sin(angle));
  const Bounds found = distance(unit_set({{-1, 0, 0}, {1, 0, 0}}, {left, right}, mu, 0));
  EXPECT_NEAR(found.upper, -(std::sin(angle) - mu * std::cos(angle)), 1e-8);
  EXPECT_NEAR(found.lower, found.upper, 2e-9);
}

TEST(NearestPoint, ZeroInside) {
  for (const ContactSet& set :
       {three_fingers(0.5, 0.05), tetrahedron(0.5), two_fingers(1, 0.5, 0)}) {
    const Bounds found = distance(set);
    EXPECT_GT(found.lower, -1e-10);
    EXPECT_GE(found.upper, found.lower);
  }
}

TEST(NearestPoint, BoundsHoldEachOtherOnRandomGrasps) {
  math::RandomStream random(1, "nearest");
  int open = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const ContactSet set = random_grasp(random, 1 + trial % 4, trial % 2 ? 0.002 : 0);
    const Bounds found = distance(set);
    EXPECT_LE(found.lower, found.upper);
    if (found.upper >= 0) continue;
    ++open;
    EXPECT_LE(found.upper - found.lower, 1e-7);
    // Every contact pushes away from the direction, by what is said.
    EXPECT_NEAR(support(make_wrench_set(set, ForceLimit::sum), found.direction).value, found.upper,
                1e-12);
  }
  EXPECT_GT(open, 100);
}

}  // namespace
}  // namespace morphe::closure
