#pragma once

#include <cstddef>
#include <cstdint>

#include "core/motion/geometry.hpp"

/// Numbers that decide a result and are no options, chosen by hand unless a comment names a reason.
namespace morphe::map {

/// Postures whose joints all differ by less count as the same local minimum.
inline constexpr double kSameMinimum_rad = 0.1;
inline constexpr double kRankingTolerance = 1e-4;  ///< relative, of descents that only rank starts
/// Evaluations of a quick descent from a start; with 25 (and 5 screening iterations) seed 2 of the
/// synthetic recordings had 471 frames above the best sequence instead of 267 (commit a13d009b).
inline constexpr int kMaxQuickEvaluations = 40;
inline constexpr int kMaxQuickRefinements = 10;   ///< evaluations from each of the best minima
inline constexpr int kRefinedPerKeptMinimum = 2;  ///< minima refined for each one that is kept
inline constexpr int kMaxFlips = 4;  ///< flips that are considered: at most 2^4 combinations
/// Random postures at which a symmetry must preserve the objective, and the relative difference.
inline constexpr int kSymmetryTestPostures = 3;
inline constexpr double kSymmetryTolerance = 1e-6;
/// Steps of the grid of a search, powers of two: with goals and objects on it, the shipped
/// recordings turned by 14 angles get paths that differ by at most 3e-5 rad (commit 78724dc6).
inline constexpr double kGridStep_m = 0x1p-13, kGridStep_rad = 0x1p-10;
inline constexpr int kMinFrames = 5;  ///< frames of a mapped movement; third differences need four
/// Evaluations and relative tolerance of a tracked frame; joining and smoothing need no more.
inline constexpr int kMaxTrackingEvaluations = 5;
inline constexpr double kTrackingTolerance = 1e-5;
/// Equivalent postures of a minimum that are tracked until one is not stopped by a limit.
inline constexpr std::size_t kMaxEquivalentPostures = 3;
/// Iterations by which sequences are smoothed to compare their values (kMaxQuickEvaluations).
inline constexpr int kScreeningIterations = 7;
/// Number of sequences smoothed until convergence (commit 319cb910); repair changes the others.
inline constexpr int kFullySmoothedCount = 2;
/// Factors on the relative tolerance: to compare sequences, and over all frames.
inline constexpr double kComparisonToleranceFactor = 10, kFineToleranceFactor = 10;
/// The same for the path that is taken. The elbow's circle is a flat valley: a solver that stopped
/// earlier left two recordings of one motion up to 20 mm apart. Same joints for 26 instead of 18 of
/// 30 noisy and resampled reaches (xarm7_leap), 23 instead of 20 (pa10_dlr_hit2); five times the
/// iterations gave no more on the latter.
inline constexpr double kPolishingToleranceFactor = 1e-2;
/// Divisor of the iterations over all frames, which start from the coarse grid; 2 remain at least.
inline constexpr int kFineIterationsDivisor = 2;
/// The person at rest: segments of an adult's arm and the tips of a hand that is about to grasp, in
/// a right hand's frame: the means of the shipped recordings at their begin, rounded.
inline constexpr double kRestUpperArm_m = 0.27, kRestForearm_m = 0.25;
inline const Vec3 kRestThumbTip_m(0.02, 0.06, 0.10), kRestIndexTip_m(0.02, 0.01, 0.15);
/// At rest the upper arm hangs and the forearm is raised by 46 degrees: from a level forearm the
/// larger hand of a robot would begin below the table. For the reach the upper arm is 40 degrees
/// forward and the forearm 17 degrees above level.
inline constexpr double kRestForearmRise_rad = 0.8;
inline constexpr double kReachUpperArm_rad = 0.7, kReachForearmRise_rad = 0.3;
/// Steps in which the goals move from rest to a movement's first frame, and evaluations of each;
/// the share of the cost of velocity with which a posture is held near the one before.
inline constexpr int kRestSteps = 12, kMaxRestEvaluations = 60;
inline constexpr double kRestNearness = 0.03;
inline constexpr std::size_t kRestBranches = 4;  ///< postures at rest that are continued
/// Links of two postures, or palms, that are nearer are at the same place: several times the error
/// of angles rounded to 0.01 rad at a metre, far below the offsets of axes that do not meet.
inline constexpr double kSamePlace_m = 0.01, kSameTurn_rad = 0.01;
inline constexpr int kReferenceStarts = 128, kReferenceMinima = 8;
inline constexpr std::uint64_t kReferenceSeed = 1;  ///< of these starts
/// Weight with which the variables o follow the wrist (path_problem.hpp): they lag behind by tenths
/// of a millimetre. A stiffer one pulls at the tips for no higher correlation of the speeds (by
/// hand, on the shipped recordings). Their bound is beyond any arm.
inline constexpr double kWristFollowing_per_m2 = 8000, kLargestWristOffset_m = 100;
inline constexpr double kHoldWeight_per_rad2 = 1e6;  ///< holds a frame: exceeds all its terms
inline constexpr double kReSolvedChange_rad = 1e-4;  ///< above it a frame counts as re-solved
inline constexpr double kMetTolerance_m = 1e-3;  ///< tip error below which a frame's goal is met
inline constexpr int kMaxIkSteps = 12;           ///< iterations of damped least squares
/// Frames are judged in rounds, each twice as dense as the previous one: the middle of an
/// unreachable interval, at which the error is largest, is likely to prove the rest unreachable.
inline constexpr int kInitialStride = 16;
inline constexpr int kStartsDivisor = 8;  ///< of the random starts near an unreachable frame
inline constexpr double kSameValueTolerance = 1e-4;   ///< relative, of values of one minimum
inline constexpr int kMinRepeatedMinima = 8;          ///< descents to the least value that suffice
inline constexpr double kFirstStepsTolerance = 1e-2;  ///< relative, of a descent's first steps
/// Ratio to the least value above which a descent ends after its first steps (commit 7ffcaff5).
inline constexpr double kAbandonValueRatio = 2;
inline constexpr double kNearestErrorTolerance = 1e-6;       ///< relative; errors are only reported
inline constexpr double kCoincidentHinges_m = 1e-6;          ///< closer hinges count as one
inline constexpr double kFingerPositionWeight_per_m2 = 1e4;  ///< a centimetre counts as one
inline constexpr double kFingerLength_m = 0.1;  ///< turns a joint's error [rad] into a tip's [m]
inline constexpr int kMaxWristJoints = 2;  ///< joints that move the palm of a robot without an arm

}  // namespace morphe::map
