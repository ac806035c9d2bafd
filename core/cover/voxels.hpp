#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::cover {

/// A voxel grid around a surface, with the interior (voxels unreachable from the grid's boundary)
/// and the distance of each voxel from the surface. Holes narrower than a voxel are closed; of an
/// open shell only the shell is inside. The orientation of triangles does not matter.
struct Voxels {
  Vec3 origin = Vec3::Zero();  ///< corner of the grid
  double step_m = 0;
  Eigen::Vector3i count = Eigen::Vector3i::Zero();
  std::vector<std::uint8_t> inside;  ///< 1 inside or on the surface
  std::vector<float> distance;       ///< from the nearest voxel on the surface [m]

  /// Returns the index of a voxel.
  std::ptrdiff_t index(int x, int y, int z) const { return (z * count.y() + y) * count.x() + x; }
  /// Returns the centre of a voxel.
  Vec3 centre(int x, int y, int z) const {
    return origin + step_m * (Vec3(x, y, z) + Vec3::Constant(0.5));
  }
  /// Returns the distance from the surface of the voxel that contains a point, 0 if it is inside.
  /// For points outside the grid it is that of the nearest voxel plus the distance from the grid.
  double outside_distance(const Vec3& point) const;
};

/// Computes the voxels, `cells` along the longest side, from points, about one per surface voxel.
Voxels voxels_of(const std::vector<Vec3>& surface, int cells);

}  // namespace morphe::cover
