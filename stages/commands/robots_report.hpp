#pragma once

#include <string>

#include "pipeline/store/plan_file.hpp"

namespace morphe::commands {

/// A row a robot of one run: its plans together. Without a newline at the end.
///   out of reach  share of the fingertips' goals
///   tips          of executable plans: the mean of their means, the largest of all
///   upper arm, palm, tempo  medians over executable plans
std::string robots_table_head();
std::string robots_row(const std::string& name, const store::PlanReader& plans);

}  // namespace morphe::commands
