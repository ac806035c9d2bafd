#pragma once

#include "core/motion/scene.hpp"

namespace morphe::verify {

/// A line segment, for example the axis of a capsule.
struct Segment {
  Vec3 from, to;
};

/// Computes the least distance of two segments: min over u, v in [0, 1] of |a(u) - b(v)| [m]. It is
/// a convex quadratic in two variables, whose minimum is the stationary point if that is inside the
/// square, otherwise the best of the four sides.
double segment_distance(const Segment& a, const Segment& b);

/// Computes the signed distance of a point to a solid's surface, < 0 inside, both in the solid's
/// frame [m]. Supports sphere, box, cylinder and capsule.
double signed_distance(const SceneObject& solid, const Vec3& point);

/// Computes the least signed distance of the segment to the solid, in the solid's frame [m]. The
/// signed distance to a convex body is convex along a line, so that a golden-section search finds
/// the minimum (to 1e-9 m). If the result cannot be smaller than `enough`, at least `enough` is
/// returned without a search.
double segment_solid_distance(const SceneObject& solid, const Segment& segment, double enough);

/// Returns true if the shape has all required sizes and they are positive; for a mesh, if it has a
/// triangle, and all corners exist and are finite.
bool has_valid_shape(const SceneObject& solid);

/// Returns the greatest distance of a point of the solid from its centre [m].
double bounding_radius(const SceneObject& solid);

}  // namespace morphe::verify
