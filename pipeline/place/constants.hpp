#pragma once

#include "core/motion/geometry.hpp"

/// Numbers that decide a result; those without a reason here were chosen by hand, not measured.
namespace morphe::place {

// The region of the search and the constraints.
/// limits of the robot's shoulder relative to the human's [m], to the right, forward and up
inline const Vec3 kMinShoulderOffset_m(-0.6, -0.8, -0.6), kMaxShoulderOffset_m(0.6, 0.4, 0.6);
inline constexpr double kHalfShoulderBreadth_m = 0.2;  ///< half of a man's breadth
inline constexpr double kTableClearance_m = 0.005;     ///< least height of the base above the table
/// Largest angle between the directions to which person and standing robot face, chosen by hand: at
/// twice as much a torso stands sideways to the table.
inline constexpr double kMaxFacingAngle_rad = 30 * kRadPerDegree;

// Reachability of the random poses: number of sampled postures, and cells of the grid.
inline constexpr int kPostureCount = 30000, kDistanceCells = 40, kAngleCells = 18;
inline constexpr int kGoalFrameCount = 12, kMinTrialFrames = 5;  ///< of a trial: used, required

/// The effort with which a pose is evaluated.
struct SearchEffort {
  int frames = 8;  ///< per movement
  int key_frames = 2, starts = 6;
};
/// The steps of a compass search.
struct CompassSteps {
  double shift_m = 0.12, turn_rad = 24 * kRadPerDegree;  ///< of the first level
  int levels = 4;  ///< each with half the steps of the previous one
};

// Screening of the candidates and improvement of the best.
inline constexpr SearchEffort kScreeningEffort{6, 2, 4}, kSecondScreeningEffort{8, 2, 6};
inline constexpr int kScreeningTrialCount = 3;
inline constexpr int kScreeningDivisor = 3;  ///< the better third is mapped in more trials
inline constexpr SearchEffort kRefinementEffort{10, 2, 6};
inline constexpr CompassSteps kRoughSteps{0.12, 24 * kRadPerDegree, 2};
inline constexpr CompassSteps kFineSteps{0.03, 6 * kRadPerDegree, 2};
inline constexpr int kMaxRounds = 4;          ///< of steps in all directions, per level
inline constexpr double kMinGain_deg = 0.02;  ///< of the cost; smaller gains are ignored
/// Poses that differ by less than both values are similar; one of them is kept.
inline constexpr double kSamePlace_m = 0.06, kSimilarAngle_rad = 15 * kRadPerDegree;
/// Limits of a descent: the cost of a pose is known well before its postures converge.
inline constexpr int kMaxIterations = 12;
inline constexpr double kRelativeTolerance = 3e-4;

// Measures.
inline constexpr double kReachTolerance_m = 0.002;  ///< largest error of a goal that is met
inline constexpr double kMaxTipError_m = 0.2;       ///< larger errors count as this
inline constexpr double kLimitZone_rad = 0.15;      ///< distance from a joint's limit that is near

// Weights of the cost [degrees of the upper arm]; cost_of() has the reasons.
inline constexpr double kOutOfReachWeight = 500, kTipErrorWeight_per_m = 2e3;
inline constexpr double kCollisionWeight = 100, kPenetrationWeight_per_m = 1e3;
inline constexpr double kPalmWeight = 0.15, kNearLimitsWeight = 10, kSpeedWeight = 10;

// The reachability map.
inline constexpr int kMapCellsPerSide = 13, kMapTrialCount = 3;
inline constexpr double kMapCellSize_m = 0.1;
inline constexpr SearchEffort kMapEffort{6, 2, 4};

}  // namespace morphe::place
