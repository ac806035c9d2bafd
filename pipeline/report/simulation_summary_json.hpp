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

/// Returns a summary of the rollouts of a plan (page/README.md), from the first folder with a
/// result of exactly this plan; null without one. If a file of its name has the result of
/// another plan instead, a note is appended. Throws InputError if such a file is not a result.
nlohmann::ordered_json simulation_summary_json(const std::vector<std::filesystem::path>& folders,
                                               const RobotModel& robot, const Plan& plan,
                                               std::vector<std::string>& notes);

}  // namespace morphe::report
