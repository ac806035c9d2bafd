#pragma once

#include <string>
#include <vector>

#include "pipeline/commands/plan_row.hpp"

namespace morphe::commands {

/// Returns a table of the positions of base, shoulder, table and target at the begin of a movement,
/// each in the frames of base, table and recording [mm]. The positions are medians over the plans;
/// the last column is the largest distance of a plan's position from them. Below it are the axes of
/// the base in the first plan, and the scene_remarks(). Returns "" if no plan has a shoulder.
std::string reference_frames_text(const std::string& robot, const std::vector<PlanRow>& rows,
                                  std::size_t width);

}  // namespace morphe::commands
