#pragma once

#include <array>

#include "pipeline/planning/clearance_weights.hpp"

namespace morphe::planning {

// Numbers that decide results of planning a movement. Chosen by hand unless a measurement is named.

/// Clearance that repair asks of a path beyond the required one [m], because the curve through the
/// path is smoothed afterwards, and certified to 0.01 mm.
inline constexpr double kExtraMargin_m = 2e-4;

/// Distances of the second attempt for a movement whose path is free, but whose smooth curve is not
/// (plan_movement.cpp): three and two times the defaults of the config's map.clearance and repair.
inline constexpr double kFartherActivationDistance_m = 0.015, kFartherExtraClearance_m = 0.01;

/// Factors with which tips and clearance alone determine the result, to a tenth of a millimetre.
inline constexpr ClearanceWeights kStrongestWeights{30000, 0.2, 30};

// Contacts of the pads with the target.
/// Factors for the posture at the grasp: the weight of the first set of re_solve_strongly(), and
/// the distance of the second.
inline constexpr ClearanceWeights kContactPostureWeights{1000, 0.2};
/// Factors for a path with contacts: the same, and tips that keep their contacts although the pads'
/// directions and the arm pull at them: 12 times the default keeps all gaps of the shipped drinks
/// within 0.02 mm. More holds pads back from turning; chosen by hand.
inline constexpr ClearanceWeights kContactWeights{1000, 0.2, 12};
/// Weight that pulls a sliding contact to where the person touched: 5 mm count as one.
inline constexpr double kSlideWeight_per_m2 = 1 / (0.005 * 0.005);
/// Factor on map.pad_direction for a path with contacts, in which the pads' points and directions
/// agree. With 20, 50 % of the pads remained within 12 degrees on the shipped drinks, with 50 83 %.
inline constexpr double kPadDirectionFactor = 50;
/// Weight that keeps the arm where the path has it while contacts slide [1/rad²]: the fingers turn
/// the pads. Without it, the palm of the DLR/HIT II turned by 5 degrees on the shipped drinks, with
/// the weights of the mapping at that time.
inline constexpr double kContactArmWeight = 100;
/// Weight that keeps the hand's posture while it holds the target [1/rad²]: a finger that the goals
/// of all tips pull at with an error of 5 mm yields by less than 1e-4 rad.
inline constexpr double kHeldHandWeight = 1e7;
/// Weight that keeps the hand's posture on a target that is not carried [1/rad²]: more than what
/// pulls at the joint that the goal of a pad leaves free, so that the pad keeps its direction, and
/// less than a tenth of what holds the pad.
inline constexpr double kClosedHandWeight = 100;
/// Weight that keeps the arm near the frame before while it is led along with the target [1/rad²].
inline constexpr double kHeldArmWeight = 1;
/// Number of other starts from which the posture at the grasp is solved, and how far their fingers
/// are from those of the path, as a share of the way to positions spread over all limits. Another
/// minimum replaces the first only if its value is less than this share of the first one's. Of 42
/// starts on the shipped drinks, none found a better minimum.
inline constexpr int kContactStarts = 2;
inline constexpr double kContactStartShare = 0.5, kContactStartAdvantage = 0.95;
/// Number of postures of its own, spread over its limits, from which a finger closes that touches
/// badly or not at all as it is. Of 12 on the shipped drinks, most ended in one minimum.
inline constexpr int kClosingStarts = 4;
/// Time before the grasp at which a path with contacts may first touch the target [s], although
/// contact is allowed from the preshape on: fingers that slide along an object push it over.
inline constexpr double kTouchLeadTime_s = 0.3;
/// Largest number of requests in which contacts are moved.
inline constexpr int kMaxContactMoves = 3;

// Re-solving a path with increasing weights of clearance.
/// Factor on the relative tolerance of all re-solves except those with kStrongestWeights.
inline constexpr double kCoarseToleranceFactor = 100;

// A hand alone.
/// Factor on the distance at which the clearance of a hand alone begins, in all re-solves and
/// searches of its repair: its fingers are near each other most of the time, and those that are
/// clear of each other by a millimetre should keep their goals. With all of the distance, the path
/// of the LEAP hand (datasets/dex-retargeting) through other postures was off by 31 mm in the mean.
inline constexpr double kHandAloneBandScale = 0.2;
/// An attempt to solve a path again from bridges over its collisions.
struct BridgeAttempt {
  double margin_s;   ///< from a collision to the ends of its bridge
  double clearance;  ///< factor on the weight of clearance
};
/// Attempts, until one is free. LEAP is free with the first, which replaces least; Shadow, whose
/// thumb lies on its forearm, with the weight of the second.
inline constexpr std::array kBridgeAttempts{BridgeAttempt{0.05, 1000}, BridgeAttempt{0.1, 10000},
                                            BridgeAttempt{0.2, 10000}};
/// Time beside a bridge that may move too [s]: as much as beside a finding.
inline constexpr double kReSolvedBesideBridge_s = 0.3;

// Keeping the person's tempo.
/// The excess of the duration over the person's falls about with this root of the cost of motion
/// (Allegro, LEAP, Shadow and Inspire on datasets/dex-retargeting: exponents of 0.23 to 0.30).
inline constexpr double kTempoRoot = 4;
/// Least and largest factor on the cost of motion from one attempt to the next, chosen by hand: a
/// smaller one takes more attempts, a larger one costs more of the tips' accuracy than is needed.
inline constexpr double kMinCostStep = 1.2, kMaxCostStep = 4;
inline constexpr int kMaxCostSteps = 6;  ///< largest number of attempts
/// Factors with which a free path remains nearly free when all of it is solved again.
inline constexpr ClearanceWeights kTempoWeights{10000, 0.4};

// Search for an infeasible frame.
inline constexpr int kMaxFramesPerPath = 6;
/// Summed excess of a posture's findings below which its frame is not called infeasible [m],
/// because another search may find it feasible.
inline constexpr double kNearlyFeasibleDepth_m = 5e-4;
/// Evaluations of the objective per start in the first search.
inline constexpr int kCoarseEvaluations = 40;
/// Number of the best results of the first search that are solved to the requested accuracy.
inline constexpr int kRefinedCandidateCount = 6;

// Approach and retreat.
/// Largest difference of a joint between an end of approach or retreat and the posture there [rad].
inline constexpr double kEndTolerance = 1e-6;
/// Number of samples of a motion for each sample of its reversed path.
inline constexpr int kReverseSampleStride = 5;

}  // namespace morphe::planning
