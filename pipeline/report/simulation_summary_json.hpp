#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::report {

/// Returns the folders that may contain results of `morphe simulate`: the named ones, otherwise the
/// folder `physics` beside the plans.
std::vector<std::filesystem::path> simulation_folders(
    const std::vector<std::filesystem::path>& named, const std::filesystem::path& plans);

/// Summarises the rollouts of a plan (page/README.md) from the first folder that has results of
/// exactly this plan, null if there is no such folder. A result of a different plan with the same
/// name is left out with a note. Throws InputError if a file of that name is not a result.
nlohmann::ordered_json simulation_summary_json(const std::vector<std::filesystem::path>& folders,
                                               const RobotModel& robot, const Plan& plan,
                                               std::vector<std::string>& notes);

}  // namespace morphe::report
