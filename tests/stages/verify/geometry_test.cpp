#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "planar_plan.hpp"
#include "random_points.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/quintic.hpp"
#include "stages/verify/separation.hpp"

namespace morphe::verify {
namespace {

SceneObject solid(Shape shape, std::vector<double> size) {
  SceneObject object;
  object.shape = shape;
  object.size = std::move(size);
  return object;
}

/// Points that cover the surface, at most about 0.01 apart.
std::vector<Vec3> surface(const SceneObject& object) {
  std::vector<Vec3> points;
  constexpr int kSteps = 120;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const double u = 2.0 * i / kSteps - 1, v = 2.0 * j / kSteps - 1;
      const auto& size = object.size;
      if (object.shape == Shape::box) {
        for (const double w : {-1.0, 1.0})
          for (const Vec3& corner : {Vec3(u, v, w), Vec3(w, u, v), Vec3(v, w, u)})
            points.push_back(0.5 * corner.cwiseProduct(Vec3(size[0], size[1], size[2])));
        continue;
      }
      const double angle = M_PI * u, half = 0.5 * size[1];
      const Vec3 around(std::cos(angle), std::sin(angle), 0);
      points.push_back(size[0] * around + half * v * Vec3::UnitZ());
      for (const double w : {-half, half})
        points.push_back(size[0] * 0.5 * (v + 1) * around + w * Vec3::UnitZ());
    }
  }
  return points;
}

TEST(Separation, OfPointsAgreesWithTheNearestSurfacePoint) {
  Random random(7);
  for (const SceneObject& object :
       {solid(Shape::box, {0.2, 0.3, 0.4}), solid(Shape::cylinder, {0.15, 0.4})}) {
    const std::vector<Vec3> points = surface(object);
    for (int i = 0; i < 200; ++i) {
      const Vec3 point = random.point(0.3);
      double nearest = kInfinity;
      for (const Vec3& other : points) nearest = std::min(nearest, (point - other).norm());
      const bool inside =
          object.shape == Shape::box
              ? (point.cwiseAbs() - Vec3(0.1, 0.15, 0.2)).maxCoeff() < 0
              : std::hypot(point.x(), point.y()) < 0.15 && std::abs(point.z()) < 0.2;
      const double got = signed_distance(object, point);
      EXPECT_EQ(got < 0, inside);
      EXPECT_LE(std::abs(got), nearest + 1e-12);
      EXPECT_NEAR(std::abs(got), nearest, 0.003);
    }
  }
}

TEST(Separation, OfSegmentsAgreesWithBruteForce) {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    Segment a{random.point(0.3), random.point(0.3)}, b{random.point(0.3), random.point(0.3)};
    if (i % 10 == 0) b = {a.from + Vec3(0.1, 0, 0), a.to + Vec3(0.1, 0, 0)};  // parallel
    if (i % 10 == 1) a.to = a.from;                                           // a point
    double least = kInfinity;
    for (int k = 0; k <= 400; ++k) {
      const Vec3 on_a = a.from + k / 400.0 * (a.to - a.from);
      const double v =
          std::clamp((on_a - b.from).dot(b.to - b.from) / (b.to - b.from).squaredNorm(), 0.0, 1.0);
      least = std::min(least, (on_a - b.from - v * (b.to - b.from)).norm());
    }
    const double got = segment_distance(a, b);
    EXPECT_LE(got, least + 1e-12);
    EXPECT_NEAR(got, least, 2e-3);
    EXPECT_NEAR(got, segment_distance(b, a), 1e-12);
  }
}

TEST(Separation, OfSegmentAndSolidAgreesWithBruteForce) {
  Random random(7);
  for (const SceneObject& object :
       {solid(Shape::sphere, {0.1}), solid(Shape::box, {0.2, 0.3, 0.4}),
        solid(Shape::cylinder, {0.15, 0.4}), solid(Shape::capsule, {0.1, 0.3})}) {
    for (int i = 0; i < 200; ++i) {
      Segment segment{random.point(0.5), random.point(0.5)};
      if (i % 20 == 0) segment.to = segment.from;
      double least = kInfinity;
      for (int k = 0; k <= 4000; ++k)
        least = std::min(
            least,
            signed_distance(object, segment.from + k / 4000.0 * (segment.to - segment.from)));
      const double got = segment_solid_distance(object, segment, kInfinity);
      EXPECT_LE(got, least + 1e-9);
      EXPECT_NEAR(got, least, 2e-4);
      const double bound = segment_solid_distance(object, segment, 0.01);
      EXPECT_TRUE(bound == got || (bound >= 0.01 && bound <= got));
    }
  }
}

