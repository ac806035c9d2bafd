#pragma once

#include <array>
#include <optional>
#include <vector>

#include "pipeline/setup/finger_bodies.hpp"

namespace morphe::setup {

/// Returns the joint positions of two jaws from open to closed, nullopt if neither shapes nor
/// limits tell which is which. `points` are the middles of the jaws. They are nearest to each other
/// when the jaws are closed. If the middles pass each other within the range, the closed posture is
/// where they pass, and the side from which they come is that of rest, which only shapes make
/// known.
std::optional<std::vector<JointVector>> closing_postures(const Kinematics& robot,
                                                         const std::vector<Finger>& jaws,
                                                         const std::array<BodyPoint, 2>& points);

}  // namespace morphe::setup
