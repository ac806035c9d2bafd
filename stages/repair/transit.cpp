#include "stages/repair/transit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/math/seed.hpp"
#include "stages/repair/connect.hpp"
#include "stages/repair/path_smoothing.hpp"

namespace morphe::repair {
namespace {

constexpr double kMaxSampleStep_rad = 0.02, kSamplePeriod_s = 0.01;
constexpr int kMinSampleCount = 21;

/// Returns the largest clearance beyond the margin, up to `extra_m`, that both ends have.
bool find_free_clearance(const collision::CollisionWorld& world, const JointVector& from,
                         const JointVector& to, double time_s, double extra_m,
                         IntervalWorld& interval) {
  collision::CollisionScratch scratch;
  for (const double share : {1.0, 0.3, 0.1, 0.0}) {
    interval = interval_world(world, time_s, time_s, share * extra_m, TouchRule::lenient);
    if (is_state_free(interval, from, scratch) && is_state_free(interval, to, scratch)) return true;
  }
  return false;
}

std::vector<JointVector> find_way(const IntervalWorld& interval, const JointVector& from,
                                  const JointVector& to, const RepairOptions& options,
                                  std::uint64_t seed) {
  const robot::Robot& robot = *interval.world.environment.robot;
  std::vector<int> all(robot.joints());
  std::iota(all.begin(), all.end(), 0);
  ConnectSpace space{robot.arm_joints, robot.lower, robot.upper};
  std::vector<JointVector> vertices;
  for (int attempt = 0; attempt < options.attempts && vertices.empty(); ++attempt) {
    const std::uint64_t own = math::seed_from(seed, "attempt", attempt);
    for (const std::vector<int>& joints : {robot.arm_joints, all}) {
      space.joints = joints;
      if (joints.empty() || !vertices.empty()) continue;
      vertices =
          plan_rrt_connect(interval, space, from, to, options.max_iterations, options.range, own);
    }
  }
  return vertices;
}

JointPath make_planned_path(const JointRows& rows, double time_s) {
  JointPath path;
  path.position = rows;
  path.origin.assign(rows.rows(), SampleOrigin::planned);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    path.demonstration_time.push_back(time_s + kSamplePeriod_s * static_cast<double>(k));
  }
  return path;
}

}  // namespace

JointPath plan_transit(const collision::CollisionWorld& world, const JointVector& from,
                       const JointVector& to, double time_s, const RepairOptions& options,
                       std::uint64_t seed) {
  const robot::Robot& robot = *world.robot;
  const JointVector inside = to.cwiseMax(robot.lower).cwiseMin(robot.upper);
  IntervalWorld interval;
  if (!find_free_clearance(world, from, inside, time_s, options.extra_clearance, interval))
    return {};
  std::vector<JointVector> vertices = find_way(interval, from, inside, options, seed);
  if (vertices.empty()) return {};
  std::mt19937_64 random(math::seed_from(seed, "shortcut"));
  vertices = shortcut(interval, std::move(vertices), options.shortcut_attempts, random);

  double length_rad = 0;
  for (std::size_t k = 0; k + 1 < vertices.size(); ++k) {
    length_rad += (vertices[k + 1] - vertices[k]).cwiseAbs().maxCoeff();
  }
  const int count = std::max(kMinSampleCount + static_cast<int>(vertices.size()),
                             static_cast<int>(std::ceil(length_rad / kMaxSampleStep_rad)));
  JointRows rows = resample(robot, vertices, count);
  JointRows straight = rows;
  for (int k = 0; k < count; ++k) {
    straight.row(k) = (from + (inside - from) * k / (count - 1.0)).transpose();
  }
  const std::vector<double> times(count, time_s);
  pull_towards_original(interval.world, times, straight, options.pull_back_attempts, random, rows);
  return make_planned_path(rows, time_s);
}

}  // namespace morphe::repair
