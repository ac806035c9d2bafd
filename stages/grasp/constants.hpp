#pragma once

#include "core/motion/geometry.hpp"

/// The numbers that decide a grasp and are no options: chosen by hand, not measured.
namespace morphe::grasp {

inline constexpr double kClosingStep_rad = 0.01;  ///< step of the closing joints
/// Opening beyond which a finger that begins inside the target is given up.
inline constexpr double kMaxOpening_rad = 0.5;
/// Steps by which a closing finger is abducted, and by which its outer joints turn faster or slower
/// than its inner ones, twice to either side, until it touches within kGoodPadAngle_rad.
inline constexpr double kAbductionStep_rad = 7 * kRadPerDegree, kCurlStep = 0.5;
inline constexpr double kGoodPadAngle_rad = 25 * kRadPerDegree;
/// Number of postures in which the motion of a closing finger is checked, the last one included.
inline constexpr int kClosingChecks = 10;
inline constexpr double kContactTolerance_m = 1e-5;  ///< largest gap at which a closing pad touches
inline constexpr double kMinLeverRatio = 0.2;  ///< of a joint that closes, to the longest lever

inline constexpr int kMaxSeparationRounds = 50;      ///< rounds in which contacts move apart
inline constexpr double kOverlapTolerance_m = 1e-4;  ///< overlap of two pads that remains
/// Distance of the pads from a released target [m]: as far as servos that lag do not touch it.
inline constexpr double kLeavingGap_m = 0.01;
inline constexpr double kReleaseDuration_s = 0.3;  ///< over which the contacts are released

/// Largest gap between a pad and the surface that it touches, and the largest angle between the
/// middle of the pad and the surface's normal. With a larger gap it presses on air, and with a
/// larger angle the finger touches with its side or its nail.
inline constexpr double kMaxContactGap_m = 2e-4, kMaxContactAngle_rad = 60 * kRadPerDegree;

/// Largest motion of the pads in the hand that carries the target.
inline constexpr double kMaxHeldDrift_m = 5e-4, kMaxHeldTurn_rad = kRadPerDegree;

// The posture at the grasp, in which contacts slide along the surface (SurfaceContactTerm).
/// Largest distance of a contact from the point that the person touched [m].
inline constexpr double kMaxSlide_m = 0.015;
/// Weight of a gap [1/m²]: 400 times the default of map.tip_position, so that neither the pull
/// towards the person's point nor the pad's direction opens a gap: 0.1 to 0.2 mm remained at 4e6.
inline constexpr double kGapWeight = 1.6e7;
/// Weight of the squared chord between the middle of the pad and the normal. A tilt of 12 degrees
/// then costs as much as a slide of 21 mm. On the shipped drinks, pads of the DLR/HIT II slid by
/// 2 mm with 25 and remained 17 degrees off, with 200 by 9 mm and 11 degrees, with 400 by 11 mm and
/// 7 degrees.
inline constexpr double kPadDirectionWeight = 400;
inline constexpr double kNormalStep_m = 0.001;  ///< of the central difference of normals

/// Volume of a mesh, relative to the cube of its radius, up to which it counts as zero.
inline constexpr double kMinVolumeRatio = 1e-6;
/// Share of the requested force below which there is no squeeze, and from which it is enough.
inline constexpr double kMinGraspForceRatio = 0.05, kSufficientForceRatio = 0.5;
inline constexpr double kMaxResidualRatio = 1e-3;  ///< unbalanced force over the largest force
/// Share of the friction cone that forces may use: at first, relaxed, and as the last resort.
inline constexpr double kFrictionUse = 0.7, kRelaxedFrictionUse = 0.95, kFullFrictionUse = 1;

}  // namespace morphe::grasp
