#pragma once

#include <map>
#include <string>

#include "core/motion/plan.hpp"

namespace morphe::commands {

/// Sentences on the fixed bodies of a plan's scene, table and target aside, that are over the
/// table: one that hangs more than 20 mm above it with nothing below, or goes more than 5 mm into
/// it. Most often its place was given in another frame than was thought.
std::map<std::string, std::string> scene_remarks(const Plan& plan);  ///< by object

}  // namespace morphe::commands
