#pragma once

#include <string>

#include "pipeline/run/batch.hpp"

namespace morphe::run {

/// Converts a complete summary to JSON, as the journal stores it.
std::string serialize_summary(const BatchSummary& summary);
/// Converts the JSON back to a summary.
BatchSummary deserialize_summary(const std::string& text);

}  // namespace morphe::run
