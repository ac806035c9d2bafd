#pragma once

#include <vector>

#include "stages/verify/separation.hpp"

namespace morphe::verify {

/// A triangle mesh in its object's frame, with the solid part defined as in docs/formats.md.
/// Triangles that share edges form a component. A component is watertight if each of its edges
/// belongs to an even number of triangles. A point is inside the solid of a watertight component
/// if a ray from there crosses the component an odd number of times. Others are thin sheets.
struct Mesh {
  /// A triangle and the component to which it belongs.
  struct Triangle {
    Vec3 a, b, c;
    int component = 0;
  };
  /// A group of neighbouring triangles with a bounding ball and a bounding box.
  struct Cluster {
    int begin = 0, end = 0;  ///< in `triangles`
    Vec3 centre, low, high;
    double radius = 0;
  };
  std::vector<Triangle> triangles;  ///< sorted by cluster
  std::vector<Cluster> clusters;
  Cluster ball;                  ///< bounds the whole mesh
  std::vector<char> watertight;  ///< per component
};

/// Builds the mesh of an object. Triangles with two corners at the same position, which are only
/// edges of others, are omitted. The indices must be valid.
Mesh make_mesh(const SceneObject& object);

/// Returns true if a point is inside the solid of the mesh.
bool is_inside(const Mesh& mesh, const Vec3& point);

/// Returns the least signed distance of the segment [m]. It is the distance to the nearest triangle
/// if no point of the segment is inside the solid. Otherwise it is minus the largest depth found
/// below the nearest surface, underestimated by at most 5 % + 10 um. If the result cannot be
/// smaller than `enough`, at least `enough` is returned without a search.
double segment_mesh_distance(const Mesh& mesh, const Segment& segment, double enough);

}  // namespace morphe::verify
