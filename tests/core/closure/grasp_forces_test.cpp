#include "core/closure/grasp_forces.hpp"

#include <gtest/gtest.h>

#include "tests/core/closure/grasps.hpp"

namespace morphe::closure {
namespace {

/// A thumb against four fingers in a row, 20 mm apart.
ContactSet hand() {
  ContactSet set;
  set.contacts.push_back({{0.03, 0, 0}, {-1, 0, 0}});
  for (int k = 0; k < 4; ++k) set.contacts.push_back({{-0.03, 0, -0.03 + 0.02 * k}, {1, 0, 0}});
  set.friction = {0.8, 0.002};
  set.torque_scale_m = 0.05;
  return set;
}

Wrench weight(double newtons) { return -newtons * Wrench::Unit(2); }

double pressing(const ContactSet& set, const GraspForces& squeeze, std::size_t k) {
  return squeeze.forces[k].force.dot(set.contacts[k].normal);
}

/// Inside the shares and cones; and the residual is what it says.
void expect_lawful(const ContactSet& set, const Wrench& load, const GraspForceOptions& options,
                   const GraspForces& squeeze) {
  ASSERT_EQ(squeeze.forces.size(), set.contacts.size());
  Wrench sum = load;
  for (std::size_t k = 0; k < set.contacts.size(); ++k) {
    const Contact& contact = set.contacts[k];
    const ContactForce& at = squeeze.forces[k];
    const double n = pressing(set, squeeze, k);
    const double across = (at.force - n * contact.normal).norm() / set.friction.mu;
    const double spin =
        set.friction.gamma_m > 0 ? at.moment_nm / set.friction.gamma_m : at.moment_nm;
    EXPECT_LE(std::hypot(across, spin), options.friction_cone_share * n + 1e-9);
    EXPECT_LE(n, options.max_force_n + 1e-9);
    EXPECT_GE(n, options.min_force_share * squeeze.max_force_n - 1e-9);
    sum.head<3>() += at.force;
    sum.tail<3>() +=
        ((contact.point - set.reference).cross(at.force) + at.moment_nm * contact.normal) /
        set.torque_scale_m;
  }
  EXPECT_LT((sum - squeeze.residual).norm(), 1e-10);
}

TEST(ShareForces, TwoFingersHalfTheWeightEach) {
  ContactSet set = two_fingers(0.03, 0.6, 0.002);
  set.torque_scale_m = 0.03;
  const GraspForceOptions options{5, 0.3, 0.7};
  const Wrench load = 2.943 * Wrench::Unit(0);
  const GraspForces squeeze = distribute_grasp_forces(set, load, options);
  expect_lawful(set, load, options, squeeze);
  EXPECT_TRUE(squeeze.converged);
  EXPECT_LT(squeeze.residual.norm(), 1e-6);
  for (const std::size_t k : {0u, 1u}) {
    EXPECT_NEAR(pressing(set, squeeze, k), 5, 1e-3);
    EXPECT_NEAR(squeeze.forces[k].force.x(), -2.943 / 2, 1e-6);
  }
}

/// What a weight asks for beyond the cones' share is left over: 7 N less 2 · 0.7 · 0.6 · 5.
TEST(ShareForces, TooHeavy) {
  ContactSet set = two_fingers(0.03, 0.6, 0.002);
  set.torque_scale_m = 0.03;
  const GraspForceOptions options{5, 0.3, 0.7};
  const Wrench load = 7 * Wrench::Unit(0);
  const GraspForces squeeze = distribute_grasp_forces(set, load, options);
  expect_lawful(set, load, options, squeeze);
  EXPECT_NEAR(squeeze.residual.norm(), 7 - 2 * 0.7 * 0.6 * 5, 1e-3);
}

TEST(ShareForces, EveryFingerOfAHandPresses) {
  const ContactSet set = hand();
  const GraspForceOptions options{8, 0.2, 0.7};
  const GraspForces squeeze = distribute_grasp_forces(set, weight(2.943), options);
  expect_lawful(set, weight(2.943), options, squeeze);
  EXPECT_LT(squeeze.residual.norm(), 1e-6);
  EXPECT_NEAR(pressing(set, squeeze, 0), 8, 1e-3);
  double fingers = 0;
  for (std::size_t k = 1; k < 5; ++k) fingers += pressing(set, squeeze, k);
  EXPECT_NEAR(fingers, pressing(set, squeeze, 0), 1e-6);
  EXPECT_GT(squeeze.min_force_n, 1.6);
}

/// Four fingers that press with half of the thumb's force each cannot balance it.
TEST(ShareForces, SharesThatCannotBalance) {
  const ContactSet set = hand();
  const GraspForceOptions options{8, 0.5, 0.7};
  const GraspForces squeeze = distribute_grasp_forces(set, Wrench::Zero(), options);
  expect_lawful(set, Wrench::Zero(), options, squeeze);
  EXPECT_LT(squeeze.max_force_n, 0.01);
}

/// f_n of one contact is at most `newtons`.
ForceBound pressing_at_most(const ContactSet& set, std::size_t contact, double newtons) {
  ForceBound bound;
  bound.force.assign(set.contacts.size(), Vec3::Zero());
  bound.moment.assign(set.contacts.size(), 0);
  bound.force[contact] = set.contacts[contact].normal;
  bound.upper_bound = newtons;
  return bound;
}

TEST(ShareForces, BoundsHold) {
  const ContactSet set = hand();
  const GraspForceOptions options{8, 0.2, 0.7};
  std::vector<ForceBound> bounds{pressing_at_most(set, 0, 5), pressing_at_most(set, 1, 1.05)};
  // A joint of the last finger: 0.04 N m at a lever of 30 mm against forces along x.
  ForceBound joint = pressing_at_most(set, 4, 0.04);
  joint.force[4] = {0.03, 0, 0.01};
  bounds.push_back(joint);
  const GraspForces squeeze = distribute_grasp_forces(set, weight(2.943), options, bounds);
  expect_lawful(set, weight(2.943), options, squeeze);
  EXPECT_LT(squeeze.residual.norm(), 1e-6);
  EXPECT_NEAR(pressing(set, squeeze, 0), 5, 1e-2);
  EXPECT_LE(pressing(set, squeeze, 1), 1.05);
  EXPECT_LE(joint.force[4].dot(squeeze.forces[4].force), 0.04);
}

TEST(ShareForces, WithoutFrictionOrContacts) {
  const ContactSet set = octahedron(0);
  const GraspForceOptions options{3, 0.5, 1};
  const GraspForces squeeze = distribute_grasp_forces(set, Wrench::Zero(), options);
  EXPECT_TRUE(squeeze.converged);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(pressing(set, squeeze, k), 3, 1e-3);
  const GraspForces none = distribute_grasp_forces(ContactSet{}, weight(1), options);
  EXPECT_TRUE(none.forces.empty());
  EXPECT_EQ(none.residual, weight(1));
}

}  // namespace
}  // namespace morphe::closure
