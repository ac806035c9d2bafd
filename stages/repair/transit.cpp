#include "stages/repair/transit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>

#include "core/math/seed.hpp"
#include "stages/repair/connect.hpp"
#include "stages/repair/constants.hpp"
#include "stages/repair/path_smoothing.hpp"

namespace morphe::repair {
namespace {
std::optional<IntervalWorld> widest_free_world(const collision::CollisionWorld& world,
                                               const JointVector& from, const JointVector& to,
                                               double time_s, double extra_m) {
  collision::CollisionScratch scratch;
  const auto world_with = [&](double share) -> std::optional<IntervalWorld> {
    IntervalWorld padded =
        interval_world(world, time_s, time_s, share * extra_m, TouchRule::lenient);
    const bool free = is_state_free(padded, from, scratch) && is_state_free(padded, to, scratch);
    return free ? std::optional(std::move(padded)) : std::nullopt;
  };
  for (const double share : kExtraClearanceShares)
    if (std::optional<IntervalWorld> free = world_with(share)) return free;
  return world_with(0);
}

std::vector<JointVector> plan_vertices(const IntervalWorld& interval, const JointVector& from,
                                       const JointVector& to, const RepairOptions& options,
                                       std::uint64_t seed) {
  const robot::Robot& robot = *interval.world.environment.robot;
  std::vector<int> all_joints(robot.joints());
  std::iota(all_joints.begin(), all_joints.end(), 0);
  ConnectSpace space{robot.arm_joints, robot.lower, robot.upper};
  std::vector<JointVector> vertices;
  for (int attempt = 0; attempt < options.attempts && vertices.empty(); ++attempt) {
    const std::uint64_t attempt_seed = math::seed_from(seed, "attempt", attempt);
    for (const std::vector<int>& joints : {robot.arm_joints, all_joints}) {
      space.joints = joints;
      if (joints.empty() || !vertices.empty()) continue;
      vertices = plan_rrt_connect(interval, space, from, to, options.max_iterations, options.range,
                                  attempt_seed);
    }
  }
  return vertices;
}

JointPath make_planned_path(const JointRows& rows, double time_s) {
  JointPath path;
  path.position = rows;
  path.origin.assign(rows.rows(), SampleOrigin::planned);
  for (int k = 0; k < rows.rows(); ++k)
    path.demonstration_time.push_back(time_s + kTransitPeriod_s * k);
  return path;
}

}  // namespace

JointPath plan_transit(const collision::CollisionWorld& world, const JointVector& from,
                       const JointVector& to, double time_s, const RepairOptions& options,
                       std::uint64_t seed) {
  const robot::Robot& robot = *world.robot;
  const JointVector goal = to.cwiseMax(robot.lower).cwiseMin(robot.upper);
  const std::optional<IntervalWorld> interval =
      widest_free_world(world, from, goal, time_s, options.extra_clearance);
  if (!interval) return {};
  std::vector<JointVector> vertices = plan_vertices(*interval, from, goal, options, seed);
  if (vertices.empty()) return {};
  std::mt19937_64 random(math::seed_from(seed, "shortcut"));
  vertices = shortcut(*interval, std::move(vertices), options.shortcut_attempts, random);

  double length_rad = 0;
  for (int k = 0; k + 1 < std::ssize(vertices); ++k)
    length_rad += (vertices[k + 1] - vertices[k]).cwiseAbs().maxCoeff();
  const int count =
      static_cast<int>(std::max(static_cast<double>(kMinTransitSamples + std::ssize(vertices)),
                                std::ceil(length_rad / kMaxTransitStep_rad)));
  JointRows rows = resample(robot, vertices, count);
  JointRows straight = rows;
  for (int k = 0; k < count; ++k)
    straight.row(k) = (from + (goal - from) * k / (count - 1.0)).transpose();
  const std::vector<double> times(count, time_s);
  pull_towards_original(interval->world, times, straight, options.pull_back_attempts, random, rows);
  return make_planned_path(rows, time_s);
}

}  // namespace morphe::repair
