#include "core/closure/gravity_margin.hpp"

#include <gtest/gtest.h>

#include "core/closure/grasp_forces.hpp"
#include "tests/core/closure/grasps.hpp"

namespace morphe::closure {
namespace {

const BoundTolerance kFine{1e-4, 1e-4, 2000};

void expect_around(const GravityMargin& margin, double truth) {
  EXPECT_TRUE(margin.within_tolerance);
  EXPECT_LE(margin.lower, truth + 1e-9);
  EXPECT_GE(margin.upper, truth - 1e-9);
}

/// Two fingers on the z axis, 30 mm from the centre.
ContactSet pinch(double mu, double gamma_m) {
  ContactSet set = two_fingers(0.03, mu, gamma_m);
  set.torque_scale_m = 0.04;
  return set;
}

TEST(GravityMargin, TwoOppositeFingersHoldTwiceMuAcross) {
  for (const double gamma : {0.0, 0.002}) {  // hard ones are a flat set: sought in five dimensions
    const ContactSet set = pinch(0.6, gamma);
    expect_around(gravity_margin(set, {}, Vec3::UnitX(), kFine), 1.2);
    expect_around(gravity_margin(set, {}, {-3, 4, 0}, kFine), 1.2);
    // Along their line one finger pushes back with 1.
    expect_around(gravity_margin(set, {}, Vec3::UnitZ(), kFine), 1);
    const GravityMargin worst = worst_gravity_margin(set, {});
    EXPECT_LE(worst.upper, 1);
    EXPECT_TRUE(worst.within_tolerance);
    const GravityMargin there = gravity_margin(set, {}, worst.direction);
    EXPECT_GE(there.upper, worst.lower);
    EXPECT_LE(there.lower, worst.upper * 1.01);
  }
}

// Their normal forces must be alike to balance along the line: both are the smaller limit.
TEST(GravityMargin, AContactWithASmallerShareLimitsTheOther) {
  ContactSet set = pinch(0.6, 0.002);
  set.contacts[1].force_limit_share = 0.25;
  expect_around(gravity_margin(set, {}, Vec3::UnitX(), kFine), 0.3);
  // Along the line each finger gives what it has.
  expect_around(gravity_margin(set, {}, -Vec3(set.contacts[0].normal), kFine), 1);
  expect_around(gravity_margin(set, {}, -Vec3(set.contacts[1].normal), kFine), 0.25);
  set.contacts[1].force_limit_share = 0;
  EXPECT_EQ(validation_error(set), "contact 1: its share must be above 0");
}

/// Normal forces a and b differ by lambda cos; no turning asks for lambda sin / 2 across at each,
/// so b = lambda sin / (2 mu), and a = 1.
TEST(GravityMargin, Oblique) {
  const double mu = 0.6, angle = 0.7;
  expect_around(gravity_margin(pinch(mu, 0), {}, {std::sin(angle), 0, std::cos(angle)}, kFine),
                1 / (std::cos(angle) + std::sin(angle) / (2 * mu)));
}

TEST(GravityMargin, TheWorstIsTheLeastOfAllDirections) {
  // The least over the angle of the closed form above.
  const double mu = 0.6;
  expect_around(worst_gravity_margin(pinch(mu, 0.002), {}, {3e-3, 1e-3, 2000}),
                2 * mu / std::sqrt(1 + 4 * mu * mu));
  math::RandomStream random(1, "worst");
  for (int trial = 0; trial < 10; ++trial) {
    const ContactSet set = random_grasp(random, 4, 0.005);
    const Load load{0.3, 0.01 * random.normal_vector3()};
    const GravityMargin worst = worst_gravity_margin(set, load);
    EXPECT_TRUE(worst.within_tolerance);
    for (int k = 0; k < 10; ++k) {
      const GravityMargin one = gravity_margin(set, load, random.normal_vector3());
      EXPECT_TRUE(one.within_tolerance);
      EXPECT_GE(one.upper, worst.lower);
    }
    const GravityMargin same = gravity_margin(set, load, worst.direction);
    EXPECT_LE(same.lower, worst.upper + 1e-9);
    EXPECT_LE(same.upper, worst.upper * 1.02 + 2e-3);
  }
}

/// N >= M g e / (2 gamma) for torsion alone, sqrt(… ^2 + (M g / (2 mu))^2) with the weight.
TEST(GravityMargin, CentreOfMassBesideTheLine) {
  const double mu = 0.6, gamma = 0.002, off = 0.02, mass = 0.3;
  const Load load{mass, {off, 0, 0}};
  const GravityMargin margin = gravity_margin(pinch(mu, gamma), load, Vec3::UnitY(), kFine);
  const double torsion = mass * kGravity_m_s2 * off / (2 * gamma),
               weight = mass * kGravity_m_s2 / (2 * mu);
  EXPECT_GT(mass * kGravity_m_s2 / margin.upper, torsion);
  EXPECT_NEAR(margin.sufficient_force_n(mass), std::hypot(torsion, weight), 0.02);
  EXPECT_NEAR(torsion, 14.715, 1e-9);
  // In the direction of the offset nothing turns, and without torsion nothing resists the turning.
  expect_around(gravity_margin(pinch(mu, gamma), load, Vec3::UnitX(), kFine), 2 * mu);
  const GravityMargin hard = gravity_margin(pinch(mu, 0), load, Vec3::UnitY());
  EXPECT_EQ(hard.upper, 0);
  EXPECT_EQ(hard.sufficient_force_n(mass), kInfinity);
  const GravityMargin worst = worst_gravity_margin(pinch(mu, 0), load);
  EXPECT_EQ(worst.upper, 0);
  EXPECT_NEAR(std::abs(worst.direction.y()), 1, 1e-6);
}

TEST(GravityMargin, LyingOnFingersIsNoGripButHolds) {
  const ContactSet below = unit_set({{0.5, 0, -1}, {-0.25, 0.4, -1}, {-0.25, -0.4, -1}},
                                    {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, 0.5, 0);
  expect_around(gravity_margin(below, {}, -Vec3::UnitZ()), 3);
  const GravityMargin up = gravity_margin(below, {}, Vec3::UnitZ());
  EXPECT_EQ(up.lower, 0);
  EXPECT_LE(up.upper, 1e-3);
  EXPECT_EQ(worst_gravity_margin(below, {}).lower, 0);
  const ContactSet slippery = unit_set({{0, 0, -1}}, {{0, 0, 1}}, 0, 0);
  expect_around(gravity_margin(slippery, {}, -Vec3::UnitZ()), 1);
  EXPECT_EQ(gravity_margin(ContactSet{}, {}, Vec3::UnitZ()).upper, 0);
}

/// Another solver finds forces that balance the weight with the squeeze that is enough, and leaves
/// something over with the one that is too little.
TEST(GravityMargin, ForcesAreFoundForTheSqueezeThatIsEnough) {
  math::RandomStream random(1, "enough");
  int held = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const ContactSet set = random_grasp(random, 3 + trial % 3, 0.002);
    const Load load{0.3, 0.01 * random.normal_vector3()};
    const Vec3 down = random.normal_vector3().normalized();
    const GravityMargin margin = gravity_margin(set, load, down);
    if (margin.lower == 0) continue;
    ++held;
    const Wrench weight =
        load.mass_kg * kGravity_m_s2 *
        wrench_of(down, (load.centre_of_mass - set.reference) / set.torque_scale_m);
    const auto left_over = [&](double newtons) {
      return distribute_grasp_forces(set, weight, {newtons, 0, 1}).residual.norm();
    };
    EXPECT_LT(left_over(1.001 * margin.sufficient_force_n(load.mass_kg)), 1e-4);
    EXPECT_GT(left_over(0.99 * load.mass_kg * kGravity_m_s2 / margin.upper), 1e-4);
  }
  EXPECT_GT(held, 15);
}

TEST(GravityMargin, OnTheBorderOfCoplanarSets) {
  math::RandomStream random(1, "cubes");
  for (int trial = 0; trial < 150; ++trial) {
    const ContactSet set =
        cube_grasp(random, 2 + trial % 5, random.uniform(0.1, 1.2), trial % 3 ? 0.03 : 0);
    const Load load{0.3, {0.1, 0, 0}};
    const GravityMargin down = gravity_margin(set, load, -Vec3::UnitZ());
    const GravityMargin worst = worst_gravity_margin(set, load);
    EXPECT_TRUE(down.within_tolerance) << trial;
    EXPECT_TRUE(worst.within_tolerance) << trial;
    EXPECT_GE(down.upper, worst.lower) << trial;
  }
}

/// Where the reference point and the torque scale are does not matter to forces.
TEST(GravityMargin, TheSameAboutAnyPointInAnyScale) {
  math::RandomStream random(1, "reference");
  for (int trial = 0; trial < 15; ++trial) {
    const ContactSet set = random_grasp(random, 4, 0.005);
    ContactSet other = set;
    other.reference = 0.03 * random.normal_vector3();
    other.torque_scale_m = 0.1;
    const Load load{0.3, {0.005, 0, 0.01}};
    const GravityMargin a = gravity_margin(set, load, -Vec3::UnitZ());
    const GravityMargin b = gravity_margin(other, load, -Vec3::UnitZ());
    EXPECT_LE(a.lower, b.upper + 1e-9);
    EXPECT_LE(b.lower, a.upper + 1e-9);
    const GravityMargin c = worst_gravity_margin(set, load), d = worst_gravity_margin(other, load);
    EXPECT_LE(c.lower, d.upper + 1e-9);
    EXPECT_LE(d.lower, c.upper + 1e-9);
  }
}

}  // namespace
}  // namespace morphe::closure
