#pragma once

#include <string>

#include "core/motion/export.hpp"
#include "core/motion/finding.hpp"

namespace morphe {

/// Returns the subject and its excess: "palm 4.0 mm too close to cup", "thumb_distal 3.5 mm too
/// deep in cup", "joint elbow 2.00 degrees beyond its limit".
MORPHE_EXPORT std::string excess_text(const Finding& finding);

/// Returns a finding as a sentence: "thumb_distal is 3.5 mm too deep in cup, 1.85–2.81 s".
MORPHE_EXPORT std::string sentence(const Finding& finding);

}  // namespace morphe
