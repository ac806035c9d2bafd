#pragma once

#include <string>

#include "core/store/plan_file.hpp"
#include "pipeline/run/journal.hpp"

namespace morphe::run {

/// Copies a demonstration's plans from the journal to the file. Throws InputError if one is
/// damaged.
void write_plans(const Journal& journal, const std::string& demonstration,
                 store::PlanWriter& writer);

}  // namespace morphe::run
