#include "stages/map/frame_search.hpp"

#include <algorithm>
#include <random>

#include "stages/map/constants.hpp"
#include "stages/map/posture_symmetries.hpp"

namespace morphe::map {
namespace {

solve::BoundedProblem make_bounded_problem(const MappingProblem& problem, std::size_t frame,
                                           MappingScratch& scratch) {
  solve::BoundedProblem result;
  result.lower = problem.robot->lower;
  result.upper = problem.robot->upper;
  result.objective = [&problem, frame, &scratch](const JointVector& q, JointVector* gradient) {
    const double value = frame_objective(problem, frame, q, scratch);
    if (gradient) *gradient = scratch.model.gradient;
    return value;
  };
  scratch.new_descent();
  result.model = [&problem, frame, &scratch](const JointVector& q, solve::Quadratic& model) {
    add_frame_objective(problem, frame, q, scratch, model, humanlike::Curvature::exact);
  };
  return result;
}

void add_if_new(const PostureSymmetries& symmetries, std::vector<solve::Minimum>& minima,
                solve::Minimum found) {
  const auto known = std::ranges::find_if(minima, [&](const solve::Minimum& m) {
    return same_up_to_symmetry(symmetries, found.x, m.x, kSameMinimum_rad);
  });
  if (known == minima.end()) {
    minima.push_back(std::move(found));
  } else if (found.value < known->value) {
    *known = std::move(found);
  }
}

/// Returns spread positions and those of the reference. With a reference, the fingers start as it
/// does, those without a goal in their natural posture: other fingers would only find other ways
/// around obstacles.
std::vector<JointVector> starts_of(const MappingProblem& problem, std::size_t frame, int count,
                                   std::uint64_t seed) {
  const robot::Robot& robot = *problem.robot;
  const std::vector<JointVector>& known = problem.reference.starts;
  std::vector<JointVector> starts = spread_starts(robot, count, seed);
  if (!known.empty() && !robot.arm_joints.empty()) {
    for (JointVector& start : starts) {
      JointVector with_arm = problem.reference.starts.front();
      for (const int joint : robot.arm_joints) with_arm[joint] = start[joint];
      start = with_arm;
    }
  }
  starts.insert(starts.end(), known.begin(), known.end());
  for (JointVector& start : starts) {
    problem.objective.get<humanlike::NaturalPosture>().apply(problem.goals[frame], start);
    start = start.cwiseMax(robot.lower).cwiseMin(robot.upper);
  }
  return starts;
}

void keep_best(std::vector<solve::Minimum>& minima, int count) {
  std::ranges::stable_sort(minima, {}, &solve::Minimum::value);
  if (std::ssize(minima) > count) minima.resize(count);
}

}  // namespace

solve::Minimum solve_frame(const MappingProblem& problem, std::size_t frame,
                           const JointVector& start, const solve::MinimiseOptions& options,
                           MappingScratch& scratch) {
  return solve::minimise(make_bounded_problem(problem, frame, scratch), start, options);
}

solve::Minimum solve_frame_near(const MappingProblem& problem, std::size_t frame,
                                const JointVector& start, const JointVector& weight,
                                const solve::MinimiseOptions& options, MappingScratch& scratch) {
  solve::BoundedProblem bounded = make_bounded_problem(problem, frame, scratch);
  bounded.objective = [&, objective = bounded.objective](const JointVector& q,
                                                         JointVector* gradient) {
    const double value = objective(q, gradient);
    if (gradient) *gradient += 2 * weight.cwiseProduct(q - start);
    return value + weight.dot((q - start).cwiseAbs2());
  };
  bounded.model = [&, model_of = bounded.model](const JointVector& q, solve::Quadratic& model) {
    model_of(q, model);
    model.value += weight.dot((q - start).cwiseAbs2());
    model.gradient += 2 * weight.cwiseProduct(q - start);
    model.hessian.diagonal() += 2 * weight;
  };
  return solve::minimise(bounded, start, options);
}

solve::MinimiseOptions limit_evaluations(solve::MinimiseOptions options, int evaluations) {
  if (options.algorithm == "trust_region") {
    options.max_evaluations = std::min(options.max_evaluations, evaluations);
  }
  return options;
}

SearchStages thorough_stages(const solve::MinimiseOptions& options) {
  solve::MinimiseOptions first = options;  // accurate enough to rank the starts
  first.relative_tolerance = std::max(options.relative_tolerance, kRankingTolerance);
  return {first, options};
}

SearchStages quick_stages(const solve::MinimiseOptions& options) {
  const SearchStages descents = thorough_stages(options);
  return {limit_evaluations(descents.first, kMaxQuickEvaluations),
          limit_evaluations(descents.then, kMaxQuickRefinements)};
}

std::vector<solve::Minimum> search_frame(const MappingProblem& problem, std::size_t frame,
                                         int starts, int keep, const SearchStages& descents,
                                         std::uint64_t seed, MappingScratch& scratch) {
  const PostureSymmetries symmetries = find_posture_symmetries(problem);
  std::vector<solve::Minimum> found;
  for (const JointVector& start : starts_of(problem, frame, starts, seed)) {
    add_if_new(symmetries, found, solve_frame(problem, frame, start, descents.first, scratch));
  }
  keep_best(found, kRefinedPerKeptMinimum * keep);
  std::vector<solve::Minimum> minima;
  for (const solve::Minimum& start : found) {
    add_if_new(symmetries, minima, solve_frame(problem, frame, start.x, descents.then, scratch));
  }
  keep_best(minima, keep);
  return minima;
}

}  // namespace morphe::map
