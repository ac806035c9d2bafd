#pragma once

#include <array>

/// Numbers that decide a result; those without a reason here were chosen by hand, not measured.
namespace morphe::repair {

/// Largest excess of a path that is nearly free [m or rad]: a re-solve recovers about a centimetre.
inline constexpr double kNearlyFreeExcess = 0.01;
/// A candidate fails at the same place as the best path if its excess is at least this share.
inline constexpr double kSameExcessRatio = 0.8;
/// Candidates that fail at the same place before the search ends. Gain in time and loss in value
/// were measured (CHANGELOG: "repair stops at the fourth course").
inline constexpr int kMaxRepeatedFailures = 4;
/// Shares of the extra clearance, tried in order until both ends of an interval are free.
inline constexpr std::array kExtraClearanceShares{1.0, 0.3, 0.1};
/// Less clearance is tried if the ends moved apart by more than this multiple of the widening.
inline constexpr int kLongIntervalWidenings = 4;
/// Widening of the planner's box around the original path, by attempt, in shares of a joint's span.
inline constexpr std::array kBoxShares{0.1, 0.3, 1.0};
inline constexpr int kIntervalTimeCount = 5;  ///< instants at which moving objects are checked
inline constexpr double kRestPoseTolerance = 1e-9;  ///< relative change of a resting object's pose
/// The permitted penetration loses this share of the extra clearance, at most this share of itself.
inline constexpr double kMaxPenetrationLossRatio = 0.5;
/// Extra clearance within the hand, a reserve for smoothing: without it the smooth curves of
/// approaches fell below the certifiable clearance.
inline constexpr double kMaxExtraHandClearance_m = 2e-4;
/// Planner iterations up to which trees are searched linearly; in larger trees this is too slow.
inline constexpr int kMaxLinearSearchIterations = 20000;
/// Smallest length of the following joints' dimension, in shares of a joint's span.
inline constexpr double kMinFollowLength = 1e-3;
/// Steps towards the best correction, as shares of its distance, tried in order.
inline constexpr std::array kPullShares{1.0, 0.5, 0.25, 0.1};
/// Length L of the smoothing cost as a share of the interval, and its smallest value in samples.
inline constexpr double kSmoothingRatio = 0.125, kMinSmoothingLength = 2;
/// Half the size of a window is that of the interval, halved 1 to 4 times.
inline constexpr int kMaxWindowHalvings = 4;
inline constexpr double kMaxTransitStep_rad = 0.02;  ///< between samples of a transit
inline constexpr double kTransitPeriod_s = 0.01;     ///< spacing of their time labels
inline constexpr int kMinTransitSamples = 21;        ///< plus one for each vertex

}  // namespace morphe::repair
