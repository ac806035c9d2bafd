#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::report {

/// Where results of `morphe simulate` may lie: the folders that are named, otherwise the folder
/// `physics` beside the plans.
std::vector<std::filesystem::path> physics_folders(const std::vector<std::filesystem::path>& named,
                                                   const std::filesystem::path& plans);

/// What the rollouts of a plan came to (page/README.md), of the first folder that has results of
/// this very plan; null if none has. A result of a plan of that name which differs is left out with
/// a note. InputError: a file of that name which is no result.
nlohmann::ordered_json physics_json(const std::vector<std::filesystem::path>& folders,
                                    const RobotTable& robot, const Plan& plan,
                                    std::vector<std::string>& notes);

}  // namespace morphe::report
