#include "core/math/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace morphe::math {
namespace {

TEST(ShortestRotation, TurnsOneDirectionIntoTheOtherAboutTheirNormal) {
  for (const double angle : {1e-6, 0.3, 1.5, 3.0}) {
    const Vec3 a(0, 0, 2), b = 5 * Vec3(std::sin(angle), 0, std::cos(angle));
    const Quat rotation = shortest_rotation(a, b);
    // About y, by the half angle.
    EXPECT_NEAR(rotation.w(), std::cos(angle / 2), 1e-12);
    EXPECT_NEAR(rotation.y(), std::sin(angle / 2), 1e-12);
    EXPECT_NEAR((rotation * a - b * 0.4).norm(), 0, 1e-12);
  }
}

TEST(ShortestRotation, TurnsAVectorAgainstItselfByHalfATurn) {
  const Quat rotation = shortest_rotation(Vec3(1, 2, 3), Vec3(-1, -2, -3));
  EXPECT_NEAR(angle_between(rotation, Quat::Identity()), std::numbers::pi, 1e-7);
  EXPECT_NEAR((rotation * Vec3(1, 2, 3) + Vec3(1, 2, 3)).norm(), 0, 1e-7);
}

TEST(PrincipalAxes, AreThoseOfATurnedBox) {
  const Eigen::Matrix3d turn =
      Quat(Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized())).toRotationMatrix();
  const Eigen::Matrix3d spread = turn * Vec3(9, 1, 4).asDiagonal() * turn.transpose();
  const PrincipalAxes found = principal_axes(spread);
  EXPECT_NEAR((found.moments - Vec3(1, 4, 9)).norm(), 0, 1e-12);
  const int column_of[] = {1, 2, 0};
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(std::abs(found.axes.col(k).dot(turn.col(column_of[k]))), 1, 1e-12);
}

}  // namespace
}  // namespace morphe::math
