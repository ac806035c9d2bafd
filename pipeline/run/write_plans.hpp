#pragma once

#include <string>

#include "core/store/plan_file.hpp"
#include "pipeline/run/journal.hpp"

namespace morphe::run {

/// The plans of one demonstration, from the journal into the file, one at a time in memory.
void write_plans(const Journal& journal, const std::string& demonstration,
                 store::PlanWriter& writer);

}  // namespace morphe::run
