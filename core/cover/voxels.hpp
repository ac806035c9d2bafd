#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/cover/surface.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::cover {

/// A voxel grid around a surface, with the interior (voxels unreachable from the grid's boundary)
/// and the distance of each voxel from the surface. Holes narrower than a voxel are closed; of an
/// open shell only the shell is inside. The orientation of triangles does not matter.
struct Voxels {
  Vec3 origin = Vec3::Zero();  ///< corner of the grid
  double step_m = 0;
  double padding_m = 0;  ///< by which the grid extends beyond the surface on each side
  Eigen::Vector3i count = Eigen::Vector3i::Zero();
  std::vector<std::uint8_t> inside;  ///< 1 inside or on the surface
  std::vector<float> distance;       ///< from the nearest voxel on the outer surface [m]

  /// Returns the index of a voxel.
  std::ptrdiff_t index(int x, int y, int z) const { return (z * count.y() + y) * count.x() + x; }
  /// Returns the centre of a voxel.
  Vec3 centre(int x, int y, int z) const {
    return origin + step_m * (Vec3(x, y, z) + Vec3::Constant(0.5));
  }
  /// Returns the index of the voxel that contains a point, -1 outside the grid.
  std::ptrdiff_t cell_of(const Vec3& point) const {
    const Vec3 p = (point - origin) / step_m;
    if (p.minCoeff() < 0 || (p - count.cast<double>()).maxCoeff() >= 0) return -1;
    return index(static_cast<int>(p.x()), static_cast<int>(p.y()), static_cast<int>(p.z()));
  }
  /// Returns the distance from the surface of the voxel that contains a point, 0 if it is inside.
  /// For points outside the grid it is that of the nearest voxel plus the distance from the grid.
  double outside_distance(const Vec3& point) const;
};

/// Computes the voxels of a surface, `cells` along the longest side, and beyond it at least
/// `padding_m` on each side. No path from voxel to neighbouring voxel leads through the surface.
Voxels voxels_of(const std::vector<Triangle>& surface, int cells, double padding_m = 0);

/// Marks the voxels outside the body that are not nearer to it than to another surface, by
/// `clearance_m`. If two bodies keep to the other voxels, they are so far apart.
std::vector<std::uint8_t> voxels_nearer_to(const std::vector<Triangle>& other, double clearance_m,
                                           const Voxels& voxels);

/// Returns the centres of the voxels inside or on the surface.
std::vector<Vec3> points_inside(const Voxels& voxels);

/// Returns the distance of every voxel from the nearest one of `cells`, by centres [m].
std::vector<float> distances_to(const Voxels& voxels, const std::vector<std::uint8_t>& cells);

}  // namespace morphe::cover
