#include <algorithm>
#include <vector>

#include "core/collision/constants.hpp"
#include "core/collision/convex_distance.hpp"
#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"

namespace morphe::collision {
namespace {

/// A solid and its pose in the common frame.
struct Placed {
  const Solid& solid;
  const Pose& pose;
};

/// Returns an object that is not a mesh as a convex body.
ConvexBody convex_body(const Placed& placed) {
  const std::vector<double>& size = placed.solid.object.size;
  ConvexBody body;
  body.centre = placed.pose.translation();
  body.axes = placed.pose.linear();
  switch (placed.solid.object.shape) {
    case Shape::box:
      body.half = 0.5 * Vec3(size[0], size[1], size[2]);
      break;
    case Shape::cylinder:
      body.core = ConvexBody::Core::cylinder;
      body.half = Vec3(size[0], size[0], 0.5 * size[1]);
      break;
    case Shape::capsule:
      body.half.z() = 0.5 * size[1];
      [[fallthrough]];
    case Shape::sphere:
      body.radius = size[0];
      break;
    case Shape::mesh:
      break;
  }
  return body;
}

ConvexBody convex_body(const MeshSolid::Triangle& triangle, const Pose& pose) {
  ConvexBody body;
  body.core = ConvexBody::Core::triangle;
  body.corners = {pose * triangle.a, pose * triangle.b, pose * triangle.c};
  body.centre = (body.corners[0] + body.corners[1] + body.corners[2]) / 3;
  return body;
}

Separation separation_of(const ConvexSeparation& convex) {
  return {convex.distance, convex.on_first, convex.on_second, convex.normal};
}

void keep_nearer(const Separation& candidate, Separation& nearest) {
  if (candidate.distance < nearest.distance) nearest = candidate;
}

double radius_of(const MeshSolid::Node& node) { return 0.5 * (node.high - node.low).norm(); }

/// Returns a lower bound of the distance of a mesh's node from a convex solid [m].
double node_bound(const Placed& mesh, const MeshSolid::Node& node, const Placed& convex) {
  const Vec3 centre = mesh.pose * Vec3(0.5 * (node.low + node.high));
  return signed_distance_lower_bound(convex.solid, convex.pose.inverse() * centre) -
         radius_of(node);
}

/// Lowers `nearest` to the separation of the triangles below a node from a convex solid.
void descend(const Placed& mesh, int root, const Placed& convex, const ConvexBody& body,
             Separation& nearest) {
  const std::vector<MeshSolid::Node>& nodes = mesh.solid.mesh->nodes;
  const MeshSolid::Node& node = nodes[root];
  for (int t = node.first; t < node.first + node.count; ++t) {
    const ConvexBody triangle = convex_body(mesh.solid.mesh->triangles[t], mesh.pose);
    keep_nearer(separation_of(convex_distance(triangle, body)), nearest);
  }
  if (node.count > 0) return;
  int nearer = node.left, farther = node.right;
  double near_m = node_bound(mesh, nodes[nearer], convex);
  double far_m = node_bound(mesh, nodes[farther], convex);
  if (far_m < near_m) {
    std::swap(nearer, farther);
    std::swap(near_m, far_m);
  }
  if (near_m < nearest.distance) descend(mesh, nearer, convex, body, nearest);
  if (far_m < nearest.distance) descend(mesh, farther, convex, body, nearest);
}

/// Returns a lower bound of the distance of two meshes' nodes [m].
double node_bound(const MeshSolid::Node& first, const MeshSolid::Node& second,
                  const Pose& first_from_second) {
  const Vec3 centre = first_from_second * Vec3(0.5 * (second.low + second.high));
  return (centre - 0.5 * (first.low + first.high)).norm() - radius_of(first) - radius_of(second);
}

/// Two meshes, whose pairs of nodes are searched.
struct MeshPair {
  Placed first, second;
  Pose first_from_second;

