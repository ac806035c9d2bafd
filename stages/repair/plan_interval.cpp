#include "stages/repair/plan_interval.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "core/math/seed.hpp"
#include "stages/repair/connect.hpp"
#include "stages/repair/constants.hpp"
#include "stages/repair/path_smoothing.hpp"

namespace morphe::repair {
namespace {

/// Extends the interval, and the world that depends on it, until both of its ends are free. Returns
/// false if the path ends before.
bool extend_to_free(const collision::CollisionWorld& world, const JointPath& path, double extra_m,
                    TouchRule rule, Interval& interval) {
  const auto& times = path.demonstration_time;
  collision::CollisionScratch scratch;
  while (true) {
    interval.untimed =
        interval_world(world, times[interval.first], times[interval.last], extra_m, rule);
    if (!is_state_free(interval.untimed, path.position.row(interval.first), scratch)) {
      if (--interval.first < 0) return false;
    } else if (!is_state_free(interval.untimed, path.position.row(interval.last), scratch)) {
      if (++interval.last >= path.position.rows()) return false;
    } else {
      return true;
    }
  }
}

/// Returns the range of the original samples, wider on both sides by `share` of each joint's span.
ConnectSpace space_around(const robot::Robot& robot, const JointRows& original, double share) {
  ConnectSpace space;
  const JointVector widening = share * (robot.upper - robot.lower);
  const JointVector lowest = original.colwise().minCoeff(), highest = original.colwise().maxCoeff();
  space.lower = (lowest - widening).cwiseMax(robot.lower).cwiseMin(lowest);
  space.upper = (highest + widening).cwiseMin(robot.upper).cwiseMax(highest);
  return space;
}

}  // namespace

std::optional<Interval> interval_around(const collision::CollisionWorld& world,
                                        const JointPath& path, double begin_s, double end_s,
                                        int widen, double extra_clearance) {
  const auto& times = path.demonstration_time;
  const auto from = std::ranges::lower_bound(times, begin_s) - times.begin();
  const auto to = std::ranges::upper_bound(times, end_s) - times.begin();
  const auto first = static_cast<int>(std::max<std::ptrdiff_t>(0, from - 1 - widen));
  const auto last = static_cast<int>(std::min(std::ssize(times) - 1, to + widen));
  const int max_length = last - first + kLongIntervalWidenings * std::max(widen, 1);

  std::optional<Interval> shortest;
  for (const double share : kExtraClearanceShares) {
    for (const TouchRule rule : {TouchRule::strict, TouchRule::lenient}) {
      Interval interval{first, last, {}, {}};
      const double extra_m = share * extra_clearance;
      if (!extend_to_free(world, path, extra_m, rule, interval)) continue;
      interval.timed = padded_world(world, extra_m);
      const int length = interval.last - interval.first;
      if (!shortest || length < shortest->last - shortest->first) shortest = interval;
      if (length <= max_length) return interval;
    }
  }
  return shortest;
}

bool plan_interval(const Interval& interval, const RepairOptions& options, int attempt,
                   std::uint64_t seed, JointPath& path) {
  const robot::Robot& robot = *interval.timed.environment.robot;
  const int count = interval.last - interval.first + 1;
  if (count < 3) return false;
  const JointRows original = path.position.middleRows(interval.first, count);
  const JointVector from = original.row(0), to = original.row(count - 1);

  const bool baseline = options.method == Method::rrt_connect;
  ConnectSpace space =
      space_around(robot, original, baseline ? 1 : kBoxShares[std::min(attempt, 2)]);
  std::vector<int> all_joints(robot.joints());
  std::iota(all_joints.begin(), all_joints.end(), 0);
  std::vector<JointVector> vertices;
  space.joints = robot.arm_joints;
  if (!baseline && !space.joints.empty() && space.joints.size() < all_joints.size())
    vertices = plan_rrt_connect(interval.untimed, space, from, to, options.max_iterations,
                                options.range, math::seed_from(seed, "arm"));
  if (vertices.empty()) {
    space.joints = all_joints;
    vertices = plan_rrt_connect(interval.untimed, space, from, to, options.max_iterations,
                                options.range, math::seed_from(seed, "all joints"));
  }
  if (vertices.empty()) return false;

  std::mt19937_64 random(math::seed_from(seed, "shortcut"));
  vertices = shortcut(interval.untimed, std::move(vertices), options.shortcut_attempts, random);
  JointRows planned = resample(robot, vertices, count);
  if (planned.rows() == 0) return false;
  const auto begin = path.demonstration_time.begin() + interval.first;
  if (!baseline) {
    pull_towards_original(interval.timed, {begin, begin + count}, original,
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
