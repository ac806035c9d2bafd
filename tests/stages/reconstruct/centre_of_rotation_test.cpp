#include "stages/reconstruct/centre_of_rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace morphe::reconstruct {
namespace {

const Vec3 kInA(0.02, -0.15, 0.03), kInB(-0.01, 0.12, 0.04);

struct Pair {
  std::vector<Pose> a, b;
};

/// Body b turns in a about kInA / kInB, by `second` of its turns also about a second axis; both
/// move in the world. Positions carry noise of `noise_m`.
Pair joint(double second, double noise_m) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Pair pair;
  for (int i = 0; i < 400; ++i) {
    const double t = 0.01 * i;
    const Quat of_a(Eigen::AngleAxisd(0.5 * std::sin(2 * t), Vec3(1, 2, -1).normalized()));
    const Quat turn = Quat(Eigen::AngleAxisd(0.6 + 0.5 * std::sin(3 * t), Vec3::UnitX())) *
                      Quat(Eigen::AngleAxisd(second * std::sin(5 * t), Vec3::UnitY()));
    const Pose a = make_pose(Vec3(0.3 * std::sin(t), 0.1, 0.2 * t), of_a);
    const Quat of_b = of_a * turn;
    const Vec3 noise(normal(random), normal(random), normal(random));
    pair.a.push_back(a);
    pair.b.push_back(make_pose(a * kInA - of_b * kInB + noise_m * noise, of_b));
  }
  return pair;
}

TEST(FindPivot, FindsTheSharedPointHoweverFarThePrior) {
  const Pair pair = joint(0.5, 0.0003);
  const CentreOfRotation pivot =
      estimate_centre_of_rotation(pair.a, pair.b, {Vec3(0.1, 0, 0), Vec3(0, 0, -0.1), 0.15});
  EXPECT_LT((pivot.in_a - kInA).norm(), 0.0005);
  EXPECT_LT((pivot.in_b - kInB).norm(), 0.0005);
  EXPECT_NEAR(pivot.residual_m, 0.0003 * std::sqrt(3), 0.00003);
  EXPECT_LT(pivot.uncertainty_m, 0.005);
}

TEST(FindPivot, AlongAHingeItStaysAtThePriorAndSaysSo) {
  const Pair pair = joint(0, 0.0003);
  const Vec3 aside(0.025, 0, 0);  // along the hinge
  const Vec3 off(0, 0.02, -0.03);
  const CentreOfRotation pivot =
      estimate_centre_of_rotation(pair.a, pair.b, {kInA + aside + off, kInB + aside - off, 0.03});
  EXPECT_LT((pivot.in_a - kInA - aside).norm(), 0.001);
  EXPECT_LT((pivot.in_b - kInB - aside).norm(), 0.001);
  EXPECT_NEAR(pivot.uncertainty_m, 0.03, 0.001);
}

TEST(FindPivot, UsesTheFramesThatShowBothBodies) {
  Pair pair = joint(0.5, 0);
  for (std::size_t i = 0; i < 100; ++i) pair.a[i].matrix().setConstant(kUnknown);
  for (std::size_t i = 150; i < 250; ++i) pair.b[i].matrix().setConstant(kUnknown);
  const CentreOfRotation pivot =
      estimate_centre_of_rotation(pair.a, pair.b, {Vec3::Zero(), Vec3::Zero(), 0.15});
  EXPECT_LT((pivot.in_a - kInA).norm(), 1e-5);
  for (Pose& pose : pair.b) pose.matrix().setConstant(kUnknown);
  EXPECT_FALSE(is_known(
      estimate_centre_of_rotation(pair.a, pair.b, {Vec3::Zero(), Vec3::Zero(), 0.15}).in_a));
}

}  // namespace
}  // namespace morphe::reconstruct
