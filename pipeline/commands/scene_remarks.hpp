#pragma once

#include <map>
#include <string>

#include "core/motion/plan.hpp"

namespace morphe::commands {

/// Returns a sentence for each fixed body of a plan's scene, except table and target, that is above
/// the table and either floats more than 20 mm above it without support, or penetrates it by more
/// than 5 mm. In most cases its position was given in another frame than intended. The sentences
/// are indexed by object.
std::map<std::string, std::string> scene_remarks(const Plan& plan);

}  // namespace morphe::commands
