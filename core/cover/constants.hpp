#pragma once

namespace morphe::cover {

// The numbers that decide a cover, chosen by hand, not measured, unless a comment names a reason.

// --- cover_primitives.cpp
inline constexpr int kEndSteps = 8;          ///< lengths of the segments that are tried
inline constexpr int kMaxPerPrimitive = 64;  ///< capsules
/// Ratio of the mean square standoff of a hemisphere from a flat end to its largest.
inline constexpr double kEndWeight = 0.5;
inline constexpr double kRoundedNumber_m = 2e-6;  ///< descriptions have micrometres

// --- voxels.cpp
inline constexpr int kCellsOnLongestSide = 96;
/// Voxels across the gap to a body nearby, as far as the longest side does not get too many.
inline constexpr int kCellsAcrossGap = 8, kMaxCellsOnLongestSide = 192;
inline constexpr int kPaddingCells = 6;  ///< least number of empty voxels on each side
/// Spacing of the points that mark a triangle's voxels: every point of it has one within
/// 0.5 sqrt(2) times as much, which must be below half a voxel.
inline constexpr double kMarkSpacing_cells = 0.6;
inline constexpr double kMinStep_m = 1e-5;  ///< least size of a voxel

// --- surface.cpp
/// Number of directions of outermost_corners(), kCornerProducts / triangles within these limits: a
/// huge mesh gets fewer, because its samples are dense anyway.
inline constexpr int kCornerProducts = 60'000'000, kMinDirections = 30, kMaxDirections = 300;

/// Directions that differ by less than 8 degrees count as one, at most so many normals are taken,
/// and normals that are nearly parallel have no cross product.
inline constexpr double kSameNormalCosine = 0.99, kMinCross = 0.2;
inline constexpr int kMaxMainNormals = 8;

// --- sampled points
inline constexpr int kFitSampleCount = 12000;  ///< must be enclosed in the search
/// Area of the surface for each point that must be enclosed by the final radii, and bounds of their
/// number: between points 1.5 mm apart, two capsules leave a groove of less than 1 mm.
inline constexpr double kEnclosedSampleArea_m2 = 2.25e-6;
inline constexpr int kMinEnclosedSamples = 40000, kMaxEnclosedSamples = 400000;
inline constexpr int kQualitySampleCount = 12000;  ///< judge the result
inline constexpr int kSurfacePerInnerPoint = 4;    ///< points on the surface for one inside

// --- point_cloud.cpp
/// Above the round-off of single precision within metres of the origin.
inline constexpr float kRoundOff_m = 1e-5F;

// --- choose_segments.cpp
inline constexpr int kCandidateCount = 600, kMaxDrawsPerCandidate = 8;
inline constexpr int kDeepDraws = 3;     ///< of so many interior points the deepest is an end
inline constexpr int kSpherePeriod = 4;  ///< one candidate of so many is a sphere
/// Bisections of the growth: down to a 256th of the body's extent.
inline constexpr int kGrowthBisectionCount = 8;
/// Number of the best candidates, and of balls about uncovered points, whose ends are moved by
/// normal deviates. Their standard deviation begins at kClimbFirstMove_cells voxels, and each of
/// the kClimbMoves moves multiplies it by kClimbMoveFactor. More balls are tried if none adds a
/// point.
inline constexpr int kClimbedCandidates = 2, kUncoveredSeeds = 6, kMaxUncoveredSeeds = 100;
inline constexpr int kBallsPerPoint = 40, kClimbMoves = 40, kClimbBisectionCount = 4;
inline constexpr double kClimbFirstMove_cells = 8, kClimbMoveFactor = 0.96;

// --- fit_capsules.cpp
inline constexpr int kRefineRoundCount = 60, kMovesPerRound = 8;
/// Standard deviation of the first moves of an end, in voxels, and its factor from round to round.
inline constexpr double kFirstMove_cells = 4, kMoveFactor = 0.93;
inline constexpr double kRadiusMargin_m = 2e-4;  ///< added for the surface between samples
/// Points on a capsule's surface: rings and points of a ring, for the cost and for the quality.
inline constexpr int kCostRings = 8, kCostRingPoints = 10, kQualityRings = 16,
                     kQualityRingPoints = 20;
/// Points of a capsule's surface that are deeper in the others do not belong to the outer surface.
inline constexpr double kOuterDepth_m = 1e-6;
inline constexpr double kNear_m = 0.005;  ///< standoff up to which FitQuality::near_share counts
inline constexpr double kSameLength_m = 1e-9;  ///< lengths that differ by less are equal

}  // namespace morphe::cover