TEST(Quintic, MeetsBothEndsAndIsBoundedExactly) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const double h = random.in(0.002, 1);
    const JointState from{random.in(-1, 1), random.in(-1, 1), random.in(-5, 5)};
    const JointState to{random.in(-1, 1), random.in(-1, 1), random.in(-5, 5)};
    const Quintic quintic = quintic_between(h, from, to);
    EXPECT_NEAR(derivative(quintic, 0, 1), to.position, 1e-12);
    EXPECT_NEAR(derivative(quintic, 1, 1), to.velocity, 1e-10 / h);
    EXPECT_NEAR(derivative(quintic, 2, 1), to.acceleration, 1e-9 / (h * h));
    EXPECT_NEAR(derivative(quintic, 1, 0), from.velocity, 1e-14);
    EXPECT_NEAR(derivative(quintic, 2, 0), from.acceleration, 1e-14);
    const auto found = ranges(quintic);
    for (int order = 0; order < 4; ++order) {
      const Range& range = found[static_cast<std::size_t>(order)];
      double least = kInfinity, greatest = -kInfinity;
      for (int k = 0; k <= 2000; ++k) {
        const double value = derivative(quintic, order, k / 2000.0);
        least = std::min(least, value);
        greatest = std::max(greatest, value);
      }
      const double span = 1e-12 + (greatest - least);
      EXPECT_LE(range.least.value, least + 1e-12 * span);
      EXPECT_GE(range.greatest.value, greatest - 1e-12 * span);
      EXPECT_NEAR(range.least.value, least, 1e-5 * span);
      EXPECT_NEAR(range.greatest.value, greatest, 1e-5 * span);
    }
  }
}

TEST(FramePoses, AgreeWithPlaneTrigonometryAndItsLeverBoundsEveryMotion) {
  Random random(7);
  const RobotModel robot = planar::robot();
  std::vector<Pose> before, after;
  for (int i = 0; i < 200; ++i) {
    const JointVector q = random.point(1.5), moved = q + random.point(i % 2 ? 0.01 : 1.0);
    frame_poses(robot, q, before);
    frame_poses(robot, moved, after);
    EXPECT_LT((to_base_frame(before, 3, Vec3(0.06, 0, 0)) - planar::tip_at(q)).norm(), 1e-14);

    const JointVector way = (moved - q).cwiseAbs();
    const auto travel = [&](int capsule, const Pose& seen_before, const Pose& seen_after) {
      const auto& c = robot.capsules[static_cast<std::size_t>(capsule)];
      return (seen_before.inverse() * to_base_frame(before, c.frame, c.to) -
              seen_after.inverse() * to_base_frame(after, c.frame, c.to))
          .norm();
    };
    for (int capsule = 0; capsule < 4; ++capsule) {
      EXPECT_LE(travel(capsule, Pose::Identity(), Pose::Identity()),
                relative_motion_bound(robot, capsule, -1).dot(way) + 1e-12);
      for (int other = 0; other < capsule; ++other)
        EXPECT_LE(travel(capsule, before[static_cast<std::size_t>(other)],
                         after[static_cast<std::size_t>(other)]),
                  relative_motion_bound(robot, capsule, other).dot(way) + 1e-12);
    }
  }
  // The proximal joint moves the distal link twice: by itself and through the coupling.
  EXPECT_NEAR(relative_motion_bound(robot, 3, 1)(2), 0.06 + 0.06 + 0.08, 1e-12);
  EXPECT_EQ(relative_motion_bound(robot, 3, 1)(1), 0);
}

}  // namespace
}  // namespace morphe::verify
