#pragma once

#include <cstddef>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

// The limits of the audit's checks, a section for each file. docs/audit.md has the reason of each.

// Chirality (chirality.cpp). Agreement of the body with the best left-handed axes minus that with
// the best right-handed ones: -0.19 to -0.60 in 26 recordings of 12 people, and as much above 0 if
// they are mirrored; less if the pose tells neither (a wheelchair's push: -0.06).
inline constexpr double kMirroredMargin = 0.1;
inline constexpr double kMirroredAgreement = 0.7;  ///< of mirrored bodies 0.81 to 0.97
/// Displacement of the tips of thumb and fingers to the palm's side of the plane of the hand [m]: 7
/// to 60 mm in 18 hands, -10 mm in one whose fingers are stretched.
inline constexpr double kMirroredHand_m = 0.025;

/// The same of an arm without trunk and plane of the hand. In 15 trials of five people at a table
/// the thumb's tip is 62 to 100 mm inside of the index finger's, in 40 synthetic reaches 22 to 60
/// mm; the elbow is 16 mm inside to 90 mm outside. If mirrored, both have the other sign.
inline constexpr double kMirroredThumb_m = 0.015, kMaxMirroredElbow_m = 0.05;

// Vertical (vertical.cpp). In 26 recordings of 12 people at a table or walking, the body's vertical
// is 1 to 14 degrees from the vertical axis while the hand rests, and the line between the
// shoulders 0 to 5 degrees from the horizontal.
inline constexpr double kMaxTilt_rad = 22 * kRadPerDegree;
/// Without the trunk, as the arm's own posture gives it: up to 24 degrees in 12 single arms.
inline constexpr double kMaxArmTilt_rad = 35 * kRadPerDegree;
/// Of the upper arm from the vertical: 20 to 45 degrees in these trials, at rest and in motion.
/// Chosen by hand below a horizontal one.
inline constexpr double kMaxUpperArm_rad = 80 * kRadPerDegree;
inline constexpr double kMaxShoulderSlope_rad = 10 * kRadPerDegree;
/// Agreement of a body whose pose gives its vertical; 0.81 to 0.97 in those, 0.6 in a wheelchair.
inline constexpr double kMinVerticalAgreement = 0.75;

// Scale (scale.cpp). The recordings of 13 people have 0.76 to 1.1 of the usual size. The limits are
// a child of 0.9 m and more than the largest adult, half-way to these people in cm instead of in,
// 0.30 to 0.43, and in in instead of cm, 1.9 to 2.8.
inline constexpr double kMinRelativeSize = 0.5, kMaxRelativeSize = 1.6;
/// Flagged; chosen by hand: a person of 2.1 m has 1.2 of the size of one of 1.75 m. The largest of
/// these people has 1.1. Not of sensors, which are far from the joints: up to 1.27 of synthetic
/// ones.
inline constexpr double kMaxAdultSize = 1.25;
/// Limits of one length, whose ends may be a hand's breadth from the joints; 0.45 to 1.3 were
/// measured.
inline constexpr double kMinLengthRatio = 0.35, kMaxLengthRatio = 2.5;

// Static trial (static_fit.cpp), from 16 trials of seven people and each with the static trials of
// the six others. Clusters fit their own static trial to 0.1-2.3 mm; another's plate to 9-10 mm.
inline constexpr double kMaxClusterMisfit_m = 0.004;
/// Displacements of the base of the index finger in the hand's cluster, of shoulder and elbow as
/// two clusters give them: the largest of own static trials [m].
inline constexpr double kOwnFingerBaseShift_m = 0.013;
inline constexpr double kOwnShoulderGap_m = 0.042, kOwnElbowGap_m = 0.032;
/// Sum of the three in units of these: at most 2.3 with the own static trial, 1.5 to 5.5 with
/// another's, in 58 of 66 of which it, or a cluster's misfit, exceeds its limit.
inline constexpr double kMaxLandmarkShift = 2.6;

// Objects (object_distance.cpp), chosen by hand: beyond any arm and any step, and larger than any
// room. Smaller than kMinObject_m is no thing that a hand takes.
inline constexpr double kMaxObjectDistance_m = 10;
inline constexpr double kMaxObjectSize_m = 10, kMinObjectSize_m = 0.002;

// Target (target_distance.cpp), chosen by hand: wider objects are not taken with one hand.
inline constexpr double kMaxGraspWidth_m = 0.2;
/// Distance of the nearest object from the tips in a movement without a grasp: beyond an arm's
/// length.
inline constexpr double kMaxReachObjectDistance_m = 1;

/// Frames of a recording that are enough for a median over it (sampled_points.cpp); there are up to
/// twice as many. Chosen by hand: all verdicts on 36 recordings are those of all frames.
inline constexpr std::size_t kMedianFrames = 100;

