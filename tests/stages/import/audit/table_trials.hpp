#pragma once

#include <vector>

#include "tests/stages/import/shipped_recordings.hpp"

namespace morphe::imports {

/// Returns the five shipped trials of people at a table, read once.
inline const std::vector<Demonstration>& table_trials() {
  static const std::vector<Demonstration> kTrials = shipped_recordings("ue-adl");
  return kTrials;
}

}  // namespace morphe::imports
