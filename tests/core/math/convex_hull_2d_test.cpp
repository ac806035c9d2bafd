#include "core/math/convex_hull_2d.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace morphe::math {
namespace {

TEST(ConvexPolygon, AroundAHexagonAndItsMiddle) {
  std::vector<Eigen::Vector2d> points = {{0, 0}};
  for (int k = 0; k < 6; ++k)
    points.emplace_back(std::cos(k * M_PI / 3 + 0.1), std::sin(k * M_PI / 3 + 0.1));
  const std::vector<Eigen::Vector2d> hull = convex_hull_2d(points);
  ASSERT_EQ(hull.size(), 6u);
  double area = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    const Eigen::Vector2d &a = hull[k], &b = hull[(k + 1) % 6];
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  EXPECT_NEAR(area, 1.5 * std::sqrt(3), 1e-12);
}

}  // namespace
}  // namespace morphe::math
