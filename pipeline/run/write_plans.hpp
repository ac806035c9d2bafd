#pragma once

#include <string>

#include "core/store/plan_file.hpp"
#include "pipeline/run/journal.hpp"

namespace morphe::run {

/// Copies the plans of one demonstration from the journal to the file, with one plan in memory at a
/// time.
void write_plans(const Journal& journal, const std::string& demonstration,
                 store::PlanWriter& writer);

}  // namespace morphe::run