// Exchanges at a time (exchanges.cpp). Points that move by themselves miss their prediction by
// 20 m/s² over the squared step: 2 mm at 100 Hz, 22 mm at 30 Hz; markers of a cluster are 25 mm or
// more apart. Chosen by hand: the ratio.
inline constexpr double kMinExchangeJump_m = 0.008;  ///< of each point of an exchange
inline constexpr double kMaxExchangeRatio = 0.3;     ///< of the distance to the place taken
inline constexpr double kMaxPredictedGap_s = 0.05;   ///< over which a hidden point is predicted
inline constexpr double kMaxPredictedGap_frames =
    1.5;  ///< the same in files of few frames a second

// Rigid clusters (label_clusters.cpp). In 15 trials of five people, the clusters of arms and hands
// fit their static trials to 0.1 to 2.4 mm; with two markers of one cluster exchanged to 7 mm or
// more, with a marker of another part to 15 mm or more. Another person's plate fits to 9 mm.
inline constexpr std::size_t kMinClusterSize = 3;      ///< markers that make a rigid body
inline constexpr std::size_t kMaxPermutedMarkers = 5;  ///< all orders of a cluster are tried
/// Frames on which orders are compared, and on which the best of them are chosen before. Chosen by
/// hand, as are the changes that remain after the choice.
inline constexpr std::size_t kSampledFrames = 40, kFewFrames = 8, kComparedChanges = 20;
inline constexpr double kMaxMisfit_m = 0.004;   ///< of a cluster that has its own markers
inline constexpr double kMaxMisfitRatio = 0.4;  ///< of the misfits after and before
/// Spread of a cluster without a static trial, after names have changed: 4 mm where markers tremble
/// by 2 mm.
inline constexpr double kMaxSpread_m = 0.006;
/// Share of the frames that the misfit covers: half of them against a shape, which is wrong in all;
/// nine tenths without, as an arm that rests moves for a short time only.
inline constexpr double kShapeMisfitShare = 0.5, kSpreadMisfitShare = 0.9;
/// Weight of a cluster's size in its misfit without a static trial: a marker of another part is
/// 60 mm or more farther away, which counts as 6 mm. Chosen by hand.
inline constexpr double kSizeWeight = 0.1;
inline constexpr double kMinSpreadGain_m = 0.003;  ///< of the sum of misfits without a static trial
/// Largest outlier_ratio() of a cluster: a fingertip among the markers of a hand has 2.2, the
/// clusters of these trials have up to 1.4.
inline constexpr double kMaxOutlierRatio = 1.6;
/// Changes that are made one after the other, and states that are pursued after each. Chosen by
/// hand.
inline constexpr int kMaxLabelChanges = 4;
inline constexpr std::size_t kPursuedLabellings = 3;
inline constexpr double kFarCost_m = 1;  ///< puts states that fit far worse behind the others

// Joints between clusters (label_search.cpp). The two clusters at an elbow or wrist agree on its
// centre to 10 to 44 mm in these trials; a cluster turned by half a turn, which four markers near
// the corners of a rectangle allow, moves the elbow by 75 mm or more.
inline constexpr double kMaxJointMismatch_m = 0.05, kMinJointGain_m = 0.03;
inline constexpr double kJointWeight = 0.1;            ///< of the excess, against the misfit
inline constexpr double kAlternativeMisfit_m = 0.004;  ///< above the best order's: compared too

/// By how much an exchange of two whole parts has to shorten the way along the arms
/// (label_chain.cpp) [m]. In 15 trials of five people, as markers and as joints, and in 80
/// synthetic ones each exchange makes it 56 mm longer or more.
inline constexpr double kMinChainGain_m = 0.025;
/// In fewer frames a posture that is held may have the longer way; chosen by hand.
inline constexpr std::size_t kMinChainFrames = 10;

// Thumb and index finger (label_digits.cpp). In these trials the median distance of the index tip
// from the forearm's cluster exceeds that of the thumb by 20 mm or more, and never by less than
// 1 mm; both tips are 45 mm or more nearer to their own places in the static trial's hand.
inline constexpr double kMinReachMargin_m = 0.01, kMinStaticMargin_m = 0.03;

