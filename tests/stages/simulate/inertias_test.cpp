#include "stages/simulate/inertias.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/math/random_stream.hpp"
#include "tests/stages/simulate/gripper.hpp"

namespace morphe::simulate {
namespace {

/// Mass, centre and inertia of points that lie evenly in the capsules of one frame; what overlaps
/// counts twice.
Inertia sampled(const std::vector<RobotModel::Capsule>& capsules, double density) {
  math::RandomStream random(1, "capsules");
  Inertia sum;
  std::vector<std::pair<double, Vec3>> points;
  for (const RobotModel::Capsule& capsule : capsules) {
    Eigen::AlignedBox3d box(capsule.from);
    box.extend(capsule.to);
    box.min().array() -= capsule.radius;
    box.max().array() += capsule.radius;
    constexpr int kPoints = 200000;
    for (int k = 0; k < kPoints; ++k) {
      Vec3 p;
      for (int i = 0; i < 3; ++i) p[i] = random.uniform(box.min()[i], box.max()[i]);
      const Vec3 along = capsule.to - capsule.from;
      const double s = std::clamp(along.dot(p - capsule.from) / along.squaredNorm(), 0.0, 1.0);
      if ((p - capsule.from - s * along).norm() <= capsule.radius)
        points.emplace_back(density * box.volume() / kPoints, p);
    }
  }
  for (const auto& [mass, p] : points) {
    sum.mass += mass;
    sum.centre_of_mass += mass * p;
  }
  sum.centre_of_mass /= sum.mass;
  for (const auto& [mass, p] : points) {
    const Vec3 r = p - sum.centre_of_mass;
    sum.inertia_at_com +=
        mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return sum;
}

TEST(Bodies, ALinkWeighsWhatItsCapsulesHold) {
  RobotModel robot = gripper_table();
  robot.capsules = {{"a", 1, Vec3(0, 0, 0), Vec3(0.1, 0.05, 0.02), 0.03, false},
                    {"b", 1, Vec3(0.2, 0, 0), Vec3(0.2, 0.1, 0), 0.02, false}};
  const std::vector<Inertia> links = robot_inertias(robot, 1200);
  const Inertia expected = sampled(robot.capsules, 1200);
  EXPECT_NEAR(links[1].mass, expected.mass, 0.01 * expected.mass);
  EXPECT_LT((links[1].centre_of_mass - expected.centre_of_mass).norm(), 1e-3);
  EXPECT_LT((links[1].inertia_at_com - expected.inertia_at_com).norm(),
            0.02 * expected.inertia_at_com.norm());
  EXPECT_DOUBLE_EQ(links[2].mass, 0.001);  // no capsule
}

TEST(Bodies, ACapsuleWithoutLengthIsABall) {
  RobotModel robot = gripper_table();
  robot.capsules = {{"ball", 1, Vec3(0.1, 0, 0), Vec3(0.1, 0, 0), 0.05, false}};
  const Inertia ball = robot_inertias(robot, 1000)[1];
  const double mass = 1000 * 4.0 / 3 * std::numbers::pi * std::pow(0.05, 3);
  EXPECT_NEAR(ball.mass, mass, 1e-12);
  EXPECT_TRUE(
      ball.inertia_at_com.isApprox(0.4 * mass * 0.0025 * Eigen::Matrix3d::Identity(), 1e-12));
}

TEST(Bodies, ATargetIsSolid) {
  const auto inertia = [](Shape shape, std::vector<double> size) {
    return target_inertia(standing("x", shape, std::move(size), Vec3::Zero()), 2).inertia_at_com;
  };
  EXPECT_TRUE(inertia(Shape::sphere, {0.1}).isApprox(0.008 * Eigen::Matrix3d::Identity(), 1e-12));
  EXPECT_NEAR(inertia(Shape::box, {0.1, 0.2, 0.3})(0, 0), 2.0 / 12 * (0.04 + 0.09), 1e-12);
  EXPECT_NEAR(inertia(Shape::cylinder, {0.1, 0.4})(2, 2), 0.5 * 2 * 0.01, 1e-12);
  EXPECT_NEAR(inertia(Shape::cylinder, {0.1, 0.4})(0, 0), 2 * (0.16 / 12 + 0.01 / 4), 1e-12);
  EXPECT_NEAR(inertia(Shape::capsule, {0.1, 1e-9})(2, 2), 0.008, 1e-9);
}

TEST(Bodies, TheLowestPointOfATiltedBody) {
  const auto low = [](Shape shape, std::vector<double> size, double tilt_deg) {
    const SceneObject object = standing("x", shape, std::move(size), Vec3::Zero());
    const Pose pose =
        make_pose(Vec3(0, 0, 1), Quat(Eigen::AngleAxisd(tilt_deg * kRadPerDegree, Vec3::UnitX())));
    return 1 - lowest_height(object, pose, Vec3::UnitZ());
  };
  EXPECT_NEAR(low(Shape::cylinder, {0.03, 0.1}, 0), 0.05, 1e-12);
  EXPECT_NEAR(low(Shape::cylinder, {0.03, 0.1}, 90), 0.03, 1e-12);
  EXPECT_NEAR(low(Shape::capsule, {0.03, 0.1}, 90), 0.03, 1e-12);
  EXPECT_NEAR(low(Shape::box, {0.2, 0.2, 0.2}, 45), 0.1 * std::numbers::sqrt2, 1e-12);
  EXPECT_NEAR(low(Shape::sphere, {0.04}, 20), 0.04, 1e-12);
}

}  // namespace
}  // namespace morphe::simulate
