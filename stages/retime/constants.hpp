#pragma once

/// Numbers that decide a result; those without a reason here were chosen by hand, not measured.
/// u is the path parameter, w the ramped one (squared_velocity.hpp), x = (du/dt)^2 or (dw/dt)^2.
/// The grid law is the fastest law without jerk limits (reachability.hpp).
namespace morphe::retime {

inline constexpr double kKnotStep_s = 0.01;      ///< largest spacing of the path spline's knots
inline constexpr double kMaxDuration_s = 3600;   ///< longer trajectories would need too much memory
inline constexpr double kMaxPeriodCount = 1e12;  ///< larger numbers of periods are clamped to this
inline constexpr double kMaxPathVelocity = 1e4;  ///< upper bound of du/dt
inline constexpr double kLimitInset_rad = 1e-7;  ///< the spline stays this far inside joint limits
inline constexpr double kLimitRounding_rad = 1e-4;  ///< excesses of samples up to this are accepted

// Correction of laws whose quintics exceed a limit.
inline constexpr int kMaxCorrections = 12;  ///< rounds of slowing down, and of stretching
/// Corrections slow down by this share more than necessary.
inline constexpr double kLimitMarginRatio = 5e-4;
inline constexpr int kSlowdownMarginKnots = 4;  ///< knots slowed down on each side of an excess

// Path parameter.
/// Recorded steps faster than this multiple of the joints' full speed are stretched to it in u; up
/// to it, the time law slows them down.
inline constexpr double kMaxRecordedSpeedRatio = 4;
inline constexpr double kPauseSpeedRatio = 0.02;       ///< share of full speed that is a pause
inline constexpr double kMaxJointSpeed_rad_s = 100;    ///< largest full speed that is assumed
inline constexpr double kMinBrakingSpeedRatio = 1e-3;  ///< least braking speed over velocity limit

// Fit of the spline.
/// Factor on the tolerances of smoothing while the target is held: tips that are off by 0.05 mm at
/// most move the pads in the hand by 0.1 mm, of the 0.5 mm that are allowed.
inline constexpr double kHeldSmoothingFactor = 0.25;
inline constexpr int kMaxRounds = 30;            ///< fits with rising sample weights
inline constexpr int kRoundsBeforeRelaxing = 6;  ///< later rounds also reduce roughness weights
inline constexpr double kRoughnessReductionRatio = 0.5;  ///< per round, at samples out of tolerance
inline constexpr int kMaxStepHalvings = 2;  ///< of the knot step, if a fit is out of tolerance
inline constexpr double kEndWeight = 1e5;   ///< of the first and the last sample
inline constexpr double kMinSampleWeight = 0.02;  ///< of samples much closer than the knots
inline constexpr double kMaxSampleWeight = 1e8;   ///< raised no further: rounding would dominate
inline constexpr double kMinWeightGrowth = 2, kMaxWeightGrowth = 100;  ///< of a sample, per round
/// Least ratio of adjacent weights; a single large one would only make the curve oscillate.
inline constexpr double kMinNeighbourWeightRatio = 0.1;
/// A curve point pulled onto a joint's limit weighs kLimitWeight times the largest sample weight
/// nearby, which counts as at least kMinLimitSampleWeight; at most kMaxLimitWeight in all.
inline constexpr double kLimitWeight = 100;
inline constexpr double kMinLimitSampleWeight = 10, kMaxLimitWeight = 1e10;
inline constexpr double kMinRoughnessWeight = 1e-8, kMaxRoughnessWeight = 1e6;  ///< for precision
inline constexpr double kLinearizationShare = 0.98;  ///< of a tip's tolerance, for linear errors
inline constexpr double kMinSmoothing_s = 0.003;     ///< if both tolerances are below kMinTolerance
inline constexpr double kMinTolerance = 1e-5;        ///< replaces smaller tolerances [m or rad]
inline constexpr int kMaxPulls = 20;                 ///< rounds of pulling points onto the limits

// Ends of the spline.
inline constexpr int kFlatKnots = 5;  ///< coefficients that move as far as the end, a mean of five
inline constexpr int kFadeKnots = 25, kMinFadeKnots = 5;  ///< knots over which a move fades out
inline constexpr double kRestTolerance_rad = 1e-4;  ///< coefficients closer to the end are at rest

// Time laws.
inline constexpr double kRamp_s = 0.25;             ///< length in w of the ramp at both ends
inline constexpr double kMaxRampVelocityRatio = 8;  ///< largest dw/dt over the grid law's du/dt
/// Largest speedup, of the nominal velocity; largest delay to recover, of the path's duration.
inline constexpr double kMaxSpeedupShare = 0.4, kMaxRecoverableDelayShare = 0.05;
inline constexpr double kSpeedupTime_s = 0.2;  ///< time within which a delay is to be recovered
inline constexpr int kSpeedupRounds = 4;       ///< time laws computed to find the speedups
inline constexpr double kMinEndSpeedupStep = 1e-3;  ///< added to each rise of the end speedup
/// A cell slower than this share of its nominal velocity counts as held back by the robot's limits.
inline constexpr double kAtVelocityCapRatio = 0.98;
inline constexpr int kMaxPathVelocityCount = 11;  ///< nominal velocities tried for a given duration
inline constexpr double kPathVelocityExcessRatio = 1.01;  ///< factor on the estimate of the next
inline constexpr int kMinGridSteps = 400, kStepsPerKnot = 4, kMinKnots = 32;
inline constexpr double kEndTolerance_s = 1e-9;  ///< samples closer to the end get the last phase

// Reachability and jerk.
inline constexpr double kMinSlope = 1e-12;  ///< least |p| in |p a + r x| <= 1 with a = x_u / 2
inline constexpr int kRootSteps = 60;       ///< Newton steps to the largest x with a feasible a
/// Barrier weights over the duration per point; the final one bounds the excess over the optimum.
inline constexpr double kInitialBarrierShare = 3e-1, kFinalBarrierShare = 3e-5;
inline constexpr double kBarrierReductionRatio = 0.1;  ///< factor from one weight to the next
inline constexpr int kBarrierSteps = 60;  ///< largest number of Newton steps per barrier weight
/// Line search: least step, and decrease required as a share of the predicted one.
inline constexpr double kMinStepLength = 1e-6, kMinDecreaseShare = 0.05;
/// Converged if the Newton decrement is below this × barrier weight × number of points.
inline constexpr double kConvergedDecrementShare = 0.1;
inline constexpr int kEndIntervals = 8;  ///< at each end, with four points each; others have two
/// Knots to both sides over which the first iterate is a mean; thrice as many for its minimum.
inline constexpr int kStartWindowKnots = 12;
/// First iterate over the largest constant x; factor until it is feasible; least factor in total.
inline constexpr double kStartRatio = 0.9, kStartReductionRatio = 0.7, kMinStartRatio = 1e-3;
inline constexpr int kCellsPerKnot = 4;              ///< cells over which the time is integrated
inline constexpr int kMaxInversionSteps = 8;         ///< Newton steps to find w at a time
inline constexpr double kInversionTolerance = 1e-8;  ///< last step / cell; the error is its square

}  // namespace morphe::retime
