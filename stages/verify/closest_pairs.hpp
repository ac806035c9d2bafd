#pragma once

#include <vector>

#include "stages/verify/contact.hpp"
#include "stages/verify/pair_distance.hpp"

namespace morphe::verify {

/// Largest difference of a stored clearance from the recomputed one [m].
inline constexpr double kStoredClearanceTolerance_m = 1e-4;

/// Returns the kind of clearance for which a pair counts.
ClearanceKind kind_of_pair(const Plan& plan, const ContactPair& pair);

/// Records a `certificate` violation for each of the certificate's clearances by kind that is not
/// the distance of its pair at its time on the curve, or whose pair does not exist.
void verify_closest_pairs(const Plan& plan, const Curve& curve,
                          const std::vector<ContactPair>& pairs, BodyDistances& bodies,
                          ViolationLog& violations);

}  // namespace morphe::verify
