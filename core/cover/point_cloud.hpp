#pragma once

#include <cstddef>
#include <vector>

#include "core/collision/distance.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::cover {

/// Points in single precision of which one counts those in a capsule, for many capsules. A point p
/// is in it if its distance from the segment is at most the radius, computed in single precision.
class PointCloud {
 public:
  explicit PointCloud(const std::vector<Vec3>& points);

  std::ptrdiff_t size() const { return std::ssize(points_); }
  /// Returns a point, in the order in which they were given.
  Vec3 point(std::ptrdiff_t index) const { return points_[index].cast<double>(); }
  /// Returns the number of points in a capsule; none if its radius is not positive.
  int count_inside(const collision::CapsuleBody& capsule) const;
  /// Removes the points in a capsule; the others keep their order.
  void remove_inside(const collision::CapsuleBody& capsule);

 private:
  void arrange();

  std::vector<Eigen::Vector3f> points_;
  /// The points again, neighbours together: blocks of equal size, the last one filled up.
  std::vector<float> x_, y_, z_;
  struct Block {
    Eigen::Vector3f centre;
    float radius = 0;  ///< of a ball about the centre that holds the block's points
  };
  std::vector<Block> blocks_;
};

}  // namespace morphe::cover
