#pragma once

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
/// Factors for a path with contacts: the weight of the first set of re_solve_strongly(), and the
/// distance of the second.
inline constexpr ClearanceWeights kContactWeights{1000, 0.2};
/// Factor on the relative tolerance for a path with contacts, which starts near its minimum.
inline constexpr double kSettlingToleranceFactor = 10;
/// Time before the grasp at which a path with contacts may first touch the target [s], although
/// contact is allowed from the preshape on: fingers that slide along an object push it over.
inline constexpr double kTouchLeadTime_s = 0.3;
/// Largest distance of a moved contact from the demonstrated one [m]. If a pad cannot touch at its
/// contact point, it touches beside it, because contact matters more than its position.
inline constexpr double kMaxContactShift_m = 0.015;
/// Largest number of requests in which contacts are moved.
inline constexpr int kMaxContactMoves = 3;

// Re-solving a path with increasing weights of clearance.
/// Factor on the relative tolerance of all re-solves except those with kStrongestWeights.
inline constexpr double kCoarseToleranceFactor = 100;

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
