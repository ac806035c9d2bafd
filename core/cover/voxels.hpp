#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::cover {

/// A box of cubes about a surface: which lie inside (whatever no way leads to from the box's edge),
/// and how far each is from the surface. Holes narrower than a cube are closed; a shell that stands
/// open has no inside but itself. Winding does not matter.
struct Voxels {
  Vec3 origin = Vec3::Zero();  ///< corner of the box
  double step_m = 0;
  Eigen::Vector3i count = Eigen::Vector3i::Zero();
  std::vector<std::uint8_t> inside;  ///< or on the surface
  std::vector<float> distance;       ///< to the nearest cube on the surface [m]

  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>((z * count.y() + y) * count.x() + x);
  }
  Vec3 centre(int x, int y, int z) const {
    return origin + step_m * (Vec3(x, y, z) + Vec3::Constant(0.5));
  }
  /// Distance of the cube that holds a point (that of the nearest cube, and the way there, outside
  /// the box), 0 where that is inside.
  double outside_by(const Vec3& point) const;
};

/// With the longest side cut into `along` cubes. The points must be dense: about one a cube.
Voxels voxels_of(const std::vector<Vec3>& surface, int along);

}  // namespace morphe::cover
