#include "core/collision/fcl_engine.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>

#include "core/collision/constants.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/math/rotation.hpp"

namespace morphe::collision {
namespace {

using Geometry = std::shared_ptr<fcl::CollisionGeometry<double>>;

/// Returns the object shrunk by shrink_m on all sides; null for a mesh, or if no part remains.
Geometry shape_of(const SceneObject& object, double shrink_m) {
  const std::vector<double>& size = object.size;
  const auto shrunk = [shrink_m](double value, double sides) { return value - sides * shrink_m; };
  switch (object.shape) {
    case Shape::sphere:
      if (shrunk(size[0], 1) <= 0) return nullptr;
      return std::make_shared<fcl::Sphere<double>>(shrunk(size[0], 1));
    case Shape::box:
      if (shrunk(*std::ranges::min_element(size), 2) <= 0) return nullptr;
      return std::make_shared<fcl::Box<double>>(shrunk(size[0], 2), shrunk(size[1], 2),
                                                shrunk(size[2], 2));
    case Shape::cylinder:
      if (shrunk(size[0], 1) <= 0 || shrunk(size[1], 2) <= 0) return nullptr;
      return std::make_shared<fcl::Cylinder<double>>(shrunk(size[0], 1), shrunk(size[1], 2));
    case Shape::capsule:
      if (shrunk(size[0], 1) <= 0) return nullptr;
      return std::make_shared<fcl::Capsule<double>>(shrunk(size[0], 1), size[1]);
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

Geometry capsule_of(const RobotModel::Capsule& capsule, double growth_m) {
  return std::make_shared<fcl::Capsule<double>>(
      std::max(capsule.radius + growth_m, kFclMinRadius_m), (capsule.to - capsule.from).norm());
}

/// Returns base_from_capsule, with z along the segment.
Pose pose_of(const CapsuleBody& body) {
  Pose pose = Pose::Identity();
  pose.translation() = 0.5 * (body.from + body.to);
  if (body.from != body.to)
    pose.linear() = math::shortest_rotation(Vec3::UnitZ(), body.to - body.from).toRotationMatrix();
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

  const CollisionWorld& world;
  std::vector<Geometry> capsule_shapes, padded_capsule_shapes;  ///< grown by 0, margin
  std::vector<Geometry> shapes;  ///< [objects] nullptr if the mesh is invalid
  std::vector<char> checked;     ///< [capsules * capsules] 1 for pairs of world.pairs
  std::vector<std::unique_ptr<Object>> capsule_objects, scene_objects;
  fcl::DynamicAABBTreeCollisionManager<double> capsule_tree, scene_tree;
  std::vector<Pose> poses;
  // State of the current query.
  const CollisionScratch* scratch = nullptr;
  double time_s = 0;
  bool first_only = false;
  std::vector<PairSeparation> colliding;  ///< not measured

  explicit Trees(const CollisionWorld& w) : world(w) {
    const std::size_t count = world.robot->capsules.size();
    poses.resize(count);
    for (const RobotModel::Capsule& capsule : world.robot->capsules) {
      capsule_shapes.push_back(capsule_of(capsule, 0));
      padded_capsule_shapes.push_back(capsule_of(capsule, world.tolerances.required_clearance));
      add(capsule_objects.size(), padded_capsule_shapes.back(), capsule_objects, capsule_tree);
    }
    checked.assign(count * count, 0);
    for (const auto& [i, j] : world.pairs) {
      checked[i * count + j] = 1;
      checked[j * count + i] = 1;
    }
    for (int k = 0; k < std::ssize(world.scene->objects); ++k) {
      const Solid solid = solid_at(world, k);
      shapes.push_back(solid.mesh ? mesh_of(*solid.mesh) : shape_of(solid.object, 0));
      if (shapes.back()) add(k, shapes.back(), scene_objects, scene_tree);
    }
  }

  static void add(std::size_t index, const Geometry& shape,
                  std::vector<std::unique_ptr<Object>>& objects,
                  fcl::DynamicAABBTreeCollisionManager<double>& tree) {
    objects.push_back(std::make_unique<Object>(shape));
    objects.back()->setUserData(reinterpret_cast<void*>(index));
    tree.registerObject(objects.back().get());
  }

  static int index_of(const Object* object) {
    return static_cast<int>(reinterpret_cast<std::size_t>(object->getUserData()));
  }

  bool is_capsule(const Object* object) const {
    const int i = index_of(object);
    return i < std::ssize(capsule_objects) && object == capsule_objects[i].get();
  }

  static void move(Object& object, const Pose& pose) {
    object.setTransform(pose);
    object.computeAABB();
  }

  /// Returns true if capsule i is nearer to object k than the required distance.
  bool object_touches(int i, int k, double required_m) const {
    const Solid solid = solid_at(world, k);
    const RobotModel::Capsule& capsule = world.robot->capsules[i];
    const Pose& pose = scratch->object_poses[k];
    const double shrink_m = std::max(0.0, kFclMinRadius_m - capsule.radius - required_m);
    if (!shapes[k]) return true;
    if (solid.mesh) {
      if (shrink_m > 0) return capsule_solid(scratch->bodies[i], solid, pose).distance < required_m;
      return touch(*capsule_of(capsule, required_m), poses[i], *shapes[k], pose) ||
             is_inside(*solid.mesh, pose.inverse() * poses[i].translation());
    }
    if (required_m == world.tolerances.required_clearance)
      return touch(*padded_capsule_shapes[i], poses[i], *shapes[k], pose);
    const Geometry shape = shape_of(solid.object, shrink_m);
    return shape && touch(*capsule_of(capsule, required_m), poses[i], *shape, pose);
  }

  /// Callback for two capsules: records a collision; returns true to end the query.
  static bool visit_capsules(Object* a, Object* b, void* data) {
    Trees& trees = *static_cast<Trees*>(data);
    const auto [i, j] = std::minmax({index_of(a), index_of(b)});
    if (!trees.checked[i * trees.capsule_shapes.size() + j] ||
        !touch(*trees.padded_capsule_shapes[i], trees.poses[i], *trees.capsule_shapes[j],
               trees.poses[j])) {
      return false;
    }
    trees.colliding.push_back({{i, j, false}, {}, trees.world.tolerances.required_clearance});
    return trees.first_only;
  }

  /// Callback for a capsule and an object: like visit_capsules().
  static bool visit_objects(Object* a, Object* b, void* data) {
    Trees& trees = *static_cast<Trees*>(data);
    const bool capsule_first = trees.is_capsule(a);
    const int i = index_of(capsule_first ? a : b), k = index_of(capsule_first ? b : a);
    const double required_m = required_distance_m(trees.world, i, k, trees.time_s);
    if (!trees.object_touches(i, k, required_m)) return false;
    trees.colliding.push_back({{i, k, true}, {}, required_m});
    return trees.first_only;
  }

  /// Records the collisions of a carried target, by solid_solid().
  void judge_carried() {
    if (!is_carried(world, time_s)) return;
    for (int k = 0; k < std::ssize(shapes); ++k) {
      if (k == world.target) continue;
      PairSeparation pair = unmeasured(world, {world.target, k, true, true}, time_s);
      measure(world, *scratch, pair);
      if (pair.slack() < 0) colliding.push_back(pair);
    }
  }

  void query(const Eigen::Ref<const JointVector>& q, double query_time_s, bool until_first,
             CollisionScratch& buffers) {
    update_bodies(world, q, query_time_s, buffers);
    scratch = &buffers;
    time_s = query_time_s;
    first_only = until_first;
    colliding.clear();
    for (int i = 0; i < std::ssize(poses); ++i) {
      poses[i] = pose_of(buffers.bodies[i]);
      move(*capsule_objects[i], poses[i]);
    }
    for (const auto& object : scene_objects)
      move(*object, buffers.object_poses[index_of(object.get())]);
    for (int k = 0; k < std::ssize(shapes); ++k) {
      if (shapes[k]) continue;
      for (int i = 0; i < std::ssize(poses); ++i) colliding.push_back({{i, k, true}, {}, 0});
    }
    judge_carried();
    if (poses.empty() || (first_only && !colliding.empty())) return;
    capsule_tree.update();
    capsule_tree.collide(this, visit_capsules);
    if (scene_objects.empty() || (first_only && !colliding.empty())) return;
    scene_tree.update();
    capsule_tree.collide(&scene_tree, this, visit_objects);
  }
};

FclEngine::FclEngine(const CollisionWorld& world) : trees_(std::make_unique<Trees>(world)) {}
FclEngine::~FclEngine() = default;

bool FclEngine::is_free(const Eigen::Ref<const JointVector>& q, double time_s,
                        CollisionScratch& scratch) {
  trees_->query(q, time_s, true, scratch);
  return trees_->colliding.empty();
}

void FclEngine::colliding_pairs(const Eigen::Ref<const JointVector>& q, double time_s,
                                CollisionScratch& scratch, std::vector<PairSeparation>& out) {
  trees_->query(q, time_s, false, scratch);
  out = trees_->colliding;
  std::ranges::sort(out, {}, &PairSeparation::key);
  for (PairSeparation& pair : out) measure(trees_->world, scratch, pair);
}

}  // namespace morphe::collision
