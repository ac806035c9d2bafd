#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stages/repair/repair_strategy.hpp"

namespace morphe::repair {

/// A generator of candidate paths for the whole movement: other joint motions for the same goals,
/// the most promising first. Each call returns one, or nullopt if there are no more. `improved` is
/// true in the first call and if the last candidate became the best.
using NextCandidate = std::function<std::optional<JointPath>(bool improved)>;

/// The remaining findings of each candidate of a movement that has been tried.
using CandidateFindings = std::vector<std::vector<Finding>>;

/// Returns the repair strategy that tries candidate paths, each repaired by `strategies`. It ends
/// with the first candidate free of findings. Otherwise its result is the best of the candidates
/// and the given path, once there are no more candidates or kMaxRepeatedFailures of them have
/// failed at the same place as the best. That is the case for a finding with the same cause and
/// bodies as the worst one of the best, at an overlapping time, and about as deep or deeper. All
/// such strategies of a movement share `tried`, which must outlive them.
RepairStrategy candidate_strategy(std::string name, std::vector<RepairStrategy> strategies,
                                  PathCheck check, NextCandidate candidates,
                                  CandidateFindings& tried);

}  // namespace morphe::repair
