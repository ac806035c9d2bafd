#pragma once

#include <map>
#include <string>

#include "core/motion/plan.hpp"

namespace morphe::commands {

/// Returns remarks, by object, on fixed bodies of a plan's scene other than table and target. A
/// body gets a remark if it floats more than 20 mm above the table without support, or penetrates
/// the table by more than 5 mm: its position was probably given in another frame than intended.
std::map<std::string, std::string> scene_remarks(const Plan& plan);

}  // namespace morphe::commands
