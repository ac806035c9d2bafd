#include "core/closure/wrench_set.hpp"

#include <gtest/gtest.h>

#include "tests/core/closure/grasps.hpp"

namespace morphe::closure {
namespace {

Wrench random_twist(math::RandomStream& random) {
  Wrench u;
  u << random.normal_vector3(), random.normal_vector3();
  return u.normalized();
}

/// The wrench of a force in the cone of one contact, drawn evenly over all that it may do.
Wrench random_wrench(math::RandomStream& random, const ContactSet& set, const Contact& contact) {
  const Vec3 bend = random.normal_vector3().normalized() * std::cbrt(random.uniform());
  const Vec3 across = contact.normal.unitOrthogonal(), along = contact.normal.cross(across);
  Wrench wrench =
      wrench_of(contact.normal + set.friction.mu * (bend.x() * across + bend.y() * along),
                moment_arm(set, contact));
  wrench.tail<3>() += set.friction.gamma_m / set.torque_scale_m * bend.z() * contact.normal;
  return wrench;
}

TEST(WrenchSet, SupportIsAttainedAndNothingLiesBeyond) {
  math::RandomStream random(1, "support");
  for (int trial = 0; trial < 200; ++trial) {
    const ContactSet contacts = random_grasp(random, 1 + trial % 5, trial % 2 ? 0.01 : 0);
    const Wrench u = random_twist(random);
    const WrenchSet hull = make_wrench_set(contacts, ForceLimit::sum);
    const WrenchSet sum = make_wrench_set(contacts, ForceLimit::each);
    const Support far_hull = support(hull, u), far_sum = support(sum, u);
    EXPECT_NEAR(far_hull.value, u.dot(far_hull.point), 1e-13);
    EXPECT_NEAR(far_sum.value, u.dot(far_sum.point), 1e-13);
    EXPECT_LE(far_hull.point.norm(), hull.radius);
    EXPECT_LE(far_sum.point.norm(), sum.radius);
    for (int draw = 0; draw < 50; ++draw) {
      Wrench all = Wrench::Zero();
      for (const Contact& contact : contacts.contacts) {
        const Wrench one = random_wrench(random, contacts, contact);
        EXPECT_LE(u.dot(one), far_hull.value + 1e-13);
        all += random.uniform() * one;
      }
      EXPECT_LE(u.dot(all), far_sum.value + 1e-13);
    }
  }
}

/// A point that moves along its normal has no tangential velocity but rounding, whose direction is
/// any: the force must stay in the cone, and the support be attained.
TEST(WrenchSet, VelocityAlongTheNormal) {
  math::RandomStream random(1, "along the normal");
  for (int trial = 0; trial < 1000; ++trial) {
    const ContactSet contacts = random_grasp(random, 1, 0);
    const WrenchSet set = make_wrench_set(contacts, ForceLimit::sum);
    const Vec3 turn = random.normal_vector3();
    Wrench u;
    u << contacts.contacts[0].normal - turn.cross(moment_arm(contacts, contacts.contacts[0])), turn;
    const Support there = support(set, u);
    EXPECT_NEAR(there.value, u.dot(there.point), 1e-13);
    const Vec3 n = contacts.contacts[0].normal, force = there.point.head<3>();
    EXPECT_NEAR(force.dot(n), 1, 1e-13);
    EXPECT_LE((force - n * force.dot(n)).norm(), contacts.friction.mu + 1e-13);
  }
}

TEST(WrenchSet, SupportIsBelowZeroWhereAllPushAway) {
  const ContactSet one = unit_set({{0, 0, -1}}, {{0, 0, 1}}, 0.5, 0);
  const Wrench down = -Wrench::Unit(2);
  EXPECT_DOUBLE_EQ(support(make_wrench_set(one, ForceLimit::sum), down).value, -1);
  EXPECT_DOUBLE_EQ(support(make_wrench_set(one, ForceLimit::each), down).value, 0);
}

TEST(WrenchSet, WhatIsWrongIsSaid) {
  const ContactSet right = two_fingers(1, 0.5, 0);
  EXPECT_EQ(validation_error(right), "");
  const auto wrong = [&](auto change) {
    ContactSet set = right;
    change(set);
    return validation_error(set);
  };
  EXPECT_EQ(wrong([](ContactSet& set) { set.friction.mu = kUnknown; }),
            "friction must be 0 or more");
  EXPECT_EQ(wrong([](ContactSet& set) { set.friction.gamma_m = -1; }),
            "torsional friction must be 0 or more");
  EXPECT_EQ(wrong([](ContactSet& set) { set.torque_scale_m = 0; }),
            "the torque scale must be above 0");
  EXPECT_EQ(wrong([](ContactSet& set) { set.reference[1] = kUnknown; }),
            "the reference point must be finite");
  EXPECT_EQ(wrong([](ContactSet& set) { set.contacts[1].point[0] = kInfinity; }),
            "contact 1: its point must be finite");
  EXPECT_EQ(wrong([](ContactSet& set) { set.contacts[0].normal *= 1.01; }),
            "contact 0: its normal is not a unit vector");
}

}  // namespace
}  // namespace morphe::closure
