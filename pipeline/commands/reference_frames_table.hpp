#pragma once

#include <string>
#include <vector>

#include "pipeline/commands/plan_row.hpp"

namespace morphe::commands {

/// Returns a table of the positions of base, shoulder, table and target at the beginning of a
/// movement, each in the frames of base, table and recording [mm]: medians over the plans, and the
/// distance of the farthest plan from them. The axes of the base and the results of scene_remarks()
/// follow. Returns "" if the robot was not placed beside a person.
std::string reference_frames_text(const std::string& robot, const std::vector<PlanRow>& rows,
                                  std::size_t width);

}  // namespace morphe::commands
