#include "core/cover/point_cloud.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/math/random_stream.hpp"

namespace morphe::cover {
namespace {

Vec3 in_box(math::RandomStream& random, double half_m) {
  return half_m *
         Vec3(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
}

/// Counts in double precision; `unsure` are points so near the surface that single may differ.
struct Count {
  int inside = 0, unsure = 0;
};
Count count_one_by_one(const std::vector<Vec3>& points, const collision::CapsuleBody& capsule) {
  Count count;
  const Vec3 axis = capsule.to - capsule.from;
  for (const Vec3& point : points) {
    const double share =
        axis.squaredNorm() > 0
            ? std::clamp((point - capsule.from).dot(axis) / axis.squaredNorm(), 0.0, 1.0)
            : 0;
    const double gap_m = (point - capsule.from - share * axis).norm() - capsule.radius;
    count.inside += gap_m <= 0;
    count.unsure += std::abs(gap_m) < 1e-6;
  }
  return count;
}

TEST(PointCloud, CountsAndRemovesThePointsInCapsulesOfEverySize) {
  math::RandomStream random(1, "points");
  for (const int size : {0, 1, 31, 32, 33, 1000}) {
    std::vector<Vec3> points;
    for (int k = 0; k < size; ++k) points.push_back(in_box(random, 0.2));
    for (const double radius : {0.0, 0.003, 0.02, 0.1, 0.5}) {
      collision::CapsuleBody capsule{in_box(random, 0.2), in_box(random, 0.2), radius};
      for (const bool sphere : {false, true}) {
        if (sphere) capsule.to = capsule.from;
        PointCloud cloud(points);
        const int count = cloud.count_inside(capsule);
        const Count expected = count_one_by_one(points, capsule);
        EXPECT_NEAR(count, expected.inside, expected.unsure);
        if (radius > 0) {
          cloud.remove_inside(capsule);
          EXPECT_EQ(cloud.size(), size - count);
          EXPECT_EQ(cloud.count_inside(capsule), 0);
        }
      }
    }
  }
}

TEST(PointCloud, KeepsTheOrderOfThePointsThatAreLeft) {
  PointCloud cloud({{0, 0, 0}, {1, 0, 0}, {0, 0, 0.1}, {2, 0, 0}});
  cloud.remove_inside({Vec3::Zero(), Vec3(0, 0, 0.1), 0.01});
  ASSERT_EQ(cloud.size(), 2);
  EXPECT_EQ(cloud.point(0), Vec3(1, 0, 0));
  EXPECT_EQ(cloud.point(1), Vec3(2, 0, 0));
}

}  // namespace
}  // namespace morphe::cover
