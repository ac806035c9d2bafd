#pragma once

#include <memory>
#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::collision {

/// A body made of triangles, as a link's meshes or primitives are, for queries against other such
/// bodies: do the shapes themselves overlap, not what is laid around them. Its triangles are kept
/// in a tree of FCL, whose queries between triangles are exact, and as a MeshSolid, which knows the
/// inside of its closed parts.
class MeshBody {
 public:
  /// Prepares a valid mesh, whose vertices within a micrometre are merged and whose holes narrower
  /// than 10 mm are filled.
  explicit MeshBody(SceneObject mesh);
  ~MeshBody();
  MeshBody(MeshBody&&) noexcept;
  MeshBody& operator=(MeshBody&&) noexcept;

  /// Returns true if the body touches another, `this_from_other`, or if one lies in the other.
  bool overlaps(const MeshBody& other, const Pose& this_from_other) const;
  /// Returns the distance from another body [m], 0 if they overlap.
  double distance(const MeshBody& other, const Pose& this_from_other) const;
  /// Returns the depth of a point in the body [m], < 0 outside.
  double depth(const Vec3& point) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace morphe::collision