  double bound(int a, int b) const {
    return node_bound(first.solid.mesh->nodes[a], second.solid.mesh->nodes[b], first_from_second);
  }
};

void compare_leaves(const MeshPair& pair, const MeshSolid::Node& a, const MeshSolid::Node& b,
                    Separation& nearest) {
  for (int i = a.first; i < a.first + a.count; ++i) {
    const ConvexBody triangle = convex_body(pair.first.solid.mesh->triangles[i], pair.first.pose);
    for (int k = b.first; k < b.first + b.count; ++k)
      keep_nearer(
          separation_of(convex_distance(
              triangle, convex_body(pair.second.solid.mesh->triangles[k], pair.second.pose))),
          nearest);
  }
}

/// Lowers `nearest` to the separation of the triangles below two nodes.
void descend(const MeshPair& pair, int root_a, int root_b, Separation& nearest) {
  const MeshSolid::Node& a = pair.first.solid.mesh->nodes[root_a];
  const MeshSolid::Node& b = pair.second.solid.mesh->nodes[root_b];
  if (a.count > 0 && b.count > 0) return compare_leaves(pair, a, b, nearest);
  const bool split_first = b.count > 0 || (a.count == 0 && radius_of(a) >= radius_of(b));
  struct Next {
    int a, b;
    double bound_m;
  };
  std::array<Next, 2> next = split_first
                                 ? std::array<Next, 2>{{{a.left, root_b, 0}, {a.right, root_b, 0}}}
                                 : std::array<Next, 2>{{{root_a, b.left, 0}, {root_a, b.right, 0}}};
  for (Next& one : next) one.bound_m = pair.bound(one.a, one.b);
  if (next[1].bound_m < next[0].bound_m) std::swap(next[0], next[1]);
  for (const Next& one : next)
    if (one.bound_m < nearest.distance) descend(pair, one.a, one.b, nearest);
}

/// Lowers `nearest` to minus the depth of a point of the first solid in the second one, a mesh.
void deepen(const Vec3& point, const Placed& mesh, double sign, Separation& nearest) {
  Vec3 gradient;
  const Vec3 in_mesh = mesh.pose.inverse() * point;
  if (!is_inside(*mesh.solid.mesh, in_mesh)) return;
  const double distance_m = mesh_distance(*mesh.solid.mesh, in_mesh, gradient);
  if (distance_m >= nearest.distance) return;
  const Vec3 outwards = mesh.pose.linear() * gradient;
  const Vec3 surface = point - distance_m * outwards;
  nearest = sign > 0 ? Separation{distance_m, point, surface, outwards}
                     : Separation{distance_m, surface, point, -outwards};
}

/// Lowers `nearest` to minus the depth of the deepest vertex of a mesh in another one. `sign` is -1
/// if `inner` is the second body.
void deepen_vertices(const Placed& inner, const Placed& outer, double sign, Separation& nearest) {
  for (const MeshSolid::Triangle& t : inner.solid.mesh->triangles)
    for (const Vec3& corner : {t.a, t.b, t.c}) deepen(inner.pose * corner, outer, sign, nearest);
}

/// Computes the separation of a mesh from a convex solid.
Separation mesh_convex(const Placed& mesh, const Placed& convex) {
  Separation nearest{kInfinity, {}, {}, {}};
  const ConvexBody body = convex_body(convex);
  descend(mesh, 0, convex, body, nearest);
  deepen(convex.pose.translation(), mesh, -1, nearest);
  return nearest;
}

Separation mesh_mesh(const Placed& first, const Placed& second) {
  Separation nearest{kInfinity, {}, {}, {}};
  descend({first, second, first.pose.inverse() * second.pose}, 0, 0, nearest);
  deepen_vertices(first, second, 1, nearest);
  deepen_vertices(second, first, -1, nearest);
  return nearest;
}

/// Exchanges first and second body.
Separation turned(const Separation& s) { return {s.distance, s.on_second, s.on_first, -s.normal}; }

bool is_mesh(const Solid& solid) { return solid.object.shape == Shape::mesh; }

}  // namespace

Separation solid_solid(const Solid& first, const Pose& first_pose, const Solid& second,
                       const Pose& second_pose) {
  const Placed a{first, first_pose}, b{second, second_pose};
  if ((is_mesh(first) && !first.mesh) || (is_mesh(second) && !second.mesh))
    return {-kInvalidMeshDepth_m, first_pose.translation(), second_pose.translation(),
            Vec3::UnitZ()};
  if (is_mesh(first) && is_mesh(second)) return mesh_mesh(a, b);
  if (is_mesh(first)) return mesh_convex(a, b);
  if (is_mesh(second)) return turned(mesh_convex(b, a));
  return separation_of(convex_distance(convex_body(a), convex_body(b)));
}

double solid_distance_lower_bound(const Solid& first, const Pose& first_pose, const Solid& second,
                                  const Pose& second_pose) {
  const auto bound = [](const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b) {
    const Vec3 centre = pose_b.linear().transpose() * (pose_a.translation() - pose_b.translation());
    return signed_distance_lower_bound(b, centre) - bounding_radius(a);
  };
  return std::max(bound(first, first_pose, second, second_pose),
                  bound(second, second_pose, first, first_pose));
}

}  // namespace morphe::collision
