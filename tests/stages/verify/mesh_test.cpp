#include "stages/verify/mesh.hpp"
#include "random_points.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace morphe::verify {
namespace {

SceneObject mesh_of(std::vector<Vec3> vertices, std::vector<Eigen::Vector3i> triangles) {
  SceneObject object;
  object.shape = Shape::mesh;
  object.vertices = std::move(vertices);
  object.triangles = std::move(triangles);
  return object;
}

/// Every wall of `cells` by `cells` squares, their triangles turned at random; corners written out
/// for each. The last wall (above) is left out if `open`.
SceneObject box(const Vec3& size, int cells, Random& random, bool open = false) {
  SceneObject object = mesh_of({}, {});
  for (int wall = 0; wall < (open ? 5 : 6); ++wall) {
    const int axis = wall / 2;
    const auto at = [&](int i, int j) {
      Vec3 corner;
      corner[axis] = wall % 2 ? 0.5 : -0.5;
      corner[(axis + 1) % 3] = static_cast<double>(i) / cells - 0.5;
      corner[(axis + 2) % 3] = static_cast<double>(j) / cells - 0.5;
      return Vec3(corner.cwiseProduct(size));
    };
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const std::array<Vec3, 6> corners = {at(i, j), at(i + 1, j),     at(i + 1, j + 1),
                                             at(i, j), at(i + 1, j + 1), at(i, j + 1)};
        for (int t = 0; t < 2; ++t) {
          const int first = static_cast<int>(object.vertices.size());
          for (int k = 0; k < 3; ++k)
            object.vertices.push_back(corners[static_cast<std::size_t>(3 * t + k)]);
          const bool turned = random.in(0, 1) < 0.5;
          object.triangles.push_back({first, first + (turned ? 2 : 1), first + (turned ? 1 : 2)});
        }
      }
    }
  }
  return object;
}

TEST(JudgeMesh, ABoxOfTrianglesIsTheBox) {
  Random random(17);
  int inside_count = 0, through = 0;
  for (const int cells : {1, 3, 12}) {
    const Vec3 size(0.2, 0.3, 0.4);
    const Mesh mesh = make_mesh(box(size, cells, random));
    ASSERT_EQ(mesh.watertight, std::vector<char>{1});
    SceneObject solid;
    solid.shape = Shape::box;
    solid.size = {size.x(), size.y(), size.z()};
    for (int k = 0; k < 1500; ++k) {
      const Segment segment{random.point(0.35), random.point(0.35)};
      EXPECT_EQ(is_inside(mesh, segment.from), signed_distance(solid, segment.from) < 0);
      inside_count += signed_distance(solid, segment.from) < 0;
      const double expected = segment_solid_distance(solid, segment, kInfinity);
      const double got = segment_mesh_distance(mesh, segment, kInfinity);
      if (expected > 1e-8) {
        EXPECT_NEAR(got, expected, 1e-8);
      } else {
        ++through;
        EXPECT_GE(got, expected - 1e-8);
        EXPECT_LE(got, 0.95 * expected + 1.1e-5);
      }
      const double bound = segment_mesh_distance(mesh, segment, 0.05);
      EXPECT_TRUE(bound == got || (bound >= 0.05 && bound <= got));
    }
  }
  EXPECT_GT(inside_count, 100);
  EXPECT_GT(through, 300);
}

/// Points above corners and edges, where a ray along x meets several triangles at once.
TEST(JudgeMesh, RaysThroughCornersCountOnce) {
  Random random(17);
  const Mesh mesh = make_mesh(box(Vec3::Constant(0.2), 2, random));
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      for (int z = -3; z <= 3; ++z) {
        const Vec3 point = 0.05 * Vec3(x + 0.5, y, z);
        const double beyond = (point.cwiseAbs() - Vec3::Constant(0.1)).maxCoeff();
        if (std::abs(beyond) < 1e-9) continue;
        EXPECT_EQ(is_inside(mesh, point), beyond < 0) << point.transpose();
      }
    }
  }
}