// Names over time (label_timeline.cpp). A cluster whose markers were exchanged while they were
// hidden misses its shape by 7 mm or more. Chosen by hand: the number of frames, costs and share.
inline constexpr double kMaxFrameMisfit_m = 0.006;      ///< of a cluster in one frame
inline constexpr std::size_t kMinMisfitRun = 3;         ///< frames; fewer are noise
inline constexpr double kExchangedDigitsCost_m = 0.01;  ///< against the misfit of clusters
inline constexpr double kSameCost_m = 0.001;            ///< names that fit alike differ by less
inline constexpr double kMinNamedShare = 0.05;          ///< of the frames, in which names are tried
// Movements at the edge of a recording (completeness.cpp)
/// Over which the speed at an edge is measured, and up to which a movement touches the edge: five
/// frames of the usual clock of 100 Hz, chosen by hand.
inline constexpr double kEdgeWindow_s = 0.05;
/// Greatest speed at an edge, as a share of the highest speed of the motion there. A minimum-jerk
/// reach of 0.3 m is 5 mm, the default of check.tracking_tolerance_grasp, from its end when its
/// speed has fallen to 19 %.
inline constexpr double kMaxEdgeSpeedShare = 0.2;
/// Share of its highest speed to which the speed falls between two motions; chosen by hand.
inline constexpr double kMotionEndShare = 0.5;
/// For which a hand that moves when the recording begins must rest before a movement. Until then it
/// may be in the middle of a task, whose transport looks like a reach. Measured: within the tasks
/// of 13 recordings of five people (drinking, combing) the wrist rests for up to 1.22 s.
inline constexpr double kMinRest_s = 1.5;
/// The default of segment.min_peak_speed: a slower hand rests [m/s].
inline constexpr double kMinEdgeSpeed_m_s = 0.05;
/// The same of a fingertip, which a turn of the hand moves while the wrist rests: recordings that
/// begin 0.15 s late do so at 0.16 m/s or more, whole ones at up to 0.07 m/s.
inline constexpr double kMinEdgeTipSpeed_m_s = 0.1;
// Presence of a grasp (grasp_presence.cpp)
/// Score (revisit_score()) of a second visit above which a hand that took nothing is mentioned; two
/// stops are then nearer to each other than a third of the way there. Chosen by hand.
inline constexpr double kSecondVisit = 0.5;
inline constexpr double kFrameTolerance_s = 1e-6;  ///< rounding of the time of a frame
// Steps of points (step_table.cpp). The ratios were chosen by hand between the shipped recordings,
// none of which has a flag, and damages that were made to them (docs/audit.md).
inline constexpr std::ptrdiff_t kStepWindow = 3;    ///< steps on either side in the usual step
inline constexpr std::ptrdiff_t kLocalWindow = 10;  ///< rows on either side of an outlier
inline constexpr std::size_t kMinJudgedRows = 12;   ///< fewer do not tell what is usual
inline constexpr double kMaxStepGap = 2.5;          ///< [periods] over which a step is judged
inline constexpr double kMinOutlier_m = 0.002;      ///< in one row, it moves a fingertip by 0.4 mm
inline constexpr double kOutlierPerNoise = 6;       ///< residual over the median of all
inline constexpr double kLargeShare = 0.9;          ///< of the residuals are smaller than "large"
inline constexpr double kOutlierPerLarge = 5;       ///< residual over the large one
inline constexpr double kOutlierPerLocal = 4;       ///< residual over the median around it
/// Limit of residuals that no motion explains: in the shipped recordings they reach 9 mm at 100 Hz,
/// and 19 times the large one. A thrown ball is accelerated with 100 m/s^2 and more.
inline constexpr double kMinFarOutlier_m = 0.01, kFarAcceleration_m_s2 = 100, kFarPerLarge = 20;
inline constexpr double kMaxNeighbour_m = 0.35;       ///< distance of points on one bone or plate
inline constexpr double kRigidSpread_m = 0.004;       ///< of the middle 80 % of their distances
inline constexpr double kRigidSpreadRatio = 0.04;     ///< the same over the distance
inline constexpr std::size_t kNeighbourSamples = 64;  ///< rows that decide on neighbours
inline constexpr std::size_t kMaxNeighbours = 6;      ///< that are compared with a point

// Jumps of the whole body (body_jumps.cpp); chosen by hand
inline constexpr double kMinMotionStep_m = 0.0005;  ///< in a row, of a point in motion
inline constexpr int kMinJumpingPoints = 2;
inline constexpr double kJumpingShare = 0.6;  ///< of the points that move
inline constexpr double kAlongShare = 0.7;    ///< of the squared jumps, along the motion
inline constexpr double kMinRowsLost = 1.5;   ///< of a jump along the motion
/// The same of a jump that counts only if there are several: one lost row moves the points by one
/// usual step, which a sudden turn may do once.
inline constexpr double kMinSingleRowLost = 0.7;
inline constexpr std::ptrdiff_t kMinSingleRows = 3;

