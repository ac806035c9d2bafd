#pragma once

#include <map>
#include <vector>

#include "core/collision/mesh_body.hpp"
#include "core/cover/surface.hpp"
#include "core/motion/robot_model.hpp"
#include "core/motion/scene.hpp"

namespace morphe::setup {

/// The real shape of a link, in its frame: its meshes and primitives, not what is laid around them.
struct LinkBody {
  collision::MeshBody mesh;
  std::vector<cover::Triangle> triangles;
  std::vector<Vec3> surface;  ///< points on it
  double radius_m = 0;        ///< of the sphere about the frame's origin that contains it
  bool assumed = false;       ///< true if the link has no shapes: its capsules stand for them
};
/// The bodies of frames.
using LinkBodies = std::map<int, LinkBody>;

/// Returns the body of every frame that has capsules: of its shapes or, without any, of its
/// capsules. Curved shapes become facets that stand off them by at most 0.06 % of their radius.
LinkBodies link_bodies(const std::map<int, std::vector<SceneObject>>& shapes_by_frame,
                       const RobotModel& robot);

/// Returns the largest depth of a point on one of two bodies in the other [m], 0 if there is none.
double overlap_depth_m(const LinkBody& one, const LinkBody& other, const Pose& one_from_other);

}  // namespace morphe::setup
