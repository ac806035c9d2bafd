#include "core/closure/incremental_hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/math/random_stream.hpp"

namespace morphe::closure {
namespace {

using Facet = IncrementalHull::Facet;

Wrench random_point(math::RandomStream& random, int dimensions) {
  Wrench point = Wrench::Zero();
  for (int k = 0; k < dimensions; ++k) point[k] = random.normal();
  return point;
}

std::vector<Wrench> random_points(math::RandomStream& random, int dimensions, int count) {
  std::vector<Wrench> points;
  for (int k = 0; k < count; ++k) points.push_back(random_point(random, dimensions));
  return points;
}

/// The facet that a point lies beyond by most.
std::int32_t farthest_beyond(const IncrementalHull& polytope, const Wrench& point) {
  std::int32_t best = 0;
  double most = -kInfinity;
  for (std::size_t k = 0; k < polytope.facets().size(); ++k) {
    const Facet& facet = polytope.facets()[k];
    const double height = facet.normal.dot(point) - facet.distance;
    if (facet.alive && height > most) {
      most = height;
      best = static_cast<std::int32_t>(k);
    }
  }
  return best;
}

/// Every ridge is in just two facets, which know each other; every point is behind every facet.
void expect_sound(const IncrementalHull& polytope, const std::vector<Wrench>& points) {
  const auto n = static_cast<std::size_t>(polytope.dimension());
  std::map<std::multiset<std::int32_t>, int> ridges;
  for (std::size_t id = 0; id < polytope.facets().size(); ++id) {
    const Facet& facet = polytope.facets()[id];
    if (!facet.alive) continue;
    EXPECT_NEAR(facet.normal.norm(), 1, 1e-12);
    for (const Wrench& point : points) EXPECT_LE(facet.normal.dot(point), facet.distance + 1e-10);
    for (std::size_t slot = 0; slot < n; ++slot) {
      const auto vertex = static_cast<std::size_t>(facet.vertex[slot]);
      EXPECT_NEAR(facet.normal.dot(points[vertex]), facet.distance, 1e-10);
      std::multiset<std::int32_t> ridge(facet.vertex.begin(),
                                        facet.vertex.begin() + polytope.dimension());
      ridge.erase(ridge.find(facet.vertex[slot]));
      ++ridges[ridge];
      const Facet& across = polytope.facets()[static_cast<std::size_t>(facet.neighbour[slot])];
      const auto back = static_cast<std::size_t>(facet.reciprocal_slot[slot]);
      EXPECT_TRUE(across.alive);
      EXPECT_EQ(across.neighbour[back], static_cast<std::int32_t>(id));
      std::multiset<std::int32_t> same(across.vertex.begin(),
                                       across.vertex.begin() + polytope.dimension());
      same.erase(same.find(across.vertex[back]));
      EXPECT_EQ(same, ridge);
    }
  }
  for (const auto& [ridge, count] : ridges) EXPECT_EQ(count, 2);
}

class InDimensions : public testing::TestWithParam<int> {};

TEST_P(InDimensions, RandomPointsAreAllBehindTheSurface) {
  const int n = GetParam();
  math::RandomStream random(1, "polytope");
  std::vector<Wrench> points = random_points(random, n, n + 1);
  IncrementalHull polytope(points);
  expect_sound(polytope, points);
  for (int k = 0; k < 25; ++k) {
    const Wrench point = random_point(random, n);
    // Points inside are none of its vertices.
    if (polytope.insert(point, farthest_beyond(polytope, point), 1e-12)) points.push_back(point);
  }
  EXPECT_GT(points.size(), static_cast<std::size_t>(n) + 1);
  expect_sound(polytope, points);
}

INSTANTIATE_TEST_SUITE_P(GrowingPolytope, InDimensions, testing::Range(1, 7));

/// The corners of a cube lie by fours on a plane: every insertion meets facets that it lies in.
TEST(GrowingPolytope, CoplanarPoints) {
  std::vector<Wrench> points;
  const auto corner = [](int k) {
    Wrench point = Wrench::Zero();
    for (int axis = 0; axis < 3; ++axis) point[axis] = (k >> axis) % 2 ? 1 : -1;
    return point;
  };
  for (const int k : {0, 1, 2, 4}) points.push_back(corner(k));
  IncrementalHull polytope(points);
  for (const int k : {3, 5, 6, 7}) {
    points.push_back(corner(k));
    ASSERT_TRUE(polytope.insert(points.back(), farthest_beyond(polytope, points.back()), 1e-12));
  }
  int alive = 0;
  for (const Facet& facet : polytope.facets()) {
    if (!facet.alive) continue;
    ++alive;
    EXPECT_NEAR(facet.distance, 1, 1e-12);
  }
  EXPECT_EQ(alive, 12);
  expect_sound(polytope, points);
}

TEST(GrowingPolytope, APointInsideChangesNothing) {
  math::RandomStream random(1, "inside");
  const std::vector<Wrench> points = random_points(random, 6, 7);
  IncrementalHull polytope(points);
  EXPECT_FALSE(polytope.insert(polytope.centre(), 0, 1e-12));
  EXPECT_FALSE(polytope.insert(points[3], 3, 1e-12));
  EXPECT_EQ(polytope.facets().size(), 7u);
  expect_sound(polytope, points);
}

}  // namespace
}  // namespace morphe::closure
