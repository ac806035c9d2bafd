#include "core/collision/mesh_body.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "core/collision/close_holes.hpp"
#include "core/collision/constants.hpp"
#include "core/collision/mesh_solid.hpp"

namespace morphe::collision {

struct MeshBody::Parts {
  MeshSolid solid;
  fcl::BVHModel<fcl::OBBRSS<double>> tree;
  std::vector<Vec3> corners;  ///< one of each part of the mesh: a part is inside or outside
};

MeshBody::MeshBody(SceneObject mesh) : parts_(std::make_unique<Parts>()) {
  weld(mesh);
  close_holes(mesh, kMaxHoleWidth_m);
  parts_->solid = make_mesh_solid(mesh);
  std::vector<char> known(parts_->solid.closed.size(), 0);
  parts_->tree.beginModel();
  for (const MeshSolid::Triangle& t : parts_->solid.triangles) {
    parts_->tree.addTriangle(t.a, t.b, t.c);
    if (!std::exchange(known[t.part], 1)) parts_->corners.push_back(t.a);
  }
  parts_->tree.endModel();
}
MeshBody::~MeshBody() = default;
MeshBody::MeshBody(MeshBody&&) noexcept = default;
MeshBody& MeshBody::operator=(MeshBody&&) noexcept = default;

bool MeshBody::overlaps(const MeshBody& other, const Pose& this_from_other) const {
  const fcl::CollisionRequest<double> request;
  fcl::CollisionResult<double> result;
  if (fcl::collide(&parts_->tree, Pose::Identity(), &other.parts_->tree, this_from_other, request,
                   result) > 0)
    return true;
  const Pose other_from_this = this_from_other.inverse();
  for (const Vec3& corner : other.parts_->corners)
    if (is_inside(parts_->solid, this_from_other * corner)) return true;
  for (const Vec3& corner : parts_->corners)
    if (is_inside(other.parts_->solid, other_from_this * corner)) return true;
  return false;
}

double MeshBody::distance(const MeshBody& other, const Pose& this_from_other) const {
  if (overlaps(other, this_from_other)) return 0;
  const fcl::DistanceRequest<double> request;
  fcl::DistanceResult<double> result;
  return std::max(0.0, fcl::distance(&parts_->tree, Pose::Identity(), &other.parts_->tree,
                                     this_from_other, request, result));
}

double MeshBody::depth(const Vec3& point) const {
  Vec3 gradient;
  return -mesh_distance(parts_->solid, point, gradient);
}

}  // namespace morphe::collision
