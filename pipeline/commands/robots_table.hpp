#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace morphe::commands {

/// Returns a table with one row for each robot of a run, given by name and plans.h5, over all its
/// plans:
///   out of reach  share of the fingertip goals
///   tips          over plans with a trajectory: the mean of their means and the largest of all
///   humanlikeness A, upper arm, palm, tempo  medians over these plans
std::string robots_table(const std::vector<std::pair<std::string, std::filesystem::path>>& robots,
                         std::size_t width);

}  // namespace morphe::commands
