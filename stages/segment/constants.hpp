#pragma once

namespace morphe::segment {

// Numbers that decide a result and are no options, chosen by hand unless a comment names a reason.

// Signals (signals.cpp, noise.cpp)
inline constexpr int kMinFrames = 10;   ///< a shorter recording has no signals
inline constexpr int kSlopeFrames = 5;  ///< over which the velocity beside a gap is measured
inline constexpr double kMaxNoiseShare = 0.02;  ///< tolerated noise, as a share of travel_speed()
inline constexpr double kWideningFactor = 1.5;  ///< by which each attempt widens the Gaussian
inline constexpr double kMaxWideningFactor = 4;
inline constexpr double kNoiseWindow_s = 0.25;
inline constexpr int kMinNoiseWindowFrames = 4;   ///< a line fit needs more than two
inline constexpr double kQuietWindowShare = 0.1;  ///< share of the windows taken to be at rest

// Movement units (movement_units.cpp, movement_unit.cpp)
inline constexpr double kMinPeakNoiseRatio = 4;  ///< least speed peak over the rms noise
/// Least peak speed of a unit that can be merged with another, as a share of min_peak_speed.
inline constexpr double kMinPartSpeedShare = 0.2;
inline constexpr double kSeparatingDipShare = 0.15;  ///< ratio of dip to peak that always separates
inline constexpr double kMinUnitDuration_s = 0.08;
inline constexpr double kMaxMergeGap_s = 0.1;       ///< longest dip of the speed within a unit
inline constexpr double kSplitHalfWindow_s = 0.15;  ///< around an object's begin or end of motion
inline constexpr int kWeakNeighbours = 2;  ///< units on either side whose extent is compared
/// Standard deviation of a boundary's time that halves its confidence.
inline constexpr double kHalfConfidenceSpread_s = 0.04;
/// Interval outside a boundary in which a rise of the speed lowers its confidence. Of the synthetic
/// boundaries off by more than 60 ms, one in nine has a confidence above 0.95; without it, half.
inline constexpr double kReboundWindow_s = 0.3;

// Boundaries from the flank of the speed (speed_crossing.cpp)
inline constexpr double kMinLevelNoiseRatio = 2;  ///< least level measured directly, over the noise
inline constexpr double kMaxLevelPeakShare = 0.5;  ///< bound of that level, as a share of the peak
inline constexpr double kFlankPeakShare = 0.35;    ///< fitted height of a flank, of its own peak
inline constexpr double kMinFlankFrames = 3;       ///< a line through two has no residual
inline constexpr double kMaxExtrapolation_s = 0.15;  ///< of a boundary, by the fit
inline constexpr double kPeakFallShare = 0.8;        ///< a flank ends at this share of its own peak

// Fingers (aperture.cpp, finger_motion.cpp, grasp.cpp)
inline constexpr double kMinApertureNoiseRatio = 3;  ///< of a change to the rms of the noise
inline constexpr double kMinWristShare = 0.25;       ///< of the tip's displacement, in a reach
inline constexpr double kMinApertureShare = 0.5;  ///< the same of the aperture, if fingers move it
inline constexpr double kChangeWindow_s = 0.1;    ///< half before, half after
/// Least change in kChangeWindow_s, as a share of the least total change.
inline constexpr double kLocalChangeShare = 0.2;
inline constexpr double kClosingDelay_s = 0.1;          ///< after arrival, for the hand to close
inline constexpr double kMaxPauseClosingShare = 0.5;    ///< of the closing, in a pause of the reach
inline constexpr double kDefaultGraspDuration_s = 0.3;  ///< if no unit follows the reach
/// Greatest displacement of the wrist relative to that of the object in the hand.
inline constexpr double kMaxWristObjectRatio = 2;

// Arrival of a hand that goes on at the place (arrival.cpp)
inline constexpr double kArrivalShare = 0.25;   ///< of the peak speed
inline constexpr double kOccupiedShare = 0.35;  ///< as SegmentOptions::dip_share
inline constexpr double kMinOccupied_s = 0.3;   ///< a correction on the way is shorter

// Second visits of a place (come_back.cpp)
inline constexpr double kTurnHalfWindow_s = 0.1;   ///< around a minimum of the speed
inline constexpr double kTurnWindow_s = 0.25;      ///< over which directions are compared
inline constexpr double kMaxTurnCosine = 0.5;      ///< of a turn by 60 degrees
inline constexpr double kPeakWindow_s = 0.5;       ///< in which the speed is higher on both sides
inline constexpr double kMaxTurnSpeedShare = 0.9;  ///< of the smaller one of these peaks
inline constexpr double kComingWindow_s = 1.5;     ///< in which a hand comes and leaves
inline constexpr double kMinPassingScore = 0.5;

// Evidence for a grasp (grasp_evidence.cpp, grasp_place.cpp): log-odds, see docs/steps/segment.md.
// Chosen by hand, kLaterPlace, kNearRatio and kFarRatio after random combs had shown grasps: the
// tests find at least 97 % of random drinks, closing by 5 to 60 mm with and without a stop, and
// invent no grasp in 900 random combs and touches.
inline constexpr double kGraspPrior = -1;  ///< of any reach
inline constexpr double kStatedTask = 2;   ///< of a task that takes an object, or touches
inline constexpr double kComeBack = 3;     ///< if the hand comes back exactly to the place
/// How far the hand has to go away in between, over the displacement of the reach.
inline constexpr double kNearRatio = 0.2, kFarRatio = 0.6;
inline constexpr double kNoComeBack = -0.5;  ///< it may leave the object elsewhere
inline constexpr double kNoTransport = -2;   ///< the hand goes home, or rests for kLongRest_s
inline constexpr double kHeadOdds = -4;      ///< there is no object in the hair
inline constexpr double kLaterPlace = -1;    ///< for each unit more, or less, in the reach
inline constexpr double kLongRest_s = 0.5;
inline constexpr double kTailShare = 0.1;  ///< of an aperture's values left out at either end
inline constexpr double kSmallOpeningShare = 0.15;      ///< neutral change, of the aperture
inline constexpr double kClearClosingShare = 0.5;       ///< of the opening
inline constexpr double kApertureResolution_m = 0.001;  ///< two markers on skin
inline constexpr double kNeutralRigidity = 2.5;  ///< ratio of the ranges of free and closed hand
inline constexpr double kMaxRigid = 1.5, kMaxFlexible = 2.5;
/// Height above the shoulder, and horizontal distance from it, over the length of the arm.
inline constexpr double kBelowHead = -0.1, kAtHead = 0.2, kBesideHead = 0.5, kAwayFromHead = 0.8;

// Recorded objects (objects.cpp, interaction.cpp)
/// Within this time a moving object travels farther than min_object_displacement.
inline constexpr double kLookAhead_s = 0.2;
inline constexpr double kMaxHandDistance_m = 0.1;    ///< of hand and object that move together
inline constexpr double kHandLength_m = 0.18;        ///< from the wrist to the fingertips
inline constexpr double kMotionHalfWindow_s = 0.1;   ///< over which their motions are compared
inline constexpr double kMaxSlipShare = 0.5;         ///< their difference over the displacement
inline constexpr double kMinDisplacement_m = 0.002;  ///< in twice kMotionHalfWindow_s
inline constexpr double kMaxHeldWidth_m = 0.15;      ///< that a hand can span
/// Greatest gap to the surface of both tips together: a tip is on the finger's axis.
inline constexpr double kMaxTipGap_m = 0.05;
inline constexpr double kMinCommonMotion_s = 0.1;  ///< of an object and the hand that moves it
/// Difference up to which an object's motion keeps its own begin and end, instead of the hand's.
inline constexpr double kOnsetTolerance_s = 0.2;
/// Two intervals are the same event if they overlap by more than this share of the shorter one.
inline constexpr double kMinOverlapShare = 0.5;

// Phases of a task (task_phases.cpp), chosen by hand
inline constexpr double kLiftHeight_m = 0.02;  ///< of a thing in the air: above noise and tilt
inline constexpr double kReleaseDistance_m =
    0.01;  ///< of the wrist: the hand leaves, not only opens

// Movements (cycles.cpp, segment.cpp): scores, as cycles.hpp explains them
inline constexpr int kMaxUnitsPerMovement = 12;
inline constexpr int kTruncatedPeakFrames = 2;  ///< a peak so near to a cut may not be the unit's
inline constexpr double kMovementScore = 0.25;  ///< for any movement
inline constexpr double kMissingReachScore = -0.1;  ///< for a movement without its reach
inline constexpr double kObjectMovedScore = 1, kGraspScore = 0.5, kNoGraspScore = -0.5;
inline constexpr double kOutwardScore = 1, kApproachScore = 0.25, kSkipPenalty = 1;
inline constexpr double kMaxApproachRatio = 0.5;  ///< of the object's distances after and before
/// A unit cut off by the recording's end heads home if its distance from home falls below this
/// share.
inline constexpr double kMaxHomingRatio = 0.5;

}  // namespace morphe::segment
