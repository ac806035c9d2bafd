#include "core/math/rigid.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>
#include <random>

namespace morphe::math {
namespace {

const std::vector<Vec3> kStill = {
    {0.20, 0.10, 0.30}, {0.26, 0.12, 0.31}, {0.21, 0.17, 0.29}, {0.24, 0.15, 0.36}};

Pose random_pose(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Quat turn(normal(random), normal(random), normal(random), normal(random));
  return make_pose(Vec3(normal(random), normal(random), normal(random)), turn.normalized());
}

std::vector<Vec3> moved(const Pose& pose, const std::vector<Vec3>& points) {
  std::vector<Vec3> result;
  for (const Vec3& point : points) result.push_back(pose * point);
  return result;
}

TEST(FitRigid, FindsExactMotionsAlsoWithOneMarkerMissing) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Pose truth = random_pose(random);
    std::vector<Vec3> now = moved(truth, kStill);
    if (trial % 5 < 4) now[static_cast<std::size_t>(trial % 5)] = unknown_point();
    const Pose found = fit_rigid_transform(kStill, now);
    EXPECT_TRUE(found.matrix().isApprox(truth.matrix(), 1e-12));
    EXPECT_NEAR(found.linear().determinant(), 1, 1e-12);
    EXPECT_LT(rigid_residual(found, kStill, now), 1e-13);
  }
}

TEST(FitRigid, IsNotAReflectionOfNearlyFlatClusters) {
  std::vector<Vec3> still = kStill, now = kStill;
  for (std::size_t k = 0; k < 4; ++k) {
    still[k].z() = k == 3 ? 0.001 : 0;
    now[k] = still[k];
    now[k].z() = -still[k].z();  // noise through the plane
  }
  const Pose found = fit_rigid_transform(still, now);
  EXPECT_NEAR(found.linear().determinant(), 1, 1e-12);
  EXPECT_LT(Eigen::AngleAxisd(found.linear()).angle(), 0.1);
}

TEST(FitRigid, RefusesTwoMarkersAndCollinearOnes) {
  std::vector<Vec3> now = kStill;
  now[0] = now[2] = unknown_point();
  EXPECT_FALSE(fit_rigid_transform(kStill, now).matrix().allFinite());
  const std::vector<Vec3> line = {{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}};
  EXPECT_FALSE(fit_rigid_transform(line, line).matrix().allFinite());
}

/// Thin clouds of points of all sizes, 0.3 to 30 mm wide: those whose second singular value is
/// below 2 mm are refused, and no others.
TEST(FitRigid, RefusesExactlyTheCloudsWithASmallSecondSingularValue) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> exponent(-3.5, -1.5), longer(0, 4);
  int refused = 0;
  constexpr int kTrials = 2000;
  for (int trial = 0; trial < kTrials; ++trial) {
    const double width_m = std::pow(10, exponent(random));
    const double length_m = width_m * std::pow(10, longer(random));
    std::vector<Vec3> cloud;
    for (int k = 0; k < 3 + trial % 3; ++k) {
      cloud.emplace_back(length_m * normal(random), width_m * normal(random),
                         width_m * normal(random));
    }
    cloud = moved(random_pose(random), cloud);
    Eigen::Matrix3Xd centred(3, cloud.size());
    for (std::size_t k = 0; k < cloud.size(); ++k) centred.col(k) = cloud[k];
    centred.colwise() -= Vec3(centred.rowwise().mean());
    const bool thin = Eigen::JacobiSVD<Eigen::Matrix3Xd>(centred).singularValues()[1] < 0.002;
    EXPECT_EQ(fit_rigid_transform(cloud, cloud).matrix().allFinite(), !thin) << trial;
    refused += thin ? 1 : 0;
  }
  EXPECT_GT(refused, kTrials / 10);
  EXPECT_LT(refused, kTrials - kTrials / 10);
}

}  // namespace
}  // namespace morphe::math
