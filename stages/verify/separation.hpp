#pragma once

#include "core/motion/scene.hpp"

namespace morphe::verify {

struct Segment {
  Vec3 from, to;
};

/// Least distance of two segments: min over u, v in [0, 1] of |a(u) - b(v)| [m]. A convex quadratic
/// in two variables: its stationary point if that lies in the square, else the best of the four
/// sides.
double segment_distance(const Segment& a, const Segment& b);

/// Signed distance of a point to a solid's surface, < 0 inside, both in the solid's frame [m].
/// Sphere, box, cylinder, capsule.
double signed_distance(const SceneObject& solid, const Vec3& point);

/// Least signed distance of the segment to the solid, in the solid's frame [m]: the signed distance
/// to a convex body is convex along a line, so a golden-section search finds it (to 1e-9 m). At
/// least `enough` is returned without a search when nothing smaller can come out.
double segment_solid_distance(const SceneObject& solid, const Segment& segment, double enough);

/// True if the shape has the sizes that it needs, all positive; a mesh: a triangle, and corners
/// that exist and are numbers.
bool can_judge(const SceneObject& solid);

/// Greatest distance of a point of the solid from its centre [m].
double bounding_radius(const SceneObject& solid);

}  // namespace morphe::verify
