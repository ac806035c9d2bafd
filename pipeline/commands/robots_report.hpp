#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace morphe::commands {

/// A row a robot of one run, of its name and plans.h5: all its plans together.
///   out of reach  share of the fingertips' goals
///   tips          of plans with a trajectory: the mean of their means, the largest of all
///   humanlikeness A, upper arm, palm, tempo  medians over these
std::string robots_table(const std::vector<std::pair<std::string, std::filesystem::path>>& robots,
                         std::size_t width);

}  // namespace morphe::commands
