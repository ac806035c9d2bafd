#include "core/closure/opposed_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/closure/ferrari_canny.hpp"
#include "core/math/random_stream.hpp"
#include "tests/core/closure/grasps.hpp"

namespace morphe::closure {
namespace {

/// Two contacts on the unit circle, `apart_rad` from each other: the line between them makes the
/// angle (pi - apart) / 2 with both normals.
ContactSet on_circle(double apart_rad, double mu) {
  return sphere_set({{1, 0, 0}, {std::cos(apart_rad), std::sin(apart_rad), 0}}, mu, 0.1);
}

TEST(OpposedContacts, AreThoseWhoseLineIsInsideBothFrictionCones) {
  const double cone_rad = std::atan(0.8), limit_rad = M_PI - 2 * cone_rad;
  EXPECT_TRUE(has_opposed_contacts(on_circle(M_PI, 0.01)));
  EXPECT_TRUE(has_opposed_contacts(on_circle(limit_rad + 1e-6, 0.8)));
  EXPECT_FALSE(has_opposed_contacts(on_circle(limit_rad - 1e-6, 0.8)));
}

TEST(OpposedContacts, OneFingerOrOneSideIsNotEnough) {
  EXPECT_FALSE(has_opposed_contacts(unit_set({{0, 0, 1}}, {{0, 0, -1}}, 0.8, 0.1)));
  EXPECT_FALSE(has_opposed_contacts(unit_set({{0, 0, 1}, {0.3, 0, 1}, {0, 0.3, 1}},
                                             {{0, 0, -1}, {0, 0, -1}, {0, 0, -1}}, 0.8, 0.1)));
  EXPECT_FALSE(
      has_opposed_contacts(unit_set({{0, 0, 1}, {0, 0, 1}}, {{0, 0, -1}, {0, 0, 1}}, 0.8, 0.1)))
      << "two contacts at one point";
  // Normals that are opposite do not suffice: beside each other they only turn the object.
  EXPECT_FALSE(has_opposed_contacts(
      unit_set({{0, -1, 0.1}, {0, 1, -0.1}}, {{0, 0, -1}, {0, 0, 1}}, 0.8, 0.1)));
}

TEST(OpposedContacts, TwoSoftFingersHaveForceClosureIfAndOnlyIfTheyAreOpposed) {
  math::RandomStream random(7, "opposed contacts");
  int opposed_count = 0;
  for (int k = 0; k < 300; ++k) {
    const auto direction = [&] {
      return Vec3(random.normal(), random.normal(), random.normal()).normalized();
    };
    const ContactSet set = sphere_set({direction(), direction()}, 0.9, 0.3);
    const bool opposed = has_opposed_contacts(set);
    const FerrariCanny epsilon = ferrari_canny(set, ForceLimit::sum);
    if (std::abs(epsilon.lower) < 1e-2) continue;  // on the cones' boundary
    EXPECT_EQ(opposed, epsilon.lower > 0) << epsilon.lower;
    opposed_count += opposed ? 1 : 0;
  }
  EXPECT_GT(opposed_count, 20);
}

}  // namespace
}  // namespace morphe::closure
