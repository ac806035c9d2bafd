#pragma once

namespace morphe::solve {

// Numbers that decide a result and are no options, chosen by hand unless a comment names a reason.

// --- trust_region.cpp: one frame; a radius bounds the change of each variable
inline constexpr double kInitialRadius_rad = 0.1, kMaxRadius_rad = 0.5;
/// Steps up to this factor longer than the radius are taken as they are.
inline constexpr double kRadiusExcessFactor = 1.5;
/// Share of the predicted decrease that a step must attain to be accepted, and to widen the radius.
inline constexpr double kMinDecreaseShare = 1e-4, kWideningDecreaseShare = 0.5;
inline constexpr double kRadiusFallFactor = 4;  ///< divides the radius on a return
inline constexpr double kRadiusRiseFactor = 2;  ///< widened radius over the step's largest change
/// Consecutive steps that may increase the value before the search returns to the checkpoint.
inline constexpr int kMaxUphillSteps = 3;
/// Damping of every step relative to the largest curvature: without it, directions of zero
/// curvature would amplify round-off. A last step's damping up to kNoDampingRatio counts as 0.
inline constexpr double kMinDampingRatio = 1e-12, kNoDampingRatio = 1e-6;
/// A step begins with the last step's damping divided by this: measured, together with the
/// corrections below, a fifth more frames planned per second (CHANGELOG).
inline constexpr double kLastDampingDivisor = 30;
/// Multiples of the damping itself, of the least missing damping, and of the last step's damping;
/// the largest of them is the next damping if the damped Hessian is indefinite.
inline constexpr double kDampingGrowth = 3, kMissingDampingFactor = 2, kLastDampingShare = 0.3;
inline constexpr int kMaxDampings = 40;                 ///< attempts per step
inline constexpr int kActiveSetChangesPerVariable = 3;  ///< at most, per step

// --- minimise_movement.cpp: the damping of each frame of a movement
inline constexpr double kInitialFrameDamping = 3, kMinFrameDamping = 1e-6, kMaxFrameDamping = 1e12;
/// Accepted steps divide a damping above kNeededDampingFactor times the needed one by kDampingFall.
inline constexpr double kNeededDampingFactor = 4, kDampingFall = 5;
/// Greatest factor on a frame's damping after an accepted step; least and greatest if rejected.
inline constexpr double kAcceptedRise = 2, kMinRejectedRise = 2, kMaxRejectedRise = 1000;
/// Factor on every frame's damping if no frame's model was wrong, and if there was no step at all.
inline constexpr double kCommonRise = 4, kNoStepRise = 8;
/// A step is corrected for the first time if it attains less than kMinGainRatio of the predicted
/// decrease; again while the value rises, by at most kMaxLossRatio times the predicted decrease.
inline constexpr double kMinGainRatio = 0.7, kMaxLossRatio = 10;
inline constexpr int kMaxCorrections = 3;
inline constexpr int kSmallStepsToConverge = 2;  ///< consecutive ones below the tolerance
/// Least curvature of a correction, in the unit of the objective per rad².
inline constexpr double kMinCorrectionCurvature = 10;

// --- movement_step.cpp: one damped step of a movement
inline constexpr int kMaxActiveSetChanges = 3;  ///< per step
/// A step that exceeds bounds by at most this is clamped; otherwise the active set changes.
inline constexpr double kBoundTolerance_rad = 1e-4;
/// Curvature given to directions of negative curvature, relative to the largest.
inline constexpr double kMinCurvatureRatio = 1e-9;
/// Longest step of a valid frame model; only steps longer by the factor are damped more.
inline constexpr double kMaxFrameStep_rad = 0.5, kFrameStepExcessFactor = 1.5;
inline constexpr int kMaxLongStepDampings = 5;

}  // namespace morphe::solve
