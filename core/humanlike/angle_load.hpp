#pragma once

#include "core/humanlike/loads.hpp"

namespace morphe::humanlike {

/// Adds weight * sqrt(d² + e²), with d half the angle θ from goal to current about the axis n. Its
/// gradient with respect to a small rotation about the base's axes is slope d / (2 sqrt(d² + e²))
/// along n. Its curvature perpendicular to n is slope * cot(θ/2) / 2; along n it is that of the
/// smoothed angle, e² / (4 sqrt³), evaluated with the dual variable in AngleMemory.
void add_angle(int frame, const Quat& current, const Quat& goal, double weight, double smoothing,
               AngleMemory& memory, Loads& loads);

}  // namespace morphe::humanlike
