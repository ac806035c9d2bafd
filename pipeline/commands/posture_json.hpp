#pragma once

#include <nlohmann/json.hpp>

#include "pipeline/explain/posture.hpp"

namespace morphe::commands {

/// Returns the posture as JSON (docs/formats.md), in SI units; null if nothing is known of it.
nlohmann::ordered_json posture_json(const explain::PostureSummary& posture);

}  // namespace morphe::commands
