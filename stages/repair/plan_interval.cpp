#include "stages/repair/plan_interval.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "core/math/seed.hpp"
#include "stages/repair/connect.hpp"
#include "stages/repair/path_smoothing.hpp"

namespace morphe::repair {
namespace {

/// Extends first and last until both samples are free. Returns false if an end of the path is
/// reached before.
bool reach_free_ends(const collision::CollisionWorld& world, const JointPath& path, double extra_m,
                     TouchRule rule, Interval& interval) {
  const auto& times = path.demonstration_time;
  const int end = static_cast<int>(path.position.rows()) - 1;
  collision::CollisionScratch scratch;
  while (true) {
    interval.untimed_world =
        interval_world(world, times[interval.first], times[interval.last], extra_m, rule);
    if (!is_state_free(interval.untimed_world, path.position.row(interval.first), scratch)) {
      if (--interval.first < 0) return false;
    } else if (!is_state_free(interval.untimed_world, path.position.row(interval.last), scratch)) {
      if (++interval.last > end) return false;
    } else {
      return true;
    }
  }
}

/// Returns the space around the original samples of the interval, extended by `share` of each
/// joint's span on both sides.
ConnectSpace space_around(const robot::Robot& robot, const JointRows& original, double share) {
  ConnectSpace space;
  const JointVector more = share * (robot.upper - robot.lower);
  const JointVector least = original.colwise().minCoeff(), most = original.colwise().maxCoeff();
  space.lower = (least - more).cwiseMax(robot.lower).cwiseMin(least);
  space.upper = (most + more).cwiseMin(robot.upper).cwiseMax(most);
  return space;
}

}  // namespace

std::optional<Interval> interval_around(const collision::CollisionWorld& world,
                                        const JointPath& path, double begin_s, double end_s,
                                        int widen, double extra_clearance) {
  const auto& times = path.demonstration_time;
  const int end = static_cast<int>(times.size()) - 1;
  const auto from = std::lower_bound(times.begin(), times.end(), begin_s) - times.begin();
  const auto to = std::upper_bound(times.begin(), times.end(), end_s) - times.begin();
  const int first = std::max(0, static_cast<int>(from) - 1 - widen);
  const int last = std::min(end, static_cast<int>(to) + widen);
  const int near = last - first + 4 * std::max(widen, 1);

  std::optional<Interval> shortest;
  for (const double share : {1.0, 0.3, 0.1}) {
    for (const TouchRule rule : {TouchRule::strict, TouchRule::lenient}) {
      Interval interval{first, last, {}, {}};
      const double extra_m = share * extra_clearance;
      if (!reach_free_ends(world, path, extra_m, rule, interval)) continue;
      interval.timed_world = padded_world(world, extra_m);
      const int length = interval.last - interval.first;
      if (!shortest || length < shortest->last - shortest->first) shortest = interval;
      if (length <= near) return interval;
    }
  }
  return shortest;
}

bool plan_interval(const Interval& interval, const RepairOptions& options, int attempt,
                   std::uint64_t seed, JointPath& path) {
  constexpr double kBox[] = {0.1, 0.3, 1};
  const robot::Robot& robot = *interval.timed_world.environment.robot;
  const int count = interval.last - interval.first + 1;
  if (count < 3) return false;
  const JointRows original = path.position.middleRows(interval.first, count);
  const JointVector from = original.row(0), to = original.row(count - 1);

  const bool plain = options.method == Method::rrt_connect;
  ConnectSpace space = space_around(robot, original, plain ? 1 : kBox[std::min(attempt, 2)]);
  std::vector<int> all(robot.joints());
  std::iota(all.begin(), all.end(), 0);
  std::vector<JointVector> vertices;
  space.joints = robot.arm_joints;
  if (!plain && !space.joints.empty() && space.joints.size() < all.size())
    vertices = plan_rrt_connect(interval.untimed_world, space, from, to, options.max_iterations,
                                options.range, math::seed_from(seed, "arm"));
  if (vertices.empty()) {
    space.joints = all;
    vertices = plan_rrt_connect(interval.untimed_world, space, from, to, options.max_iterations,
                                options.range, math::seed_from(seed, "all joints"));
  }
  if (vertices.empty()) return false;

  std::mt19937_64 random(math::seed_from(seed, "shortcut"));
  vertices =
      shortcut(interval.untimed_world, std::move(vertices), options.shortcut_attempts, random);
  JointRows planned = resample(robot, vertices, count);
  if (planned.rows() == 0) return false;
  const auto begin = path.demonstration_time.begin() + interval.first;
  if (!plain) {
    pull_towards_original(interval.timed_world, {begin, begin + count}, original,
                          options.pull_back_attempts, random, planned);
  }
  for (int k = 1; k + 1 < count; ++k) {
    if (planned.row(k) == original.row(k)) continue;
    path.position.row(interval.first + k) = planned.row(k);
    path.origin[interval.first + k] = SampleOrigin::planned;
  }
  return true;
}

}  // namespace morphe::repair
