#pragma once

namespace morphe::cover {

// The numbers that decide a cover, chosen by hand, not measured, unless a comment names a reason.

// --- voxels.cpp
inline constexpr int kCellsOnLongestSide = 72;
inline constexpr int kPaddingCells = 3;     ///< empty voxels on each side of the grid
inline constexpr double kMinStep_m = 1e-5;  ///< least size of a voxel

// --- surface.cpp
inline constexpr int kFacetsPerCircle = 24, kFacetsPerHalfCircle = 12;
/// Number of directions of outermost_corners(), kCornerProducts / triangles within these limits: a
/// huge mesh gets fewer, because its samples are dense anyway.
inline constexpr int kCornerProducts = 60'000'000, kMinDirections = 30, kMaxDirections = 300;

// --- sampled points
inline constexpr int kVoxelSampleCount = 150000;    ///< mark the voxels of the surface
inline constexpr int kFitSampleCount = 3000;        ///< must be enclosed in the search
inline constexpr int kEnclosedSampleCount = 60000;  ///< must be enclosed by the final radii
inline constexpr int kQualitySampleCount = 12000;   ///< judge the result

// --- choose_segments.cpp
inline constexpr int kCandidateCount = 1600, kMaxDrawsPerCandidate = 8;
inline constexpr int kDeepDraws = 3;     ///< of so many interior points the deepest is an end
inline constexpr int kSpherePeriod = 4;  ///< one candidate of so many is a sphere
/// Bisections of the growth: down to a 4096th of the body's extent.
inline constexpr int kGrowthBisectionCount = 12;

// --- fit_capsules.cpp
inline constexpr int kRefineRoundCount = 60, kMovesPerRound = 8;
/// Standard deviation of the first moves of an end, in voxels, and its factor from round to round.
inline constexpr double kFirstMove_cells = 4, kMoveFactor = 0.93;
inline constexpr int kMinSplitPoints = 9;        ///< enclosed by a capsule that is split
inline constexpr double kRadiusMargin_m = 2e-4;  ///< added for the surface between samples
/// Points on a capsule's surface: rings and points of a ring, for the cost and for the quality.
inline constexpr int kCostRings = 8, kCostRingPoints = 10, kQualityRings = 16,
                     kQualityRingPoints = 20;
/// Points of a capsule's surface that are deeper in the others do not belong to the outer surface.
inline constexpr double kOuterDepth_m = 1e-6;
inline constexpr double kNear_m = 0.005;  ///< standoff up to which FitQuality::near_share counts
inline constexpr double kSameLength_m = 1e-9;  ///< lengths that differ by less are equal

}  // namespace morphe::cover
