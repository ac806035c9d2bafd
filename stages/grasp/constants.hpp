#pragma once

#include "core/motion/geometry.hpp"

/// The numbers that decide a grasp and are no options: chosen by hand, not measured.
namespace morphe::grasp {

inline constexpr double kClosingStep_rad = 0.01;  ///< step of the closing joints
/// Opening beyond which a finger that begins inside the target is given up.
inline constexpr double kMaxOpening_rad = 0.5;
/// Step by which a finger that cannot close is abducted, twice to either side.
inline constexpr double kAbductionStep_rad = 7 * kRadPerDegree;
inline constexpr double kContactTolerance_m = 1e-5;  ///< largest gap at which a closing pad touches
inline constexpr double kMinLeverRatio = 0.2;  ///< of a joint that closes, to the longest lever

inline constexpr int kMaxSeparationRounds = 50;      ///< rounds in which contacts move apart
inline constexpr double kOverlapTolerance_m = 1e-4;  ///< overlap of two pads that remains
inline constexpr double kReleaseDuration_s = 0.3;    ///< over which the contacts are released

inline constexpr double kMaxContactGap_m = 0.002;  ///< between a pad and the surface it touches
/// Volume of a mesh, relative to the cube of its radius, up to which it counts as zero.
inline constexpr double kMinVolumeRatio = 1e-6;
/// Share of the requested force below which there is no squeeze, and from which it is enough.
inline constexpr double kMinGraspForceRatio = 0.05, kSufficientForceRatio = 0.5;
inline constexpr double kMaxResidualRatio = 1e-3;  ///< unbalanced force over the largest force
/// Share of the friction cone that forces may use: at first, relaxed, and as the last resort.
inline constexpr double kFrictionUse = 0.7, kRelaxedFrictionUse = 0.95, kFullFrictionUse = 1;

}  // namespace morphe::grasp
