#pragma once

#include <string>

#include "pipeline/run/batch.hpp"

namespace morphe::run {

/// A summary as the journal keeps it (JSON), all of it.
std::string summary_text(const BatchSummary& summary);
BatchSummary summary_from_text(const std::string& text);

}  // namespace morphe::run
