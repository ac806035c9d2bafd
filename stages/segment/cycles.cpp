#include "stages/segment/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "stages/segment/opening.hpp"

namespace morphe::segment {
namespace {

constexpr std::size_t kMostBouts = 12;  ///< in one movement
constexpr double kNever = -std::numeric_limits<double>::infinity();
constexpr double kMovement = 0.25;  ///< for any movement
constexpr double kHeadless = -0.1;  ///< for a movement without its reach
constexpr double kMoved = 1, kGrasped = 0.5, kNotGrasped = -0.5;
constexpr double kAway = 1, kNearer = 0.25, kSkipped = 1;

struct Evidence {
  const HandSignals& signals;
  const SegmentOptions& options;
  const std::vector<Bout>& bouts;
  const std::vector<SceneObject>& objects;
  std::vector<Opening> opening;  ///< of each bout, taken for a reach
  std::vector<bool> carried;     ///< of each bout
  std::vector<bool> held;        ///< after each bout, an object is
  Vec3 shoulder;                 ///< where it is most of the time, or unseen
};

Vec3 usual_place(const std::vector<Vec3>& points) {
  std::vector<double> axis[3];
  for (const Vec3& point : points) {
    if (!seen(point)) continue;
    for (int k = 0; k < 3; ++k) axis[k].push_back(point[k]);
  }
  if (axis[0].empty()) return unseen_point();
  Vec3 median;
  for (int k = 0; k < 3; ++k) {
    const auto middle = axis[k].begin() + static_cast<std::ptrdiff_t>(axis[k].size() / 2);
    std::nth_element(axis[k].begin(), middle, axis[k].end());
    median[k] = *middle;
  }
  return median;
}

/// 1 − (d / h)²: at home above 0.
double homing(const SegmentOptions& options, const Bout& reach, const Bout& bout) {
  const double way = (reach.to - reach.from).norm();
  const double away = (bout.to - reach.from).norm() / std::min(options.home_radius, way / 2);
  return std::max(-1.0, 1 - away * away);
}

bool is_reach(const SegmentOptions& options, const Bout& bout) {
  if (bout.cut_begin && bout.peak <= bout.first + 2) return false;
  if (bout.cut_end && bout.peak + 2 >= bout.last) return false;
  return (bout.to - bout.from).norm() >= options.least_reach;
}

bool nears_an_object(const Evidence& on, const Bout& reach) {
  return std::any_of(on.objects.begin(), on.objects.end(), [&](const SceneObject& object) {
    if (object.time.empty()) return false;
    const Vec3 at = recorded_pose(object, reach.begin_s).translation();
    return (reach.to - at).norm() < 0.5 * (reach.from - at).norm();
  });
}

/// What speaks for one movement made of bouts [first, end).
double worth(const Evidence& on, std::size_t first, std::size_t end) {
  const bool last = end == on.bouts.size();
  if (!is_reach(on.options, on.bouts[first]) || (end - first < 2 && !last)) return kNever;
  const Bout& reach = on.bouts[first];
  const double home = homing(on.options, reach, on.bouts[end - 1]);
  double sum = kMovement + (last ? std::max(0.0, home) : home);
  const auto carried = on.carried.begin();
  const bool moved =
      std::any_of(carried + static_cast<std::ptrdiff_t>(first) + 1,
                  carried + static_cast<std::ptrdiff_t>(end), [](bool c) { return c; });
  if (moved) {
    sum += kMoved;
  } else if (on.held[first]) {
    sum += kGrasped;
  } else if (on.opening[first].known) {
    sum += on.opening[first].grasps() ? kGrasped : kNotGrasped;
  }
  if (on.carried[first]) sum -= kMoved;
  if (seen(on.shoulder)) {
    const auto level_distance = [&](const Vec3& from) {
      return (from - on.shoulder).head<2>().norm();
    };
    const double gained = level_distance(reach.to) - level_distance(reach.from);
    sum += kAway * gained / (reach.to - reach.from).norm();
  }
  if (nears_an_object(on, reach)) sum += kNearer;
  for (std::size_t k = first + 1; k + 1 < end; ++k) {
    sum -= std::max(0.0, homing(on.options, on.bouts[first], on.bouts[k]));
  }
  return static_cast<double>(end - first) * sum;
}

Evidence gather(const HandSignals& signals, const HumanMotion& motion,
                const SegmentOptions& options, const std::vector<Bout>& bouts,
                const std::vector<SceneObject>& objects, const std::vector<ObjectMotion>& motions,
                const std::vector<Contact>& contacts) {
  Evidence on{signals, options, bouts, objects, {}, {}, {}, usual_place(motion.shoulder)};
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    const double next_s = k + 1 < bouts.size() ? bouts[k + 1].begin_s : signals.end_s();
    on.opening.push_back(opening_in(signals, options, bouts[k].begin_s, bouts[k].end_s, next_s));
    on.carried.push_back(carries(bouts[k], motions));
    const std::string held =
        held_between(contacts, signals, bouts[k].end_s, next_s, options.least_grasp);
    on.held.push_back(!held.empty());
  }
  return on;
}

}  // namespace

bool carries(const Bout& bout, const std::vector<ObjectMotion>& motions) {
  return std::any_of(motions.begin(), motions.end(), [&](const ObjectMotion& motion) {
    const double common =
        std::min(bout.end_s, motion.end_s) - std::max(bout.begin_s, motion.begin_s);
    return common > 0.5 * std::min(bout.end_s - bout.begin_s, motion.end_s - motion.begin_s);
  });
}

std::vector<Cycle> find_cycles(const HandSignals& signals, const HumanMotion& motion,
                               const SegmentOptions& options, const std::vector<Bout>& bouts,
                               const std::vector<SceneObject>& objects,
                               const std::vector<ObjectMotion>& motions,
                               const std::vector<Contact>& contacts) {
  const Evidence on = gather(signals, motion, options, bouts, objects, motions, contacts);
  const std::size_t n = bouts.size();
  struct Best {
    double sum = kNever;
    std::size_t from = 0;
    bool movement = false;
  };
  std::vector<Best> best(n + 1);
  best[0].sum = 0;
  const auto offer = [&](std::size_t from, std::size_t to, double gain, bool movement) {
    const double sum = best[from].sum + gain;
    if (sum > best[to].sum) best[to] = {sum, from, movement};
  };
  for (std::size_t i = 0; i < n; ++i) {
    offer(i, i + 1, -kSkipped * std::min(1.0, bouts[i].extent / options.home_radius), false);
    for (std::size_t j = i + 1; j <= std::min(n, i + kMostBouts); ++j) {
      if (i == 0) offer(i, j, bouts[0].cut_begin ? 0 : kHeadless, false);
      offer(i, j, worth(on, i, j), true);
    }
  }
  std::vector<Cycle> cycles;
  for (std::size_t j = n; j > 0; j = best[j].from) {
    const std::size_t i = best[j].from;
    if (!best[j].movement) continue;
    const double home = homing(options, bouts[i], bouts[j - 1]);
    cycles.push_back({i, j - i, home > 0});
  }
  std::reverse(cycles.begin(), cycles.end());
  return cycles;
}

}  // namespace morphe::segment
