#pragma once

#include <string>

#include "pipeline/explain/posture.hpp"

namespace morphe::explain {

/// Returns the posture as lines of a plan's summary, "" if nothing is known of it.
std::string posture_text(const Plan& plan, const PostureSummary& posture);

}  // namespace morphe::explain
