// The only include of FCL. Shapes live on the stack of one query: nothing is shared by threads.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/geometry/shape/utility.h>
#include <fcl/math/bv/AABB.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "pipeline/collision/world.hpp"

namespace morphe {
namespace {

/// FCL needs radii above zero; a capsule that is to sink deeper than its radius keeps this much and
/// the solid shrinks by the rest.
constexpr double kLeastRadius_m = 1e-6;

using Box3 = fcl::AABB<double>;

template <class Geometry>
Box3 bounds(const Geometry& shape, const Pose& pose) {
  Box3 box;
  fcl::computeBV(shape, pose, box);
  return box;
}

bool touch(const fcl::CollisionGeometry<double>& a, const Pose& base_from_a,
           const fcl::CollisionGeometry<double>& b, const Pose& base_from_b) {
  const fcl::CollisionRequest<double> request;
  fcl::CollisionResult<double> result;
  return fcl::collide(&a, base_from_a, &b, base_from_b, request, result) > 0;
}

struct PlacedCapsule {
  fcl::Capsule<double> shape;
  Pose pose = Pose::Identity();  ///< z along the segment

  PlacedCapsule(const CapsuleBody& body, double grown_m)
      : shape(std::max(body.radius + grown_m, kLeastRadius_m), (body.to - body.from).norm()) {
    pose.translation() = 0.5 * (body.from + body.to);
    if (shape.lz > 0) {
      pose.linear() = Quat::FromTwoVectors(Vec3::UnitZ(), body.to - body.from).toRotationMatrix();
    }
  }
};

/// Calls visit(shape) with the object shrunk by `shrunk_m` on all sides; nothing is left of an
/// object that is too thin: false.
template <class Visit>
bool with_shape(const SceneObject& object, double shrunk_m, Visit visit) {
  const std::vector<double>& size = object.size;
  const auto less = [shrunk_m](double value, double sides) { return value - sides * shrunk_m; };
  switch (object.shape) {
    case Shape::sphere:
      return less(size[0], 1) > 0 && visit(fcl::Sphere<double>(less(size[0], 1)));
    case Shape::box:
      return less(*std::min_element(size.begin(), size.end()), 2) > 0 &&
             visit(fcl::Box<double>(less(size[0], 2), less(size[1], 2), less(size[2], 2)));
    case Shape::cylinder:
      return less(size[0], 1) > 0 && less(size[1], 2) > 0 &&
             visit(fcl::Cylinder<double>(less(size[0], 1), less(size[1], 2)));
    case Shape::capsule:
      return less(size[0], 1) > 0 && visit(fcl::Capsule<double>(less(size[0], 1), size[1]));
    case Shape::mesh:
      break;
  }
  assert(false && "the scene refuses meshes");
  return false;
}

/// The body grown by `required_m` against the object.
bool body_touches(const CapsuleBody& body, const SceneObject& object, const Pose& base_from_object,
                  double required_m) {
  const double shrunk_m = std::max(0.0, kLeastRadius_m - body.radius - required_m);
  const PlacedCapsule capsule(body, required_m);
  return with_shape(object, shrunk_m, [&](const auto& shape) {
    return bounds(capsule.shape, capsule.pose).overlap(bounds(shape, base_from_object)) &&
           touch(capsule.shape, capsule.pose, shape, base_from_object);
  });
}

/// Visits every pair that FCL finds in collision until `visit` says no.
template <class Visit>
bool visit_colliding(const CollisionWorld& world, double time_s, const CollisionScratch& scratch,
                     Visit visit) {
  const double margin_m = world.tolerances.margin;
  const auto body_at = [&scratch](int i) -> const CapsuleBody& {
    return scratch.bodies[static_cast<std::size_t>(i)];
  };
  for (const auto& [i, j] : world.pairs) {
    const PlacedCapsule first(body_at(i), margin_m), second(body_at(j), 0);
    if (!bounds(first.shape, first.pose).overlap(bounds(second.shape, second.pose))) continue;
    if (!touch(first.shape, first.pose, second.shape, second.pose)) continue;
    if (!visit(i, j, false, margin_m)) return false;
  }
  const int bodies = static_cast<int>(scratch.bodies.size());
  const int objects = static_cast<int>(world.scene->objects.size());
  for (int i = 0; i < bodies; ++i) {
    for (int k = 0; k < objects; ++k) {
      const double required = required_m(world, i, k, time_s);
      const SceneObject& object = world.scene->objects[static_cast<std::size_t>(k)];
      const Pose& pose = scratch.object_poses[static_cast<std::size_t>(k)];
      if (!body_touches(body_at(i), object, pose, required)) continue;
      if (!visit(i, k, true, required)) return false;
    }
  }
  return true;
}

}  // namespace

bool free_by_fcl(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch) {
  place_bodies(world, q, time_s, scratch);
  return visit_colliding(world, time_s, scratch, [](int, int, bool, double) { return false; });
}

void pairs_by_fcl(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                  double time_s, CollisionScratch& scratch, std::vector<PairSeparation>& out) {
  place_bodies(world, q, time_s, scratch);
  out.clear();
  visit_colliding(world, time_s, scratch,
                  [&](int capsule, int other, bool object, double required) {
                    PairSeparation& pair = out.emplace_back();
                    pair.capsule = capsule;
                    pair.other = other;
                    pair.object = object;
                    pair.required = required;
                    const CapsuleBody& first = scratch.bodies[static_cast<std::size_t>(capsule)];
                    const auto second = static_cast<std::size_t>(other);
                    pair.separation = object ? capsule_solid(first, world.scene->objects[second],
                                                             scratch.object_poses[second])
                                             : capsule_capsule(first, scratch.bodies[second]);
                    return true;
                  });
}

}  // namespace morphe
