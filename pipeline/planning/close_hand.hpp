#pragma once

#include <string>
#include <vector>

#include "pipeline/planning/contact_posture.hpp"

namespace morphe::planning {

/// Closes the fingers of `tips` onto the target in the posture `touching` at `frame`, and appends
/// their contacts to it. A finger closes as grasp::close_fingers() closes it. Then this finger
/// alone slides along the surface until its pad faces it as well as it can. If it does not touch
/// within grasp::kGoodPadAngle_rad afterwards, it also slides to the surface from its open posture
/// and from kClosingStarts others, spread over its limits, and takes the one with the least pad
/// angle into which it closes without a collision. Returns a sentence for each finger that stays
/// open. `problem` must have the target.
std::vector<std::string> close_hand(const map::MappingProblem& problem, std::size_t frame,
                                    const std::vector<std::size_t>& tips,
                                    const map::MapOptions& options, std::uint64_t seed,
                                    ContactPosture& touching);

}  // namespace morphe::planning
