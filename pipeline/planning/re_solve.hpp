#pragma once

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/repair/ladder.hpp"

namespace morphe::planning {

/// What re-solving needs to know; all but `check` must outlive the rungs.
struct ReSolving {
  const map::MappingProblem& whole;  ///< the movement against the whole scene
  const map::MapOptions& options;
  repair::Check check;
};

/// The least change of the mapping: the path re-solved near its findings against the whole scene,
/// its clearance term firmer and firmer until tips give way to it.
repair::Rung gently(const ReSolving& solving);

/// The same, as firmly as it takes: for tips that gave way to clearance nobody asked for, just
/// free; at last tips and freedom alone decide.
repair::Rung firmly(const ReSolving& solving);

}  // namespace morphe::planning
