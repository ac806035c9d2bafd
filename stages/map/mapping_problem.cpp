#include "stages/map/mapping_problem.hpp"

#include <cassert>
#include <numeric>
#include <utility>

namespace morphe::map {

void add_frame_objective(const MappingProblem& problem, std::size_t frame, const JointVector& q,
                         MappingScratch& scratch, solve::Quadratic& model,
                         humanlike::Curvature curvature) {
  humanlike::add_objective(problem.objective, *problem.robot, q, problem.goals[frame], scratch,
                           model, curvature);
  assert(problem.world->robot == problem.robot);
  std::vector<Pose>& poses = scratch.clearance.collision.base_from_frame;
  poses.swap(scratch.base_from_frame);  // lent to the clearance term and returned
  add_clearance(problem.clearance, *problem.world, problem.time[frame], scratch.clearance, model);
  poses.swap(scratch.base_from_frame);
}

double frame_objective(const MappingProblem& problem, std::size_t frame, const JointVector& q,
                       MappingScratch& scratch) {
  scratch.model.reset(q.size());
  add_frame_objective(problem, frame, q, scratch, scratch.model, humanlike::Curvature::none);
  return scratch.model.value;
}

std::vector<JointVector> spread_starts(const RobotModel& robot, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<JointVector> starts(count, JointVector(robot.lower.size()));
  std::vector<int> stratum(count);
  for (Eigen::Index j = 0; j < robot.lower.size(); ++j) {
    std::iota(stratum.begin(), stratum.end(), 0);
    for (int k = count - 1; k > 0; --k)
      std::swap(stratum[k], stratum[random() % static_cast<std::uint64_t>(k + 1)]);
    for (int k = 0; k < count; ++k) {
      const double share = (stratum[k] + 0.5) / count;
      starts[k][j] = robot.lower[j] + share * (robot.upper[j] - robot.lower[j]);
    }
  }
  return starts;
}

JointVector random_start(const RobotModel& robot, std::mt19937_64& random) {
  JointVector q(robot.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    q[j] = robot.lower[j] + share * (robot.upper[j] - robot.lower[j]);
  }
  return q;
}

}  // namespace morphe::map
