#pragma once

#include "stages/import/audit/checks.hpp"

namespace morphe::imports {

// The checks that share step tables, each with tables of its own.

inline std::vector<Doubt> check_rows(const Demonstration& recording, const AuditInput& input) {
  StepTables steps;
  return check_rows(recording, input, steps);
}

inline std::vector<Doubt> check_jumps(const Demonstration& recording, const AuditInput& input) {
  StepTables steps;
  return check_jumps(recording, input, steps);
}

}  // namespace morphe::imports
