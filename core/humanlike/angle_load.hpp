#pragma once

#include "core/humanlike/loads.hpp"

namespace morphe::humanlike {

/// weight * sqrt(d² + e²), d half the angle θ from goal to current about n. By a small turn about
/// the base's axes: slope d / (2 sqrt(d² + e²)) along n; curvature across n slope * cot(θ/2) / 2;
/// along n that of the smoothed angle, e² / (4 sqrt³), seen through its memory (AngleMemory).
void add_angle(int frame, const Quat& current, const Quat& goal, double weight, double smoothing,
               AngleMemory& memory, Loads& loads);

}  // namespace morphe::humanlike