TEST(JudgeMesh, AnOpenOneIsASheet) {
  Random random(17);
  const Mesh bowl = make_mesh(box(Vec3::Constant(0.4), 3, random, true));
  ASSERT_EQ(bowl.watertight, std::vector<char>{0});
  EXPECT_FALSE(is_inside(bowl, Vec3::Zero()));
  EXPECT_NEAR(segment_mesh_distance(bowl, {Vec3(-0.05, 0, 0), Vec3(0.05, 0, 0)}, kInfinity), 0.15,
              1e-12);
  EXPECT_NEAR(segment_mesh_distance(bowl, {Vec3(0, 0, 0), Vec3(0, 0, 0.5)}, kInfinity), 0.2, 1e-12);
  EXPECT_NEAR(segment_mesh_distance(bowl, {Vec3(0, 0, -0.5), Vec3(0, 0, 0.5)}, kInfinity), 0, 1e-9);
}

TEST(JudgeMesh, NestedAndDisjointPartsAreToldApart) {
  Random random(17);
  SceneObject object = box(Vec3::Constant(0.1), 1, random);
  const auto add = [&](double side, const Vec3& shift) {
    const SceneObject other = box(Vec3::Constant(side), 2, random);
    const int first = static_cast<int>(object.vertices.size());
    for (const Vec3& vertex : other.vertices) object.vertices.push_back(vertex + shift);
    for (const Eigen::Vector3i& t : other.triangles)
      object.triangles.push_back(t + Eigen::Vector3i::Constant(first));
  };
  add(0.2, Vec3::Zero());         // around the first: its cavity counts as solid
  add(0.1, Vec3(0.3, 0, 0));      // apart
  add(0.1, Vec3(0.34, 0.02, 0));  // overlaps that
  const Mesh mesh = make_mesh(object);
  EXPECT_EQ(mesh.watertight.size(), 4u);
  EXPECT_TRUE(is_inside(mesh, Vec3(0.01, 0.02, 0.03)));
  EXPECT_TRUE(is_inside(mesh, Vec3(0.08, 0, 0)));
  EXPECT_TRUE(is_inside(mesh, Vec3(0.32, 0.01, 0)));  // in both that overlap
  EXPECT_FALSE(is_inside(mesh, Vec3(0.2, 0, 0)));
}

/// Triangles without area neither hide anything nor stand in the way.
TEST(JudgeMesh, SliversDoNotCount) {
  Random random(17);
  SceneObject object = box(Vec3::Constant(0.2), 1, random);
  const int first = static_cast<int>(object.vertices.size());
  object.vertices.insert(object.vertices.end(),
                         {Vec3(0.1, 0.1, 0.1), Vec3(0.1, 0.1, -0.1), Vec3(0.1, 0.1, 0)});
  object.triangles.push_back({first, first + 1, first + 2});
  object.triangles.push_back({first, first, first + 2});
  const Mesh mesh = make_mesh(object);
  EXPECT_NEAR(segment_mesh_distance(mesh, {Vec3(0.4, 0.4, 0), Vec3(0.4, 0.4, 0.3)}, kInfinity),
              std::hypot(0.3, 0.3), 1e-9);
  EXPECT_NEAR(segment_mesh_distance(mesh, {Vec3(0, 0.4, 0), Vec3(0.1, 0.1, 0.7)}, kInfinity),
              segment_mesh_distance(make_mesh(box(Vec3::Constant(0.2), 1, random)),
                                    {Vec3(0, 0.4, 0), Vec3(0.1, 0.1, 0.7)}, kInfinity),
              1e-9);
  EXPECT_TRUE(make_mesh(mesh_of({Vec3::Zero(), Vec3::UnitX()}, {{0, 1, 1}})).triangles.empty());
}

}  // namespace
}  // namespace morphe::verify
