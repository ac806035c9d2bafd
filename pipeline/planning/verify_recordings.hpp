#pragma once

#include <filesystem>

#include "stages/verify/verify.hpp"

namespace morphe::planning {

/// Reads the recordings of a plans.h5 again, reconstructs them with the file's own config and
/// robot, and adds to the report what a plan has otherwise than its recording (`recording`; see
/// verify::verify_recorded()), movements without a plan, and a dataset that is not the named one.
/// This uses the code of planning up to the goals: it shows that a plan is of these recordings, not
/// that they were understood rightly. Runs on `jobs` threads, with the same report for any number.
/// Throws InputError if `dataset` is not a demonstrations.h5, or if the plans' config cannot be
/// restored from the file.
void verify_recordings(const std::filesystem::path& plans, const std::filesystem::path& dataset,
                       int jobs, verify::VerifyReport& report);

}  // namespace morphe::planning
