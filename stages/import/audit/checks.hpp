#pragma once

#include <vector>

#include "stages/import/audit/doubt.hpp"
#include "stages/import/audit/step_table.hpp"

namespace morphe::imports {

// The checks of a recording whose names are Morphe's, in metres and in the axes of the world. Each
// returns its doubts, the most certain first, and none if the data do not allow it to judge. Those
// of rows and jumps share the step tables of the recording.

/// Rows that are equal, written twice or missing (rows.cpp).
std::vector<Doubt> check_rows(const Demonstration& recording, const AuditInput& input,
                              StepTables& steps);
/// Points that jump away and return, or stay away (jumps.cpp).
std::vector<Doubt> check_jumps(const Demonstration& recording, const AuditInput& input,
                               StepTables& steps);
/// Markers and fingertips that carry each other's names (labels.cpp).
std::vector<Doubt> check_labels(const Demonstration& recording, const AuditInput& input);
/// The static trial of another person or session (static_fit.cpp).
std::vector<Doubt> check_static_trial(const Demonstration& recording, const AuditInput& input);
/// Mirrored axes, or the other hand (chirality.cpp).
std::vector<Doubt> check_chirality(const Demonstration& recording, const AuditInput& input);
/// A person who does not stand or sit upright (vertical.cpp).
std::vector<Doubt> check_vertical(const Demonstration& recording, const AuditInput& input);
/// Lengths that no person's arm has (scale.cpp).
std::vector<Doubt> check_scale(const Demonstration& recording, const AuditInput& input);
/// Speeds that no person's arm has, or a clock that is not uniform (time_base.cpp).
std::vector<Doubt> check_time_base(const Demonstration& recording, const AuditInput& input);
/// Points that tremble (jitter.cpp).
std::vector<Doubt> check_jitter(const Demonstration& recording, const AuditInput& input);
/// Objects that the fingers never come near (object_distance.cpp).
std::vector<Doubt> check_objects(const Demonstration& recording, const AuditInput& input);

}  // namespace morphe::imports
