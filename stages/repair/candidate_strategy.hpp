#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stages/repair/repair_strategy.hpp"

namespace morphe::repair {

/// A generator of candidate paths for the whole movement, one per call: other joint motions for the
/// same goals (a goal set), for a path whose end is in collision or that cannot be repaired. The
/// most promising candidate comes first; nullopt if there are no more. `nearer` is true if the last
/// candidate became the best.
using NextCandidate = std::function<std::optional<JointPath>(bool nearer)>;

/// The remaining findings of each candidate of a movement that has been tried.
using CandidateFindings = std::vector<std::vector<Finding>>;

/// Returns the repair strategy that tries candidate paths, each repaired by `rungs`. Its result is
/// the first candidate that is free of findings; otherwise the best of the candidates and the path,
/// once there are no more candidates or four of them have failed at the same place as the best,
/// that is, with the same cause and bodies as its worst finding, at the same time and about as deep
/// or deeper. `ends`, which all such strategies of a movement share, must outlive the strategy.
RepairStrategy candidate_strategy(std::string name, std::vector<RepairStrategy> rungs,
                                  PathCheck check, NextCandidate courses, CandidateFindings& ends);

}  // namespace morphe::repair
