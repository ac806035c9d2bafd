#include "stages/simulate/support.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/collision/constants.hpp"
#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/math/rotation.hpp"

namespace morphe::simulate {
namespace {

/// Of a cup with 16 feet the tipping edge is up to 2 % nearer to the middle than its rim.
constexpr int kFootDirections = 16;
/// Horizontal share of a direction to a foot: small, so that vertices of the lowest face win.
constexpr double kFootSlope = 0.05;
constexpr double kSameFoot_m = 1e-6;

/// Returns the point of a cylinder or mesh that lies farthest in a direction.
Vec3 farthest_point(const SceneObject& object, const Vec3& direction) {
  if (object.shape == Shape::cylinder) {
    const Vec3 radial(direction.x(), direction.y(), 0);
    return object.size[0] * radial.normalized() +
           0.5 * std::copysign(object.size[1], direction.z()) * Vec3::UnitZ();
  }
  return *std::ranges::max_element(object.vertices, {},
                                   [&](const Vec3& vertex) { return direction.dot(vertex); });
}

}  // namespace

std::optional<Support> find_support(const Scene& scene, int target,
                                    const std::vector<int>& candidates,
                                    const Pose& base_from_target, const Vec3& up) {
  const auto target_mesh = collision::mesh_solid_of(scene.objects[target]);
  const collision::Solid solid(scene.objects[target], target_mesh.get());
  std::optional<Support> support;
  double nearest_m = kInfinity;
  for (const int k : candidates) {
    const SceneObject& object = scene.objects[k];
    const Pose pose = recorded_pose(object, object.time.front());
    const auto distance = [&](double raise_m) {
      Pose raised = base_from_target;
      raised.translation() += raise_m * up;
      return collision::solid_solid(solid, raised, {object}, pose).distance;
    };
    // Distances of bodies that are apart are exact, depths of overlaps are not.
    constexpr double kRaise_m = 2 * collision::kSupportNoise_m;
    const double gap_m = distance(kRaise_m) - kRaise_m;
    const bool is_below = distance(2 * kRaise_m) - distance(kRaise_m) > 0.5 * kRaise_m;
    if (!is_below || std::abs(gap_m) > collision::kSupportNoise_m || std::abs(gap_m) >= nearest_m)
      continue;
    nearest_m = std::abs(gap_m);
    support = Support{k, gap_m};
  }
  return support;
}

std::vector<Vec3> foot_points(const SceneObject& target, const Vec3& up) {
  std::vector<Vec3> feet;
  if (target.shape != Shape::cylinder && target.shape != Shape::mesh) return feet;
  const Quat frame = math::shortest_rotation(Vec3::UnitZ(), up);
  for (int k = 0; k < kFootDirections; ++k) {
    const double angle = 2 * std::numbers::pi * k / kFootDirections;
    const Vec3 outward = frame * Vec3(std::cos(angle), std::sin(angle), 0);
    const Vec3 foot = farthest_point(target, kFootSlope * outward - up) + kFootRadius_m * up;
    if (std::ranges::none_of(
            feet, [&](const Vec3& other) { return (other - foot).norm() < kSameFoot_m; }))
      feet.push_back(foot);
  }
  return feet;
}

}  // namespace morphe::simulate
