#include "core/closure/ferrari_canny.hpp"

#include <gtest/gtest.h>

#include "core/closure/least_ratio.hpp"
#include "tests/core/closure/grasps.hpp"
#include "tests/core/closure/polygon_hull.hpp"

namespace morphe::closure {
namespace {

constexpr ForceLimit kBoth[] = {ForceLimit::sum, ForceLimit::each};

double height(const ContactSet& set, ForceLimit limit, const Wrench& u) {
  return support(make_wrench_set(set, limit), u).value;
}

/// The bounds are in order, the upper one is what its direction says, and a null direction is one.
void expect_proven(const ContactSet& set, ForceLimit limit, const FerrariCanny& found) {
  EXPECT_LE(found.lower, found.upper);
  EXPECT_NEAR(found.weakest_twist.norm(), 1, 1e-9);
  if (found.exactly_zero) {
    EXPECT_EQ(found.lower, 0);
    EXPECT_EQ(found.upper, 0);
    EXPECT_LE(height(set, limit, found.weakest_twist), 1e-10);
  } else {
    EXPECT_NEAR(height(set, limit, found.weakest_twist), found.upper, 1e-12);
  }
}

TEST(FerrariCanny, ClosedForms) {
  for (const ClosedForm& form : closed_forms()) {
    for (const ForceLimit limit : kBoth) {
      const double truth = limit == ForceLimit::sum ? form.sum : form.each;
      if (std::isnan(truth)) continue;
      // Two opposite fingers are weakest in a whole family of directions, which has to be covered:
      // 1e-5 takes a second there (bench_closure does it).
      const bool family = form.name == "two opposite";
      const double gap = limit == ForceLimit::each ? 2e-3 : family ? 2e-4 : 1e-5;
      const FerrariCanny found = ferrari_canny(form.set, limit, {0, gap, 1000});
      expect_proven(form.set, limit, found);
      EXPECT_TRUE(found.within_tolerance) << form.name;
      EXPECT_LE(found.lower, truth + 1e-6) << form.name;
      EXPECT_GE(found.upper, truth - 1e-6) << form.name;
      EXPECT_LE(found.upper - found.lower, gap + 1e-12) << form.name;
    }
  }
}

TEST(FerrariCanny, ThreeOnADiscInThePlane) {
  // Torques out of the plane and forces across it are not asked for.
  const Gauge planar = [](const Wrench& u) { return Vec3(u[0], u[1], u[5]).norm(); };
  for (const auto& [mu, truth] :
       {std::pair{0.3, 0.3}, std::pair{0.8, 0.8}, std::pair{1.0, 0.935113}}) {
    const LeastRatio found = least_ratio(make_wrench_set(three_fingers(mu, 0), ForceLimit::sum),
                                         planar, {0, 1e-6, 1000}, {});
    EXPECT_NEAR(found.bounds.lower, truth, 2e-6);
    EXPECT_NEAR(found.bounds.upper, truth, 2e-6);
  }
}

TEST(FerrariCanny, ExactlyZero) {
  std::vector<ContactSet> flat;
  flat.push_back(two_fingers(1, 0.8, 0));
  ContactSet line = two_fingers(1, 0.8, 0);  // four on one line
  line.contacts.push_back({{0, 0, 0.3}, {0.6, 0, -0.8}});
  line.contacts.push_back({{0, 0, -0.7}, {0, 0.6, 0.8}});
  flat.push_back(line);
  flat.push_back(octahedron(0));  // a sphere without friction
  flat.push_back(two_fingers(0.5, 0, 0));
  flat.push_back(ContactSet{});
  math::RandomStream random(1, "flat");
  for (const ContactSet& one : flat) {
    for (int turned = 0; turned < 4; ++turned) {
      const ContactSet set = moved(one, random.rotation(), random.normal_vector3());
      for (const ForceLimit limit : kBoth) {
        const FerrariCanny found = ferrari_canny(set, limit);
        EXPECT_TRUE(found.exactly_zero);
        EXPECT_FALSE(found.force_closure());
        EXPECT_EQ(found.residual(), 0);
        expect_proven(set, limit, found);
        if (!set.contacts.empty()) {
          EXPECT_LE(height(set, ForceLimit::sum, -found.weakest_twist), 1e-10);
        }
      }
    }
  }
}

TEST(FerrariCanny, AlmostFlat) {
  std::vector<ContactSet> sets;
  sets.push_back(two_fingers(1, 0.8, 1e-9));
  sets.push_back(octahedron(1e-9));
  ContactSet third = two_fingers(1, 0.8, 0);
  third.contacts.push_back({{1e-9, 0, 0.5}, {0, 0, -1}});
  sets.push_back(third);
  sets.push_back(two_fingers(1, 1e-9, 0.1));
  for (const ContactSet& set : sets) {
    for (const ForceLimit limit : kBoth) {
      const FerrariCanny found = ferrari_canny(set, limit);
      EXPECT_TRUE(found.within_tolerance);
      EXPECT_GE(found.lower, -1e-8);
      EXPECT_LE(found.upper, 1e-8);
      expect_proven(set, limit, found);
    }
  }
}

/// 0 is in such a set or 1e-9 beside it; so is all that it could resist.
TEST(FerrariCanny, RandomFlatSets) {
  math::RandomStream random(1, "flat sets");
  for (const double off : {0.0, 1e-9}) {
    for (int trial = 0; trial < 60; ++trial) {
      const ContactSet set = flat_grasp(random, trial, off);
      for (const ForceLimit limit : kBoth) {
        const FerrariCanny found = ferrari_canny(set, limit);
        expect_proven(set, limit, found);
        EXPECT_TRUE(found.within_tolerance);
        EXPECT_NEAR(found.upper, 0, 1e-7) << trial;
        EXPECT_NEAR(found.lower, 0, 1e-7) << trial;
        if (off == 0) {
          EXPECT_TRUE(found.exactly_zero) << trial;
        }
      }
    }
  }
}

TEST(FerrariCanny, CoplanarFacets) {
  math::RandomStream random(1, "cubes");
  int closed = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const ContactSet set =
        cube_grasp(random, 2 + trial % 5, random.uniform(0.1, 1.2), trial % 3 ? 0.03 : 0);
    for (const ForceLimit limit : kBoth) {
      const FerrariCanny found = ferrari_canny(set, limit);
      expect_proven(set, limit, found);
      EXPECT_TRUE(found.within_tolerance) << trial;
      closed += found.force_closure() ? 1 : 0;
    }
  }
  EXPECT_GT(closed, 50);
}

TEST(FerrariCanny, NotClosed) {
  // Three fingers from below leave at least their own push over; L∞ can leave out all force.
  const ContactSet below = unit_set({{0.5, 0, -1}, {-0.3, 0.4, -1}, {-0.3, -0.4, -1}},
                                    {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, 0.5, 0);
  const FerrariCanny sum = ferrari_canny(below, ForceLimit::sum);
  EXPECT_LE(sum.lower, -1);
  EXPECT_LE(sum.upper, -0.9);
  EXPECT_NEAR(sum.residual(), 1, 0.05);
  EXPECT_FALSE(sum.exactly_zero);
  expect_proven(below, ForceLimit::sum, sum);
  const FerrariCanny each = ferrari_canny(below, ForceLimit::each);
  EXPECT_TRUE(each.exactly_zero);
  EXPECT_LE(height(below, ForceLimit::each, each.weakest_twist), 0);
}

TEST(FerrariCanny, BetweenInscribedAndCircumscribedPolygons) {
  math::RandomStream random(1, "polygons");
  int closed = 0;
  for (int trial = 0; trial < 50; ++trial) {
    const ContactSet set = random_grasp(random, 3 + trial % 2, 0);
    const FerrariCanny found = ferrari_canny(set, ForceLimit::sum);
    expect_proven(set, ForceLimit::sum, found);
    EXPECT_TRUE(found.within_tolerance);
    const double inscribed = polygon_epsilon(set, 16, false),
                 around = polygon_epsilon(set, 16, true);
    closed += found.force_closure() ? 1 : 0;
    // Below 0 the distance of a facet is no distance of the hull.
    if (inscribed > 0) {
      EXPECT_LE(inscribed, found.upper + 1e-9);
    }
    if (found.force_closure()) {
      EXPECT_GE(around, found.lower - 1e-9);
    }
  }
  EXPECT_GT(closed, 10);
}

/// Descent on |u| = 1 from many starts, a search of its own, never gets below the lower bound.
TEST(FerrariCanny, DescentEndsBetweenTheBounds) {
  math::RandomStream random(1, "descent");
  int closed = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const ContactSet contacts = random_grasp(random, 3 + trial % 3, trial % 2 ? 0.002 : 0.02);
    for (const ForceLimit limit : kBoth) {
      const FerrariCanny found = ferrari_canny(contacts, limit);
      expect_proven(contacts, limit, found);
      EXPECT_TRUE(found.within_tolerance);
      if (!found.force_closure()) continue;
      ++closed;
      const WrenchSet set = make_wrench_set(contacts, limit);
      double least = kInfinity;
      for (int start = 0; start < 12; ++start) {
        Wrench u;
        u << random.normal_vector3(), random.normal_vector3();
        u.normalize();
        for (int step = 1; step < 150; ++step) {
          const Support there = support(set, u);
          least = std::min(least, there.value);
          const Wrench slope = there.point - there.point.dot(u) * u;
          u = (u - 0.5 / step / set.radius * slope).normalized();
        }
      }
      EXPECT_GE(least, found.lower);
    }
  }
  EXPECT_GT(closed, 30);
}

TEST(FerrariCanny, TheSameHoweverTheObjectLies) {
  math::RandomStream random(1, "turned");
  for (int trial = 0; trial < 40; ++trial) {
    const ContactSet set = random_grasp(random, 3 + trial % 3, 0.01);
    const ContactSet other = moved(set, random.rotation(), 0.3 * random.normal_vector3());
    for (const ForceLimit limit : kBoth) {
      const FerrariCanny a = ferrari_canny(set, limit, {0.01, 1e-3, 1000});
      const FerrariCanny b = ferrari_canny(other, limit, {0.01, 1e-3, 1000});
      // Both enclose the same number.
      EXPECT_LE(a.lower, b.upper + 1e-10);
      EXPECT_LE(b.lower, a.upper + 1e-10);
      EXPECT_LE(std::abs(a.upper - b.upper), std::max(1e-3, 0.01 * std::abs(a.upper)));
    }
  }
}

TEST(FerrariCanny, AContactListedTwice) {
  math::RandomStream random(1, "twice");
  for (int trial = 0; trial < 20; ++trial) {
    const ContactSet once = random_grasp(random, 4, trial % 2 ? 0.01 : 0);
    ContactSet twice = once;
    twice.contacts.push_back(once.contacts[1]);
    const FerrariCanny a = ferrari_canny(once, ForceLimit::sum);
    const FerrariCanny b = ferrari_canny(twice, ForceLimit::sum);
    EXPECT_EQ(a.lower, b.lower);
    EXPECT_EQ(a.upper, b.upper);
  }
  // Each of six fingers twice as strong: twice the ball.
  ContactSet set = octahedron(0.4);
  const double single = ferrari_canny(set, ForceLimit::each).upper;
  const std::vector<Contact> six = set.contacts;
  set.contacts.insert(set.contacts.end(), six.begin(), six.end());
  const FerrariCanny doubled = ferrari_canny(set, ForceLimit::each);
  EXPECT_NEAR(doubled.upper / single, 2, 0.1);
}

TEST(FerrariCanny, MillimetresInPlaceOfMetres) {
  math::RandomStream random(1, "scaled");
  for (int trial = 0; trial < 20; ++trial) {
    const ContactSet set = random_grasp(random, 4, 0.01);
    ContactSet scaled = set;
    scaled.friction.gamma_m *= 1024;
    scaled.torque_scale_m *= 1024;
    for (Contact& contact : scaled.contacts) contact.point *= 1024;
    const FerrariCanny a = ferrari_canny(set, ForceLimit::sum);
    const FerrariCanny b = ferrari_canny(scaled, ForceLimit::sum);
    EXPECT_EQ(a.lower, b.lower);
    EXPECT_EQ(a.upper, b.upper);
  }
}

TEST(FerrariCanny, SaysWhereItStopped) {
  const ContactSet set = three_fingers(0.5, 0.05);
  const FerrariCanny found = ferrari_canny(set, ForceLimit::sum, {0, 1e-6, 20});
  EXPECT_FALSE(found.within_tolerance);
  EXPECT_EQ(found.insertions, 20);
  EXPECT_LE(found.lower, 0.300440);
  EXPECT_GE(found.upper, 0.300440);
  EXPECT_GT(found.lower, 0.2);
}

}  // namespace
}  // namespace morphe::closure
