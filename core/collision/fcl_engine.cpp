// This is the only source that includes FCL.
#include "core/collision/fcl_engine.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <cmath>

#include "core/collision/mesh_solid.hpp"
#include "core/math/rotation.hpp"

namespace morphe::collision {
namespace {

/// Smallest radius of a capsule, because FCL requires positive radii. If a capsule may penetrate
/// deeper than its radius, it keeps this radius and the solid shrinks by the rest.
constexpr double kLeastRadius_m = 1e-6;

using Geometry = std::shared_ptr<fcl::CollisionGeometry<double>>;

/// Returns the object shrunk by `shrunk_m` on all sides, or null if it is too thin for that, or a
/// mesh.
Geometry shape_of(const SceneObject& object, double shrunk_m) {
  const std::vector<double>& size = object.size;
  const auto less = [shrunk_m](double value, double sides) { return value - sides * shrunk_m; };
  switch (object.shape) {
    case Shape::sphere:
      if (less(size[0], 1) <= 0) return nullptr;
      return std::make_shared<fcl::Sphere<double>>(less(size[0], 1));
    case Shape::box:
      if (less(*std::ranges::min_element(size), 2) <= 0) return nullptr;
      return std::make_shared<fcl::Box<double>>(less(size[0], 2), less(size[1], 2),
                                                less(size[2], 2));
    case Shape::cylinder:
      if (less(size[0], 1) <= 0 || less(size[1], 2) <= 0) return nullptr;
      return std::make_shared<fcl::Cylinder<double>>(less(size[0], 1), less(size[1], 2));
    case Shape::capsule:
      if (less(size[0], 1) <= 0) return nullptr;
      return std::make_shared<fcl::Capsule<double>>(less(size[0], 1), size[1]);
    case Shape::mesh:
      break;
  }
  return nullptr;
}

Geometry mesh_of(const MeshSolid& mesh) {
  const auto model = std::make_shared<fcl::BVHModel<fcl::OBB<double>>>();
  model->beginModel();
  for (const MeshSolid::Triangle& t : mesh.triangles) model->addTriangle(t.a, t.b, t.c);
  model->endModel();
  return model;
}

Geometry capsule_of(const RobotModel::Capsule& capsule, double grown_m) {
  return std::make_shared<fcl::Capsule<double>>(std::max(capsule.radius + grown_m, kLeastRadius_m),
                                                (capsule.to - capsule.from).norm());
}

/// Returns the pose of a capsule, with z along its segment.
Pose pose_of(const CapsuleBody& body) {
  Pose pose = Pose::Identity();
  pose.translation() = 0.5 * (body.from + body.to);
  if (body.from != body.to) {
    pose.linear() = math::shortest_rotation(Vec3::UnitZ(), body.to - body.from).toRotationMatrix();
  }
  return pose;
}

bool touch(const fcl::CollisionGeometry<double>& a, const Pose& base_from_a,
           const fcl::CollisionGeometry<double>& b, const Pose& base_from_b) {
  const fcl::CollisionRequest<double> request;
  fcl::CollisionResult<double> result;
  return fcl::collide(&a, base_from_a, &b, base_from_b, request, result) > 0;
}

}  // namespace

struct FclEngine::Trees {
  using Object = fcl::CollisionObject<double>;
  struct CollidingPair {
    int capsule, other;
    bool object;
    double required;
  };

  const CollisionWorld& world;
  /// [capsules] original, and enlarged by the margin.
  std::vector<Geometry> capsule_shapes, padded_capsule_shapes;
  std::vector<Geometry> shapes;  ///< [objects] nullptr if the mesh is invalid
  std::vector<char> checked;     ///< [capsules * capsules] pairs of world.pairs
  std::vector<std::unique_ptr<Object>> capsule_objects, scene_objects;
  fcl::DynamicAABBTreeCollisionManager<double> capsule_tree, scene_tree;
  std::vector<Pose> poses;
  // State of the current query.
  const CollisionScratch* scratch = nullptr;
  double time_s = 0;
  bool first_only = false;
  std::vector<CollidingPair> found;

  explicit Trees(const CollisionWorld& w) : world(w) {
    const std::size_t count = world.robot->capsules.size();
    poses.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      capsule_shapes.push_back(capsule_of(world.robot->capsules[i], 0));
      padded_capsule_shapes.push_back(
          capsule_of(world.robot->capsules[i], world.tolerances.required_clearance));
      capsule_objects.push_back(std::make_unique<Object>(padded_capsule_shapes.back()));
      capsule_objects.back()->setUserData(reinterpret_cast<void*>(i));
      capsule_tree.registerObject(capsule_objects.back().get());
    }
    checked.assign(count * count, 0);
    for (const auto& [i, j] : world.pairs) {
      checked[i * count + j] = 1;
      checked[j * count + i] = 1;
    }
    for (std::size_t k = 0; k < world.scene->objects.size(); ++k) {
      const Solid solid = solid_at(world, k);
      shapes.push_back(solid.mesh ? mesh_of(*solid.mesh) : shape_of(solid.object, 0));
      if (!shapes.back()) continue;
      scene_objects.push_back(std::make_unique<Object>(shapes.back()));
      scene_objects.back()->setUserData(reinterpret_cast<void*>(k));
      scene_tree.registerObject(scene_objects.back().get());
    }
  }

