#include "stages/verify/wrench_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/closure/ferrari_canny.hpp"
#include "core/closure/gravity_margin.hpp"
#include "random_points.hpp"

namespace morphe::verify {
namespace {

/// Contacts on the unit sphere around the centre, pressed inwards.
WrenchSet on_sphere(const std::vector<Vec3>& ways, double friction, double torsion) {
  WrenchSet pressing;
  for (const Vec3& way : ways) {
    const Vec3 out = way.normalized();
    pressing.contact_bases.push_back(contact_wrench_basis(out, -out, friction, torsion));
  }
  return pressing;
}

void expect_between(const Bounds& found, double value) {
  EXPECT_LE(found.lower, value + 1e-9);
  EXPECT_GE(found.upper, value - 1e-9);
  EXPECT_LE(found.upper, value + 2e-3 * std::max(1.0, std::abs(value)));
  EXPECT_GE(found.lower, value - std::max(2e-3, 0.06 * std::abs(value)));
}

const std::vector<Vec3> kOpposite = {Vec3::UnitX(), -Vec3::UnitX()};

TEST(WrenchBounds, EnclosesEpsilonOfClosedForms) {
  // Two opposite soft fingers: min(g, mu / sqrt(2 + mu^2)).
  expect_between(epsilon_bounds(on_sphere(kOpposite, 0.6, 0.3)), 0.3);
  expect_between(epsilon_bounds(on_sphere(kOpposite, 0.6, 1)), 0.6 / std::sqrt(2.36));
  // Hard fingers at the corners of a tetrahedron and an octahedron: mu / sqrt(2), mu sqrt(2/3).
  const std::vector<Vec3> four = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  expect_between(epsilon_bounds(on_sphere(four, 0.4, 0)), 0.4 / std::sqrt(2.0));
  std::vector<Vec3> six;
  for (int k = 0; k < 3; ++k) {
    six.push_back(Vec3::Unit(k));
    six.push_back(-Vec3::Unit(k));
  }
  expect_between(epsilon_bounds(on_sphere(six, 0.4, 0)), 0.4 * std::sqrt(2.0 / 3));
}

TEST(WrenchBounds, EpsilonIsZeroWhereNothingResistsATwist) {
  expect_between(epsilon_bounds(on_sphere(kOpposite, 0.8, 0)), 0);  // the turn about their line
}

TEST(WrenchBounds, EpsilonBelowZeroIsTheLeastThatIsLeft) {
  // One finger leaves its own force; two side by side as well.
  expect_between(epsilon_bounds(on_sphere({Vec3::UnitZ()}, 0, 0)), -1);
  expect_between(epsilon_bounds(on_sphere({Vec3::UnitZ(), Vec3::UnitZ()}, 0.5, 0.1)), -1);
}

TEST(WrenchBounds, EnclosesWhatTwoOppositeFingersBear) {
  WrenchSet pressing = on_sphere(kOpposite, 0.3, 0.1);
  pressing.limits_each_force = true;
  const auto towards = [&](const Vec3& down) {
    return least_ratio_bounds(
        pressing, [down](const Vector6& u) { return std::max(0.0, -down.dot(u.head<3>())); });
  };
  expect_between(towards(Vec3::UnitZ()), 0.6);  // 2 mu across their line
  expect_between(towards(Vec3::UnitX()), 1);    // along it
  // |f_t| <= 2 mu (1 - |f_x|) is the force that they bring about without a torque.
  expect_between(least_ratio_bounds(pressing, [](const Vector6& u) { return u.head<3>().norm(); }),
                 0.6 / std::sqrt(1.36));
}

TEST(WrenchBounds, NothingBearsWhatOneFingerCannot) {
  WrenchSet pressing = on_sphere({Vec3::UnitZ()}, 0.5, 0.1);
  pressing.limits_each_force = true;
  const Bounds worst =
      least_ratio_bounds(pressing, [](const Vector6& u) { return u.head<3>().norm(); });
  EXPECT_EQ(worst.lower, 0);
  EXPECT_NEAR(worst.upper, 0, 1e-9);
}

/// Two ways to the same numbers that share nothing: each interval meets the other.
TEST(WrenchBounds, MeetsTheBoundsOfPipelineClosure) {
  Random random(5);
  int closed = 0;
  for (int grasp = 0; grasp < 40; ++grasp) {
    closure::ContactSet set;
    set.friction = {random.in(0.3, 1), 0.002};
    set.torque_scale_m = 0.06;
    WrenchSet pressing;
    for (int k = 0; k < 2 + grasp % 4; ++k) {
      const Vec3 out = random.point(1).normalized();
      const Vec3 normal = (-out + 0.3 * random.point(1)).normalized();
      set.contacts.push_back({0.05 * out, normal});
      pressing.contact_bases.push_back(
          contact_wrench_basis(0.05 / 0.06 * out, normal, set.friction.mu, 0.002 / 0.06));
    }
    const Bounds epsilon = epsilon_bounds(pressing);
    const closure::FerrariCanny other = closure::ferrari_canny(set, closure::ForceLimit::sum);
    EXPECT_LE(epsilon.lower, other.upper + 1e-9) << grasp;
    EXPECT_GE(epsilon.upper, other.lower - 1e-9) << grasp;
    const double wide = std::max(1e-3, other.upper < 0 ? -0.05 * other.upper : 0);
    EXPECT_LE(epsilon.upper, other.upper + wide) << grasp;
    closed += other.force_closure() ? 1 : 0;
    pressing.limits_each_force = true;
    const closure::GravityMargin margin = closure::worst_gravity_margin(set, {0.3, Vec3::Zero()});
    const Bounds worst =
        least_ratio_bounds(pressing, [](const Vector6& u) { return u.head<3>().norm(); });
    EXPECT_LE(worst.lower, margin.upper + 1e-9) << grasp;
    EXPECT_GE(worst.upper, margin.lower - 1e-9) << grasp;
    EXPECT_LE(worst.upper, 1.01 * margin.upper + 1e-3) << grasp;
  }
  EXPECT_GT(closed, 5);
  EXPECT_LT(closed, 40);
}

}  // namespace
}  // namespace morphe::verify
