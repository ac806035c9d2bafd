#pragma once

#include <cstddef>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

// The numbers of this folder that decide a guess. All were chosen by hand and not measured, except
// where a comment names a measurement or a reason. The weight of a cue stands with the cue in
// body_cues.cpp, the usual length of a body part with the part in unit_guess.cpp.

// Directions of the body (body_cues.cpp). In nine trials of five people at a table, a resting hand
// is 8 to 26 degrees outside of straight ahead of its shoulder, the fingers point inwards by 7 to
// 28 degrees, and a shoulder is 20 to 32 degrees behind the side of the breastbone.
inline constexpr double kRestHandAzimuth_rad = 15 * kRadPerDegree;
inline constexpr double kFingersInward_rad = 12 * kRadPerDegree;
inline constexpr double kShoulderBehind_rad = 25 * kRadPerDegree;
inline constexpr double kRestRadiusRatio = 0.25;  ///< to the largest distance from the start

// Heading (heading.cpp)
inline constexpr double kMinCueAgreement = 0.6;  ///< HeadingEstimate::agreement of usable cues
/// Least product of the horizontal lengths of a cue's two vectors, if the cue is named as a reason.
inline constexpr double kMinHorizontalProduct = 0.2;
/// Least |mean| / mean |·| of the horizontal vectors between the shoulders of one heading.
inline constexpr double kConstantHeadingRatio = 0.8;
inline constexpr double kInitialInterval_s = 1;  ///< gives the heading of a person who turns
inline constexpr double kLargeYaw_rad = 45 * kRadPerDegree;  ///< reported in other words if larger

// Axes (axes_guess.cpp). The agreement of axes is the weighted mean of the cosines of all cues.
inline constexpr double kMinCueCosine = 0.7;  ///< of a cue that is named as a reason
inline constexpr double kSureMargin = 0.2, kLikelyMargin = 0.08;  ///< over the second best axes
inline constexpr double kMinAgreement = 0.6;                      ///< of axes that are sure

// Unit and rate (unit_guess.cpp)
/// Largest root mean squares of ln(length / usual length) of a sure and a likely unit: 25 and 57 %.
inline constexpr double kSureMisfit = 0.22, kLikelyMisfit = 0.45;
inline constexpr double kUsualExtent_m = 1;  ///< of all points: of one reach, half a metre or more
inline constexpr double kUsualRates_hz[] = {30, 60, 100, 120, 200, 240};
inline constexpr double kReachSpeed_m_s = 1;        ///< of a hand at its fastest
inline constexpr std::size_t kFastPercentile = 95;  ///< of the speeds; faster ones may be outliers

// Names (point_guess.cpp, recorded_name.cpp, unresolved_import.cpp)
inline constexpr int kMinClusterMarkers = 3;       ///< a rigid body needs three
inline constexpr int kHandPointCount = 21;         ///< wrist and four joints of each finger
inline constexpr std::size_t kMaxSplitBytes = 24;  ///< longer pieces take too long to split
inline constexpr std::size_t kMaxDigits = 6;       ///< longer numbers might not fit into an int

// Limits that no recording of a person's arm exceeds (plausibility.cpp)
inline constexpr double kMaxCoordinate_m = 1000, kMaxAngle_rad = 6 * std::numbers::pi;
inline constexpr double kMaxDuration_s = 6 * 3600, kMaxTimeStep_s = 600;

}  // namespace morphe::imports
