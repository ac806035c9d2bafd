#include "core/cover/cover_primitives.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/cover/capsule_surface.hpp"
#include "core/cover/fit_capsules.hpp"

namespace morphe::cover {
namespace {

SceneObject primitive(Shape shape, std::vector<double> size, const Pose& pose = Pose::Identity()) {
  SceneObject object;
  object.shape = shape;
  object.size = std::move(size);
  object.position = {pose.translation()};
  object.orientation = {Quat(pose.linear())};
  return object;
}

Pose turned(const Vec3& position, const Vec3& axis, double angle) {
  return make_pose(position, Quat(Eigen::AngleAxisd(angle, axis.normalized())));
}

/// Returns a random point of a body, often one on its edges.
Vec3 random_point(const SceneObject& body, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1.2, 1.2), angle(0, 2 * M_PI);
  const auto draw = [&] { return std::clamp(coordinate(random), -1.0, 1.0); };
  Vec3 point = Vec3::Zero();
  if (body.shape == Shape::box) {
    for (int k = 0; k < 3; ++k) point[k] = 0.5 * body.size[static_cast<std::size_t>(k)] * draw();
  } else if (body.shape == Shape::cylinder) {
    const double r = body.size[0] * std::sqrt(std::abs(draw())), a = angle(random);
    point = {r * std::cos(a), r * std::sin(a), 0.5 * body.size[1] * draw()};
  }
  return make_pose(body.position[0], body.orientation[0]) * point;
}

std::vector<std::vector<SceneObject>> bodies_to_cover() {
  const Pose tilted = turned({0.1, -0.2, 0.3}, {1, 2, 3}, 0.8);
  return {
      {primitive(Shape::box, {0.1, 0.06, 0.03})},
      {primitive(Shape::box, {0.03, 0.2, 0.05}, tilted)},
      {primitive(Shape::box, {0.002, 0.1, 0.2})},
      {primitive(Shape::cylinder, {0.05, 0.3}, tilted)},
      {primitive(Shape::cylinder, {0.05, 0.06})},
      {primitive(Shape::cylinder, {0.08, 0.02}, tilted)},
      {primitive(Shape::box, {0.1, 0.06, 0.03}), primitive(Shape::cylinder, {0.02, 0.2}, tilted),
       primitive(Shape::sphere, {0.03}, turned({0.2, 0, 0}, {1, 0, 0}, 0))}};
}

TEST(CoverPrimitives, NothingIsOutside) {
  std::mt19937 random(5);
  for (const std::vector<SceneObject>& bodies : bodies_to_cover()) {
    for (const int budget : {1, 2, 3, 5, 12, 40}) {
      const auto capsules = cover_primitives(bodies, budget);
      ASSERT_EQ(capsules.empty(), budget < std::ssize(bodies));
      if (capsules.empty()) continue;
      EXPECT_LE(std::ssize(capsules), budget);
      double farthest = -1;
      for (int i = 0; i < 4000; ++i)
        for (const SceneObject& body : bodies)
          farthest =
              std::max(farthest, union_signed_distance(capsules, random_point(body, random)));
      EXPECT_LE(farthest, 0) << budget;
    }
  }
}

TEST(CoverPrimitives, StandoffsOfABoxAreThoseOfTheFormula) {
  // Four cells of 25 x 25 mm: with e = 0 the capsules stand off the sides by 5.2 mm.
  const auto capsules = cover_primitives({primitive(Shape::box, {1, 0.05, 0.05})}, 4);
  ASSERT_EQ(capsules.size(), 4u);
  const double w = 0.0125, e = 0.5 - capsules[0].to.x();
  EXPECT_NEAR(capsules[0].radius, std::sqrt(2 * w * w + e * e), 1e-5);
  EXPECT_LT(capsules[0].radius - w, 0.008);
}

TEST(CoverPrimitives, MoreCapsulesAreNearer) {
  for (const std::vector<SceneObject>& bodies : bodies_to_cover()) {
    double last = 1;
    for (const int budget : {4, 8, 16, 32}) {
      const double standoff = fit_capsules(bodies, FitOptions{budget}, "x").quality.standoff_95_m;
      EXPECT_LE(standoff, 1.02 * last) << budget;
      last = standoff;
    }
  }
}

TEST(CoverPrimitives, OtherShapesAreLeftToTheFit) {
  SceneObject mesh;
  mesh.shape = Shape::mesh;
  EXPECT_TRUE(cover_primitives({mesh}, 4).empty());
  EXPECT_TRUE(cover_primitives({primitive(Shape::box, {0.1, 0, 0.1})}, 4).empty());
  EXPECT_TRUE(cover_primitives({}, 4).empty());
}

TEST(CoverPrimitives, DistancesAreThoseFromTheNearestBody) {
  const std::vector<SceneObject> bodies = {
      primitive(Shape::box, {0.2, 0.2, 0.2}),
      primitive(Shape::sphere, {0.1}, turned({1, 0, 0}, {1, 0, 0}, 0))};
  EXPECT_NEAR(distance_from_primitives(bodies, {0.4, 0, 0}), 0.3, 1e-12);
  EXPECT_NEAR(distance_from_primitives(bodies, {0.7, 0, 0}), 0.2, 1e-12);
  EXPECT_EQ(distance_from_primitives(bodies, {0.05, 0, 0}), 0);
}

}  // namespace
}  // namespace morphe::cover
