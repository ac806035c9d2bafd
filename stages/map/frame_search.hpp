#pragma once

#include <cstdint>
#include <vector>

#include "core/solve/minimise.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Returns a local minimum of one frame's objective from a start, found by `options.algorithm`.
solve::Minimum solve_frame(const MappingProblem& problem, std::size_t frame,
                           const JointVector& start, const solve::MinimiseOptions& options,
                           MappingScratch& scratch);

/// As solve_frame(), plus sum_j weight_j (q_j - start_j)²: a posture that stays near its start
/// where the objective leaves it free.
solve::Minimum solve_frame_near(const MappingProblem& problem, std::size_t frame,
                                const JointVector& start, const JointVector& weight,
                                const solve::MinimiseOptions& options, MappingScratch& scratch);

/// Returns the options with at most `evaluations` for `trust_region`; unchanged for the others.
solve::MinimiseOptions limit_evaluations(solve::MinimiseOptions options, int evaluations);

/// Options of a search's descents: `first` from every start, `then` from the best minima.
struct SearchStages {
  solve::MinimiseOptions first, then;
};
/// Returns the stages of a search that finds minima to full accuracy in its second stage.
SearchStages thorough_stages(const solve::MinimiseOptions& options);
/// Returns the stages of a search that only tells apart minima, which are tracked and smoothed.
SearchStages quick_stages(const solve::MinimiseOptions& options);

/// Returns at most `keep` distinct local minima of one frame's objective, the best first, found
/// from `starts` spread positions (spread_starts) and those of the problem's reference. With a
/// reference the fingers begin as it has them, those without a goal in their natural posture: other
/// fingers would only find other ways around obstacles. Equivalent postures (PostureSymmetries)
/// within kSameMinimum_rad are one minimum. A seed gives the same starts on any machine.
std::vector<solve::Minimum> search_frame(const MappingProblem& problem, std::size_t frame,
                                         int starts, int keep, const SearchStages& descents,
                                         std::uint64_t seed, MappingScratch& scratch);

}  // namespace morphe::map
