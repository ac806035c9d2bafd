#pragma once

#include <cmath>
#include <cstdint>

#include "core/collision/distance.hpp"

namespace morphe::collision {

/// Bodies for the tests, the same ones on every machine.
class RandomBodies {
 public:
  explicit RandomBodies(std::uint64_t seed) : state_(seed * 2 + 1) {}

  double uniform(double low, double high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  int below(int count) { return static_cast<int>(uniform(0, count)); }
  Vec3 point(double reach) {
    const double x = uniform(-reach, reach), y = uniform(-reach, reach);
    return {x, y, uniform(-reach, reach)};
  }
  Vec3 direction() {
    Vec3 v = point(1);
    while (v.norm() > 1 || v.norm() < 1e-3) v = point(1);
    return v.normalized();
  }
  Pose pose(double reach) {
    const Vec3 at = point(reach);
    const double angle = uniform(-3, 3);
    return make_pose(at, Quat(Eigen::AngleAxisd(angle, direction())));
  }
  CapsuleBody capsule(double reach) {
    const Vec3 from = point(reach);
    const double length = uniform(0.02, 0.5);
    const Vec3 to = from + length * direction();
    return {from, to, uniform(0.005, 0.1)};
  }
  SceneObject solid(Shape shape) {
    SceneObject object;
    object.name = name_of(shape);
    object.shape = shape;
    object.time = {0};
    object.position = {Vec3::Zero()};
    object.orientation = {Quat::Identity()};
    const int sizes = shape == Shape::sphere ? 1 : shape == Shape::box ? 3 : 2;
    for (int k = 0; k < sizes; ++k) object.size.push_back(uniform(0.02, 0.4));
    return object;
  }

 private:
  std::uint64_t state_;
};

inline constexpr Shape kSolids[] = {Shape::sphere, Shape::box, Shape::cylinder, Shape::capsule};

}  // namespace morphe::collision
