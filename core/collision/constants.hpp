#pragma once

#include <cstdint>

namespace morphe::collision {

// Distances of shapes.

/// Squared sine of the angle below which two segments count as parallel. Above it, their linear
/// system loses at most six of sixteen digits. Chosen by hand, not measured.
inline constexpr double kParallelSquaredSine = 1e-6;
/// Length of the interval at which the search along a segment ends: a tenth of the error that
/// capsule_solid() allows.
inline constexpr double kSegmentResolution_m = 1e-10;
/// Depth of every point in an invalid mesh: more than any tolerance, so that it always collides.
inline constexpr double kInvalidMeshDepth_m = 1;
/// Distance below which two points coincide: rounding of coordinates of some metres.
inline constexpr double kCoincidence_m = 1e-12;
/// Accuracy of depths in a mesh. The search ends when no point of the segment can be deeper than
/// factor * (largest depth found) + tolerance. Chosen by hand, not measured.
inline constexpr double kMeshDepthFactor = 1.05, kMeshDepthTolerance_m = 1e-5;
/// Distance from a triangle's edges, relative to its size, below which a ray grazes them and
/// another direction is tried. Chosen by hand, not measured.
inline constexpr double kGrazingTolerance = 1e-9;
inline constexpr int kMaxLeafTriangles = 4;  ///< of a tree of boxes; chosen by hand, not measured

// Distances of an object in the hand.

/// Accuracy of the distance of convex bodies at which the search ends: that of the closed forms.
inline constexpr double kConvexResolution_m = 1e-9;
/// Largest number of support points of such a search. Boxes need about 6, cylinders about 20; a
/// search that ends here gives a smaller distance, never a larger one.
inline constexpr int kMaxSupportPoints = 100;
/// Sizes of shrunk bodies, whose separations are tried as directions for bodies that overlap.
/// Chosen by hand: a shallow, a deep and a very deep overlap.
inline constexpr double kShrinkShares[] = {0.9, 0.5, 0.1};

// An object in the hand and what supports it.

/// Noise of an object's height above its support [m]: within it, the object counts as standing on
/// another one when the hand takes it or releases it, and no more overlap is allowed. Cups of the
/// shipped recordings dip by 0.1 mm when they are lifted and are put down 0.3 to 0.9 mm deep; the
/// rest is a reserve, chosen by hand, for objects and tables that are recorded separately.
inline constexpr double kSupportNoise_m = 0.002;
/// Greatest distance from everything else at which the target may be released [m]: a cup that falls
/// 10 mm still stands. Chosen by hand, not measured.
inline constexpr double kMaxReleaseGap_m = 0.01;

// Mesh files.

inline constexpr std::uintmax_t kMaxMeshFile_bytes = 200'000'000;  ///< read in 11 s and 1.5 GB
/// Distance within which vertices are merged: far below what a mesh describes, and above rounding
/// to single precision at 10 m. Chosen by hand, not measured.
inline constexpr double kWeldTolerance_m = 1e-6;
inline constexpr double kMaxHoleWidth_m = 0.01;  ///< holes too narrow for a robot's finger

// Pairs and motions.

/// Largest number of capsules of a frame that share a bounding box. Results do not depend on it.
/// With 3, 4, 8, 10, 12 and 16, the search for near pairs takes 31, 27, 22, 21, 21 and 22 us with
/// xArm 7 and LEAP (359 capsules), and 9.3, 8.1, 7.4, 7.5, 7.3 and 8.7 us with iiwa 14 and Allegro.
inline constexpr int kMaxClusterCapsules = 10;
/// Added to the size of such a box: far above the rounding of poses of some metres, so that no pair
/// is excluded whose own distance would not exclude it.
inline constexpr double kClusterPadding_m = 1e-9;
/// Maximum depth of bisection of a motion: intervals of 1e-12 of it, whose travel is rounding.
inline constexpr int kMaxBisectionDepth = 40;
/// Travel of a pair within an interval below which the interval is not bisected further: far below
/// the margins of millimetres. Chosen by hand, not measured.
inline constexpr double kMotionBand_m = 1e-4;
/// Allowed error of a motion's clearance, as in `verify`.
inline constexpr double kMotionClearanceError_m = 1e-4;
/// Travel below which the search for a motion's clearance ends: the accuracy of distances.
inline constexpr double kMinTravel_m = 1e-9;
inline constexpr int kTimeBisections = 60;  ///< find a time's parameter to the bits of a double
/// Smallest radius of FCL's capsules, which must be positive. A capsule that may penetrate deeper
/// than its radius gets this one, and the object shrinks by the rest of the depth.
inline constexpr double kFclMinRadius_m = 1e-6;

}  // namespace morphe::collision
