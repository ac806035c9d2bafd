#pragma once

#include "core/motion/geometry.hpp"

namespace morphe {

/// Returns 1 − (d / r)² for two stops of a hand, with d their distance and r half of the shorter
/// one of `out_m` and `away_m`: the distance from the first stop to the place from which the hand
/// came, and to the farthest point between the stops. It is 1 if the hand comes back exactly, and
/// negative if the stops are two places; no unit or threshold enters.
double revisit_score(const Vec3& first, const Vec3& second, double out_m, double away_m);

}  // namespace morphe
