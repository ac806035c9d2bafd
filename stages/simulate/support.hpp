#pragma once

#include <optional>
#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::simulate {

/// An object of the scene on which the target stands, as a body of the model.
struct Support {
  int object = -1;
  double raise_m = 0;  ///< along the vertical, so that it touches the target at its planned pose
};

/// Returns the object among `candidates` on which the target stands at a pose: the one that is
/// nearest below it, at most collision::kSupportNoise_m away or overlapping as much.
std::optional<Support> find_support(const Scene& scene, int target,
                                    const std::vector<int>& candidates,
                                    const Pose& base_from_target, const Vec3& up);

/// Radius of a foot: a sphere in the target that touches its support in one point. It protrudes
/// from the target's side by this radius.
inline constexpr double kFootRadius_m = 0.0005;

/// Returns the centres of feet on which the target can stand, in its frame: at the points that are
/// lowest if it is turned slightly in each of kFootDirections directions from an orientation in
/// which `up` (unit, in its frame) is vertical. MuJoCo 2.2.2 finds only one contact of a cylinder
/// or mesh with a box, on which they could not stand. Empty for other shapes.
std::vector<Vec3> foot_points(const SceneObject& target, const Vec3& up);

}  // namespace morphe::simulate