// Rows that are equal or missing (held_rows.cpp, rows.cpp); chosen by hand
inline constexpr double kMinHeldJump_m = 0.002;   ///< after equal rows
inline constexpr std::size_t kMinFrozenRows = 3;  ///< fewer are called repeated
/// Step after repeated rows, in usual steps and for each of them, above which their time has
/// passed: 1 if the points catch up, 0 if the rows were added.
inline constexpr double kMinCatchUp = 0.5;
inline constexpr std::size_t kMinSilentRows = 10;  ///< equal ones, of a point that is never still
inline constexpr double kMaxEqualShare = 0.05;     ///< of the other rows of such a point
inline constexpr double kOthersMotion_m = 0.003;   ///< of another point meanwhile
inline constexpr std::size_t kMinBlockRows = 3;    ///< that repeat earlier ones
inline constexpr std::size_t kMaxNamedJumps = 3;   ///< of the body, each of which has its flag
inline constexpr double kMaxCountedRows = 100;     ///< lost ones, whose number the speeds tell

// The reconstruction's low-pass, to which spikes and jitter are related (low_pass.hpp): its usual
// cut-off; the peak of its response to an impulse over its cut-off; and the power of white noise
// that it leaves, over cut-off times period. Both are integrals of its gain.
inline constexpr double kFilter_hz = 8, kFilterPeak = 2.77, kFilterNoise = 2.08;

// Spikes and steps (jumps.cpp, point_jumps.cpp)
/// Of a point without rigid neighbours. People at a table reach 8 m/s^2, lifting a box 21.
inline constexpr double kArmAcceleration_m_s2 = 20;
inline constexpr double kOwnShare = 0.5;         ///< of a jump that the neighbours do not share
inline constexpr std::size_t kMaxSpikeRows = 6;  ///< a longer spike is two steps
inline constexpr double kMaxSpike_s = 0.25;      ///< the same
inline constexpr double kReturnRatio = 0.35;     ///< distance from the course over the spike's size
/// Of a spike behind the filter, in a fingertip and in another point. Real trials reach 1.54 and
/// 6.5 mm; the effect of smaller spikes on a plan was not measured.
inline constexpr double kMinTipSpikeLeft_m = 0.0016, kMinSpikeLeft_m = 0.007;
inline constexpr double kMaxHarmlessSpike_m = 0.016;  ///< in no trial but as a spike
inline constexpr std::ptrdiff_t kManyPoints = 3;      ///< with one spike: reported together
/// Distance from the place of another point, of points that exchange places; chosen by hand.
inline constexpr double kMinExchangeTolerance_m = 0.005, kMaxExchangeTolerance_m = 0.02;
inline constexpr double kExchangeToleranceRatio = 0.25;  ///< the same over the jump

// Jitter (jitter.cpp)
inline constexpr double kJitterWindow_s = 0.5;
inline constexpr double kQuietShare = 0.25;         ///< of the windows have less noise
inline constexpr double kMaxJitterPeriod_s = 0.04;  ///< slower streams show motion alone
/// Behind the filter. Shipped recordings reach 0.24 mm, and 0.64 mm with estimated joints; 2 mm at
/// 100 Hz leave 0.8 mm, which move a fingertip by 3 mm.
inline constexpr double kMaxMarkerJitter_m = 0.0005, kMaxEstimateJitter_m = 0.00075;
/// Of an estimated point over the median of its stream, above which the limit of markers holds.
/// Chosen by hand.
inline constexpr double kMaxJitterRatio = 4;

// Time base (time_base.cpp)
inline constexpr double kMovingShare = 0.1;           ///< of the largest speed: the hand moves
inline constexpr double kMinTempoExtent_m = 0.15;     ///< of the hand's motion, else not judged
inline constexpr double kMaxSeatedShoulder_m = 0.15;  ///< at a table it moves by 0.02 to 0.10 m
/// Root mean square. Trials at a table have 0.9 to 2.6; any recording of a person up to 47.
inline constexpr double kMaxTableAcceleration_m_s2 = 7, kMaxAcceleration_m_s2 = 150;
/// Trials at a table have 0.46 to 0.75; a minimum-jerk reach of 2.5 s has 0.22.
inline constexpr double kTableFrequency_hz = 0.65, kMinTableFrequency_hz = 0.22;
/// A hand that is quicker and stronger than both limits moves too fast: trials of seven people
/// reach 0.72 Hz and 2.5 m/s^2, synthetic ones 1.0 Hz and 3.1 m/s^2, the slowest people at three
/// times their speed 1.06 Hz and 5.1 m/s^2. A minimum-jerk reach of 0.35 m in 0.6 s has both
/// limits.
inline constexpr double kQuickFrequency_hz = 0.9, kQuickAcceleration_m_s2 = 4;
inline constexpr double kMaxTempoStep = 1.5;  ///< [periods] between rows of an even clock
inline constexpr double kTempoFilter_hz = 4;  ///< removes noise from slow motions
inline constexpr double kDoubtMargin_s =
    0.2;  ///< around gaps and other doubts: the filter's memory

}  // namespace morphe::imports
