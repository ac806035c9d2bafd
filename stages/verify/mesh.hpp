#pragma once

#include <vector>

#include "stages/verify/separation.hpp"

namespace morphe::verify {

/// A triangle mesh in its object's frame, as docs/formats.md says what of it is solid: triangles
/// hang together in parts by the edges they share; a part is closed if each of its edges has an
/// even number of triangles, and then all that a ray leaves through it an odd number of times is
/// solid. Any other part is a sheet without thickness.
struct Mesh {
  struct Triangle {
    Vec3 a, b, c;
    int part = 0;
  };
  /// Neighbouring triangles with a ball and a box around them.
  struct Cluster {
    std::size_t begin = 0, end = 0;
    Vec3 centre, low, high;
    double radius = 0;
  };
  std::vector<Triangle> triangles;  ///< by cluster
  std::vector<Cluster> clusters;
  Cluster ball;              ///< around all of it
  std::vector<char> closed;  ///< by part
};

/// Triangles with two corners in one place, which are only edges of others, are left out. The
/// indices must be valid.
Mesh make_mesh(const SceneObject& object);

bool inside(const Mesh& mesh, const Vec3& point);

/// Least signed distance of the segment [m]: to the nearest triangle while no point of it is in the
/// solid, else how deep the deepest one found lies below the nearest surface, at most 5 % + 10 um
/// too little. At least `enough` is returned without a search when nothing smaller can come out.
double segment_mesh_distance(const Mesh& mesh, const Segment& segment, double enough);

}  // namespace morphe::verify
