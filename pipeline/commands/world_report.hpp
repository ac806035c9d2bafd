#pragma once

#include <string>
#include <vector>

#include "pipeline/commands/plan_row.hpp"

namespace morphe::commands {

/// Where base, shoulder, table and target stand as a movement begins, each in the frames of base,
/// table and recording [mm]: medians over the plans, and how far the farthest is from them. Then
/// the base's axes and what scene_remarks() has to say. "" if nothing was placed beside a person.
std::string world_text(const std::string& robot, const std::vector<PlanRow>& rows,
                       std::size_t width);

}  // namespace morphe::commands
