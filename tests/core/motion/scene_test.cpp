#include "core/motion/scene.hpp"
#include "core/motion/bounding_box.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace morphe {
namespace {

SceneObject body(Shape shape, std::vector<double> size) {
  SceneObject object;
  object.shape = shape;
  object.size = std::move(size);
  return object;
}

Vec3 sizes_of(const SceneObject& object, const Quat& turn) {
  const Eigen::AlignedBox3d extent = bounding_box(object, make_pose(Vec3(1, 2, 3), turn));
  EXPECT_TRUE(object.shape == Shape::mesh || extent.center().isApprox(Vec3(1, 2, 3), 1e-12));
  return extent.sizes();
}

TEST(ExtentOf, EachShape) {
  const Quat lying(Eigen::AngleAxisd(90 * kRadPerDegree, Vec3::UnitX()));  // its z along -y
  const Quat half(Eigen::AngleAxisd(45 * kRadPerDegree, Vec3::UnitX()));
  EXPECT_TRUE(sizes_of(body(Shape::sphere, {0.5}), half).isApprox(Vec3(1, 1, 1), 1e-12));
  EXPECT_TRUE(sizes_of(body(Shape::box, {1, 2, 3}), lying).isApprox(Vec3(1, 3, 2), 1e-12));
  EXPECT_TRUE(sizes_of(body(Shape::capsule, {0.1, 2}), lying).isApprox(Vec3(0.2, 2.2, 0.2), 1e-12));
  EXPECT_TRUE(sizes_of(body(Shape::cylinder, {0.1, 2}), lying).isApprox(Vec3(0.2, 2, 0.2), 1e-12));
  const double tilted = (2 + 0.2) * std::sqrt(0.5);
  EXPECT_TRUE(
      sizes_of(body(Shape::cylinder, {0.1, 2}), half).isApprox(Vec3(0.2, tilted, tilted), 1e-12));
  SceneObject mesh = body(Shape::mesh, {});
  mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 3)};
  EXPECT_TRUE(sizes_of(mesh, lying).isApprox(Vec3(1, 3, 2), 1e-12));
}

TEST(ExtentOf, WithoutASizeItIsAPoint) {
  // Nothing is read beyond the numbers that are there.
  for (const Shape shape :
       {Shape::sphere, Shape::box, Shape::cylinder, Shape::capsule, Shape::mesh}) {
    EXPECT_TRUE(sizes_of(body(shape, {}), Quat::Identity()).isZero()) << name_of(shape);
    EXPECT_EQ(bounding_box(body(shape, {}), make_pose(Vec3(1, 2, 3), Quat::Identity())).min(),
              Vec3(1, 2, 3));
  }
  EXPECT_TRUE(sizes_of(body(Shape::box, {1, 2}), Quat::Identity()).isZero());
}

}  // namespace
}  // namespace morphe
