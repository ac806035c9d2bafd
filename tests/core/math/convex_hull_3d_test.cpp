#include "core/math/convex_hull_3d.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace morphe::math {
namespace {

TEST(ConvexHull3d, OfACubeAndItsMiddle) {
  std::vector<Vec3> points = {{0.5, 0.5, 0.5}};
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  const std::vector<HullTriangle> hull = convex_hull_3d(points);
  EXPECT_EQ(hull.size(), 12u);
  double volume = 0;
  for (const HullTriangle& triangle : hull) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) {
      const std::size_t corner = triangle.corners[static_cast<std::size_t>(k)];
      EXPECT_NE(corner, 0u);
      corners.col(k) = points[corner] - points[0];
    }
    volume += std::abs(corners.determinant()) / 6;
    EXPECT_NEAR(triangle.outwards.norm(), 1, 1e-12);
    EXPECT_NEAR(triangle.outwards.dot(corners.col(0)), 0.5, 1e-12);
  }
  EXPECT_NEAR(volume, 1, 1e-12);
}

TEST(ConvexHull3d, NoneOfFewOrFlatPoints) {
  EXPECT_TRUE(convex_hull_3d({}).empty());
  EXPECT_TRUE(convex_hull_3d({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
  EXPECT_TRUE(convex_hull_3d({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}).empty());
}

}  // namespace
}  // namespace morphe::math
