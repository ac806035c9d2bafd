#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace morphe::commands {

/// Returns a table with a row for each robot of a run, given by name and plans.h5. Its columns are
///   out of reach  share of the fingertip goals of all plans
///   tips          mean of the mean errors, and largest error, over plans with a trajectory
///   others        medians over plans with a trajectory
std::string robots_table(const std::vector<std::pair<std::string, std::filesystem::path>>& robots,
                         std::size_t width);

}  // namespace morphe::commands
