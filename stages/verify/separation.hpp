#pragma once

#include "core/motion/scene.hpp"

namespace morphe::verify {

/// A line segment, for example the axis of a capsule.
struct Segment {
  Vec3 from, to;
};

/// Computes the least distance of two segments: min over u, v in [0, 1] of |a(u) - b(v)| [m]. Its
/// square is a convex quadratic, whose minimum is at the stationary point if that is inside the
/// square of u and v, otherwise on one of the four sides.
double segment_distance(const Segment& a, const Segment& b);

/// Computes the signed distance of a point to a solid's surface, < 0 inside, with the point in the
/// solid's frame [m]. Handles sphere, box, cylinder and capsule; NaN for a mesh.
double signed_distance(const SceneObject& solid, const Vec3& point);

/// Computes the least signed distance of the segment to the solid, in the solid's frame [m]. The
/// signed distance to a convex body is convex along a line, so that a golden-section search finds
/// the minimum (its place to 1e-9 m). If the result cannot be smaller than `enough`, at least
/// `enough` is returned without a search.
double segment_solid_distance(const SceneObject& solid, const Segment& segment, double enough);

/// Returns true if the shape has all required sizes and they are positive; for a mesh, if all
/// vertices are finite and exist for all triangles, of which one has three distinct corners.
bool has_valid_shape(const SceneObject& solid);

/// Returns the greatest distance of a point of the solid from the origin of its frame [m].
double bounding_radius(const SceneObject& solid);

}  // namespace morphe::verify
