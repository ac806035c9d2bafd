#include "stages/map/frame_search.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include "pipeline/kinematics/forward.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/twins.hpp"

namespace morphe {
namespace {

BoundedProblem bounded(const MappingProblem& problem, std::size_t frame, MappingScratch& scratch) {
  BoundedProblem result;
  result.lower = problem.robot->lower;
  result.upper = problem.robot->upper;
  result.objective = [&problem, frame, &scratch](const JointVector& q, JointVector* gradient) {
    scratch.model.reset(q.size());
    add_frame(problem, frame, q, scratch, scratch.model, Curvature::none);
    if (gradient) *gradient = scratch.model.gradient;
    return scratch.model.value;
  };
  scratch.new_descent();
  result.model = [&problem, frame, &scratch](const JointVector& q, Quadratic& model) {
    add_frame(problem, frame, q, scratch, model, Curvature::exact);
  };
  return result;
}

JointVector random_position(const RobotTable& robot, std::mt19937_64& random) {
  JointVector q(robot.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    q[j] = robot.lower[j] + share * (robot.upper[j] - robot.lower[j]);
  }
  return q;
}

constexpr double kSame = 0.1;  ///< nearer in every joint: the same minimum [rad]

void add_if_new(const Twins& twins, std::vector<Minimum>& minima, Minimum found) {
  const auto known = std::ranges::find_if(
      minima, [&](const Minimum& m) { return alike(twins, found.x, m.x, kSame); });
  if (known == minima.end()) {
    minima.push_back(std::move(found));
  } else if (found.value < known->value) {
    *known = std::move(found);
  }
}

void by_value(std::vector<Minimum>& minima) {
  std::ranges::stable_sort(minima, {}, &Minimum::value);
}

void resize_at_most(std::vector<Minimum>& minima, int count) {
  if (minima.size() > static_cast<std::size_t>(count)) {
    minima.resize(static_cast<std::size_t>(count));
  }
}

/// Largest distance of a tip from its goal; 0 without goals.
double tip_error(const MappingProblem& problem, std::size_t frame, const JointVector& q,
                 MappingScratch& scratch) {
  const FrameGoal& goal = problem.goals[frame];
  double largest = 0;
  forward(*problem.robot, q, scratch.base_from_frame);
  for (std::size_t i = 0; i < goal.tip_position.size(); ++i) {
    if (!seen(goal.tip_position[i])) continue;
    const Pose tip = tip_pose(*problem.robot, scratch.base_from_frame, i);
    largest = std::max(largest, (tip.translation() - goal.tip_position[i]).norm());
  }
  return largest;
}

}  // namespace

Minimum solve_frame(const MappingProblem& problem, std::size_t frame, const JointVector& start,
                    const MinimiseOptions& options, MappingScratch& scratch) {
  return minimise(bounded(problem, frame, scratch), start, options);
}

MinimiseOptions brief(MinimiseOptions options, int evaluations) {
  if (options.algorithm == "structured") {
    options.evaluations = std::min(options.evaluations, evaluations);
  }
  return options;
}

Descents exact(const MinimiseOptions& options) {
  MinimiseOptions first = options;  // enough to tell which starts are worth more
  first.relative_value = std::max(options.relative_value, 1e-4);
  return {first, options};
}

Descents quick(const MinimiseOptions& options) {
  const Descents descents = exact(options);
  return {brief(descents.first, 40), brief(descents.then, 10)};
}

std::vector<Minimum> search_frame(const MappingProblem& problem, std::size_t frame, int starts,
                                  int keep, const Descents& descents, std::uint64_t seed,
                                  MappingScratch& scratch) {
  const Twins twins = find_twins(problem);
  std::mt19937_64 random(seed);
  std::vector<Minimum> found;
  for (int i = 0; i < starts; ++i) {
    const JointVector start = random_position(*problem.robot, random);
    add_if_new(twins, found, solve_frame(problem, frame, start, descents.first, scratch));
  }
  by_value(found);
  resize_at_most(found, 2 * keep);
  std::vector<Minimum> minima;
  for (const Minimum& start : found) {
    add_if_new(twins, minima, solve_frame(problem, frame, start.x, descents.then, scratch));
  }
  by_value(minima);
  resize_at_most(minima, keep);
  return minima;
}

bool goals_reachable(const MappingProblem& problem, std::size_t frame, const JointVector& near,
                     int starts, double tolerance_m, const MinimiseOptions& options,
                     std::uint64_t seed, MappingScratch& scratch) {
  constexpr double kSameValue = 1e-4;  // relative
  constexpr int kOftenEnough = 16;     // descents that end in the least value: it is the least
  MappingProblem moment = on_frames(problem, {frame});
  moment.clearance.weight = 0;
  const auto reached = [&](const JointVector& q) {
    return tip_error(moment, 0, q, scratch) <= tolerance_m;
  };
  MappingProblem plain = moment;
  plain.objective = {};
  plain.objective.tip_position = problem.objective.tip_position;
  plain.objective.tip_orientation.weight = 0;
  plain.objective.hand_orientation.weight = 0;
  plain.objective.joint_distance.weight = 0;
  plain.objective.finger_joint_distance.weight = 0;
  std::mt19937_64 random(seed);
  double least = std::numeric_limits<double>::infinity();
  int ended_there = 0;
  for (int i = 0; i <= starts && ended_there < kOftenEnough; ++i) {
    const JointVector start = i == 0 ? near : random_position(*problem.robot, random);
    const Minimum found = solve_frame(plain, 0, start, options, scratch);
    if (reached(found.x)) return true;
    if (found.value < (1 - kSameValue) * least) ended_there = 0;
    if (found.value < (1 + kSameValue) * least) ++ended_there;
    least = std::min(least, found.value);
  }
  return false;
}

}  // namespace morphe
