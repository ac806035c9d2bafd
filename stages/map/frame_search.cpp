#include "stages/map/frame_search.hpp"

#include <algorithm>
#include <random>

#include "stages/map/posture_symmetries.hpp"

namespace morphe::map {
namespace {

solve::BoundedProblem make_bounded_problem(const MappingProblem& problem, std::size_t frame,
                                           MappingScratch& scratch) {
  solve::BoundedProblem result;
  result.lower = problem.robot->lower;
  result.upper = problem.robot->upper;
  result.objective = [&problem, frame, &scratch](const JointVector& q, JointVector* gradient) {
    scratch.model.reset(q.size());
    add_frame_objective(problem, frame, q, scratch, scratch.model, humanlike::Curvature::none);
    if (gradient) *gradient = scratch.model.gradient;
    return scratch.model.value;
  };
  scratch.new_descent();
  result.model = [&problem, frame, &scratch](const JointVector& q, solve::Quadratic& model) {
    add_frame_objective(problem, frame, q, scratch, model, humanlike::Curvature::exact);
  };
  return result;
}

void add_if_new(const PostureSymmetries& twins, std::vector<solve::Minimum>& minima,
                solve::Minimum found) {
  const auto known = std::ranges::find_if(minima, [&](const solve::Minimum& m) {
    return same_up_to_symmetry(twins, found.x, m.x, kBasinTolerance_rad);
  });
  if (known == minima.end()) {
    minima.push_back(std::move(found));
  } else if (found.value < known->value) {
    *known = std::move(found);
  }
}

void by_value(std::vector<solve::Minimum>& minima) {
  std::ranges::stable_sort(minima, {}, &solve::Minimum::value);
}

void resize_at_most(std::vector<solve::Minimum>& minima, int count) {
  if (minima.size() > static_cast<std::size_t>(count)) {
    minima.resize(count);
  }
}

}  // namespace

JointVector random_start(const RobotModel& robot, std::mt19937_64& random) {
  JointVector q(robot.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    q[j] = robot.lower[j] + share * (robot.upper[j] - robot.lower[j]);
  }
  return q;
}

solve::Minimum solve_frame(const MappingProblem& problem, std::size_t frame,
                           const JointVector& start, const solve::MinimiseOptions& options,
                           MappingScratch& scratch) {
  return solve::minimise(make_bounded_problem(problem, frame, scratch), start, options);
}

solve::MinimiseOptions limit_evaluations(solve::MinimiseOptions options, int evaluations) {
  if (options.algorithm == "trust_region") {
    options.max_evaluations = std::min(options.max_evaluations, evaluations);
  }
  return options;
}

SearchStages thorough_stages(const solve::MinimiseOptions& options) {
  solve::MinimiseOptions first = options;  // accurate enough to rank the starts
  first.relative_tolerance = std::max(options.relative_tolerance, 1e-4);
  return {first, options};
}

SearchStages quick_stages(const solve::MinimiseOptions& options) {
  const SearchStages descents = thorough_stages(options);
  return {limit_evaluations(descents.first, 40), limit_evaluations(descents.then, 10)};
}

std::vector<solve::Minimum> search_frame(const MappingProblem& problem, std::size_t frame,
                                         int starts, int keep, const SearchStages& descents,
                                         std::uint64_t seed, MappingScratch& scratch) {
  const PostureSymmetries twins = find_posture_symmetries(problem);
  std::mt19937_64 random(seed);
  std::vector<solve::Minimum> found;
  for (int i = 0; i < starts; ++i) {
    const JointVector start = random_start(*problem.robot, random);
    add_if_new(twins, found, solve_frame(problem, frame, start, descents.first, scratch));
  }
  by_value(found);
  resize_at_most(found, 2 * keep);
  std::vector<solve::Minimum> minima;
  for (const solve::Minimum& start : found) {
    add_if_new(twins, minima, solve_frame(problem, frame, start.x, descents.then, scratch));
  }
  by_value(minima);
  resize_at_most(minima, keep);
  return minima;
}

}  // namespace morphe::map
