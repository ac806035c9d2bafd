// Capsules must hold what they stand for, whatever its shape and however its mesh was made.
#include "core/cover/fit_capsules.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/cover/surface.hpp"
#include "core/cover/voxels.hpp"

namespace morphe::cover {
namespace {

SceneObject at_origin(Shape shape, std::vector<double> size) {
  SceneObject body;
  body.shape = shape;
  body.size = std::move(size);
  body.position = {Vec3::Zero()};
  body.orientation = {Quat::Identity()};
  return body;
}

/// A tube of radius 15 mm bent to a ring of 60 mm.
SceneObject ring() {
  constexpr int kAround = 48, kAcross = 20;
  const auto at = [](int i, int k) -> Vec3 {
    const double a = 2 * std::numbers::pi * i / kAround, b = 2 * std::numbers::pi * k / kAcross;
    const double r = 0.06 + 0.015 * std::cos(b);
    return {r * std::cos(a), r * std::sin(a), 0.015 * std::sin(b)};
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < kAround; ++i) {
    for (int k = 0; k < kAcross; ++k) {
      triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return mesh_of(triangles);
}

SceneObject shifted(SceneObject body, const Vec3& by) {
  body.position[0] += by;
  return body;
}

struct Case {
  std::string name;
  std::function<std::vector<SceneObject>()> bodies;
};

std::vector<Case> cases() {
  const auto box = [] { return at_origin(Shape::box, {0.1, 0.06, 0.03}); };
  return {
      {"box", [=] { return std::vector{box()}; }},
      {"cylinder",
       [] {
         return std::vector{at_origin(Shape::cylinder, {0.05, 0.2})};
       }},
      {"ring", [] { return std::vector{ring()}; }},
      {"angle",
       [=] {
         return std::vector{box(),
                            shifted(at_origin(Shape::box, {0.03, 0.06, 0.12}), {0.05, 0, 0.06})};
       }},
      {"plate",
       [] {
         return std::vector{at_origin(Shape::box, {0.2, 0.1, 0.002})};
       }},
      {"two_parts",
       [=] {
         return std::vector{box(), shifted(box(), {0.3, 0, 0})};
       }},
      {"open_shell",
       [=] {
         std::vector<Triangle> faces = surface_of({box()});
         faces.resize(faces.size() - 2);  // without its lid
         return std::vector{mesh_of(faces)};
       }},
      {"inside_out",
       [=] {
         std::vector<Triangle> faces = surface_of({box()});
         for (Triangle& t : faces) std::swap(t.a, t.b);
         return std::vector{mesh_of(faces)};
       }},
  };
}

double outside(const std::vector<collision::CapsuleBody>& capsules, const Vec3& point) {
  double least = 1;
  for (const auto& c : capsules) {
    const Vec3 axis = c.to - c.from;
    const double t = axis.squaredNorm() > 0
                         ? std::clamp((point - c.from).dot(axis) / axis.squaredNorm(), 0.0, 1.0)
                         : 0;
    least = std::min(least, (point - c.from - t * axis).norm() - c.radius);
  }
  return least;
}

class Covers : public testing::TestWithParam<int> {};

TEST_P(Covers, HoldsTheSurfaceWithinItsBudget) {
  const Case which = cases()[static_cast<std::size_t>(GetParam())];
  for (const int budget : {1, 4, 12}) {
    const std::vector<SceneObject> bodies = which.bodies();
    const CapsuleFit cover = fit_capsules(bodies, {budget}, which.name);
    ASSERT_FALSE(cover.capsules.empty());
    EXPECT_LE(cover.capsules.size(), static_cast<std::size_t>(budget));
    double worst = 0;
    for (const Vec3& point : sample_area(surface_of(bodies), 50000, "a judge of its own"))
      worst = std::max(worst, outside(cover.capsules, point));
    EXPECT_LT(worst, 0.001) << which.name << " " << budget;
    EXPECT_NEAR(cover.quality.largest_gap_m, worst, 0.0007);
    EXPECT_GT(cover.quality.coverage, 0.99);
  }
}
INSTANTIATE_TEST_SUITE_P(Shapes, Covers, testing::Range(0, 8), [](const auto& instance) {
  return cases()[static_cast<std::size_t>(instance.param)].name;
});

TEST(Cover, MoreCapsulesStandOffLess) {
  for (const char* name : {"box", "ring", "angle"}) {
    for (const Case& which : cases()) {
      if (which.name != name) continue;
      const double few = fit_capsules(which.bodies(), {2}, name).quality.standoff_95_m;
      const double more = fit_capsules(which.bodies(), {16}, name).quality.standoff_95_m;
      EXPECT_LT(more, 0.7 * few) << name;
    }
  }
  // A ring of eight capsules stands off its tube by millimetres, not by its radius.
  EXPECT_LT(fit_capsules({ring()}, {10}, "ring").quality.standoff_95_m, 0.008);
}

TEST(Cover, ABoxIsHeldMoreTightlyThanByARowAlongIt) {
  // A row of two capsules along a box of 100 x 60 x 30 mm stands 34 mm off its ends.
  const CapsuleFit cover = fit_capsules({at_origin(Shape::box, {0.1, 0.06, 0.03})}, {6}, "box");
  EXPECT_LT(cover.quality.standoff_95_m, 0.012);
}

TEST(Cover, BallsAndCapsulesStayWhatTheyAre) {
  const SceneObject ball = shifted(at_origin(Shape::sphere, {0.02}), {0, 0, 0.1});
  const SceneObject other = shifted(at_origin(Shape::sphere, {0.02}), {0, 0, -0.1});
  const CapsuleFit one = fit_capsules({ball}, {4}, "ball");
  ASSERT_EQ(one.capsules.size(), 1u);
  EXPECT_EQ(one.capsules[0].radius, 0.02);
  EXPECT_EQ(one.capsules[0].from, Vec3(0, 0, 0.1));
  const CapsuleFit rod =
      fit_capsules({at_origin(Shape::cylinder, {0.02, 0.2}), ball, other}, {4}, "rod");
  ASSERT_EQ(rod.capsules.size(), 1u);
  EXPECT_EQ((rod.capsules[0].to - rod.capsules[0].from).norm(), 0.2);
  EXPECT_EQ(rod.quality.largest_gap_m, 0);
}

TEST(Cover, TheSameTwice) {
  const CapsuleFit a = fit_capsules({ring()}, {8}, "ring"), b = fit_capsules({ring()}, {8}, "ring");
  ASSERT_EQ(a.capsules.size(), b.capsules.size());
  for (std::size_t k = 0; k < a.capsules.size(); ++k) {
    EXPECT_EQ(a.capsules[k].from, b.capsules[k].from);
    EXPECT_EQ(a.capsules[k].radius, b.capsules[k].radius);
  }
}

TEST(Voxels, DistancesAreThoseFromTheSurface) {
  const std::vector<SceneObject> ball = {at_origin(Shape::sphere, {0.1})};
  const Voxels voxels = voxels_of(surface_of(ball), 60);
  double worst = 0;
  for (int z = 0; z < voxels.count.z(); ++z) {
    for (int x = 0; x < voxels.count.x(); ++x) {
      const int y = voxels.count.y() / 3;
      const Vec3 at = voxels.centre(x, y, z);
      const std::size_t cell = voxels.index(x, y, z);
      worst = std::max(worst, std::abs(voxels.distance[cell] - std::abs(at.norm() - 0.1)));
      if (std::abs(at.norm() - 0.1) < 0.006) continue;
      EXPECT_EQ(voxels.inside[cell], at.norm() < 0.1);
    }
  }
  EXPECT_LT(worst, 2 * voxels.step_m);
  EXPECT_NEAR(voxels.outside_distance({0.2, 0, 0}), 0.1, 2 * voxels.step_m);
}

}  // namespace
}  // namespace morphe::cover