  static std::size_t number(const Object* object) {
    return reinterpret_cast<std::size_t>(object->getUserData());
  }

  bool is_capsule(const Object* object) const {
    const std::size_t i = number(object);
    return i < capsule_objects.size() && object == capsule_objects[i].get();
  }

  static void move(Object& object, const Pose& pose) {
    object.setTransform(pose);
    object.computeAABB();
  }

  bool bodies_touch(std::size_t i, std::size_t j) const {
    return touch(*padded_capsule_shapes[i], poses[i], *capsule_shapes[j], poses[j]);
  }

  bool object_touches(std::size_t i, std::size_t k, double required_m) const {
    const Solid solid = solid_at(world, k);
    const RobotModel::Capsule& capsule = world.robot->capsules[i];
    const Pose& pose = scratch->object_poses[k];
    const double shrunk_m = std::max(0.0, kLeastRadius_m - capsule.radius - required_m);
    if (!shapes[k]) return true;
    if (solid.mesh) {
      if (shrunk_m > 0) {
        return capsule_solid(scratch->bodies[i], solid, pose).distance < required_m;
      }
      const Geometry as_required = capsule_of(capsule, required_m);
      return touch(*as_required, poses[i], *shapes[k], pose) ||
             is_inside(*solid.mesh, pose.inverse() * poses[i].translation());
    }
    if (required_m == world.tolerances.required_clearance)
      return touch(*padded_capsule_shapes[i], poses[i], *shapes[k], pose);
    const Geometry shape = shape_of(solid.object, shrunk_m);
    return shape && touch(*capsule_of(capsule, required_m), poses[i], *shape, pose);
  }

  void keep(std::size_t one, std::size_t other, bool object, double required_m) {
    found.push_back({static_cast<int>(one), static_cast<int>(other), object, required_m});
  }

  static bool visit_bodies(Object* a, Object* b, void* data) {
    Trees& trees = *static_cast<Trees*>(data);
    const std::size_t i = std::min(number(a), number(b)), j = std::max(number(a), number(b));
    if (!trees.checked[i * trees.capsule_shapes.size() + j] || !trees.bodies_touch(i, j))
      return false;
    trees.keep(i, j, false, trees.world.tolerances.required_clearance);
    return trees.first_only;
  }

  static bool visit_objects(Object* a, Object* b, void* data) {
    Trees& trees = *static_cast<Trees*>(data);
    const bool capsule_first = trees.is_capsule(a);
    const std::size_t i = number(capsule_first ? a : b), k = number(capsule_first ? b : a);
    const double required =
        required_distance_m(trees.world, static_cast<int>(i), static_cast<int>(k), trees.time_s);
    if (!trees.object_touches(i, k, required)) return false;
    trees.keep(i, k, true, required);
    return trees.first_only;
  }

  void query(const Eigen::Ref<const JointVector>& q, double at_s, bool first,
             CollisionScratch& used) {
    update_bodies(world, q, at_s, used);
    scratch = &used;
    time_s = at_s;
    first_only = first;
    found.clear();
    for (std::size_t i = 0; i < poses.size(); ++i) {
      poses[i] = pose_of(used.bodies[i]);
      move(*capsule_objects[i], poses[i]);
    }
    for (const auto& object : scene_objects) move(*object, used.object_poses[number(object.get())]);
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      if (shapes[k]) continue;
      for (std::size_t i = 0; i < poses.size(); ++i) keep(i, k, true, 0);
    }
    if (poses.empty()) return;
    capsule_tree.update();
    capsule_tree.collide(this, visit_bodies);
    if (scene_objects.empty() || (first && !found.empty())) return;
    scene_tree.update();
    capsule_tree.collide(&scene_tree, this, visit_objects);
  }
};

FclEngine::FclEngine(const CollisionWorld& world) : trees_(std::make_unique<Trees>(world)) {}
FclEngine::~FclEngine() = default;

bool FclEngine::is_free(const Eigen::Ref<const JointVector>& q, double time_s,
                        CollisionScratch& scratch) {
  trees_->query(q, time_s, true, scratch);
  return trees_->found.empty();
}

void FclEngine::colliding_pairs(const Eigen::Ref<const JointVector>& q, double time_s,
                                CollisionScratch& scratch, std::vector<PairSeparation>& out) {
  trees_->query(q, time_s, false, scratch);
  std::ranges::sort(trees_->found, {}, [](const Trees::CollidingPair& f) {
    return std::tuple(f.object, f.capsule, f.other);
  });
  out.clear();
  for (const Trees::CollidingPair& found : trees_->found) {
    const CapsuleBody& first = scratch.bodies[found.capsule];
    const auto other = static_cast<std::size_t>(found.other);
    const Separation separation =
        found.object
            ? capsule_solid(first, solid_at(trees_->world, other), scratch.object_poses[other])
            : capsule_capsule(first, scratch.bodies[other]);
    out.push_back({found.capsule, found.other, found.object, separation, found.required});
  }
}

}  // namespace morphe::collision
