#pragma once

#include <string>

#include "core/motion/export.hpp"
#include "core/motion/finding.hpp"

namespace morphe {

/// Returns "3.5 mm" or "2.00 degrees", with two significant digits if the amount is smaller than
/// these formats show.
MORPHE_EXPORT std::string amount_text(double amount, FindingUnit unit);

/// Returns the subject and its excess: "palm 4.0 mm too close to cup", "thumb_distal 3.5 mm too
/// deep in cup", "joint elbow 2.00 degrees beyond its limit".
MORPHE_EXPORT std::string excess_text(const Finding& finding);

/// Returns a finding as a sentence: "thumb_distal is 3.5 mm too deep in cup, 1.85–2.81 s".
MORPHE_EXPORT std::string sentence(const Finding& finding);

}  // namespace morphe
