#include "pipeline/collision/certified.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace morphe {
namespace {

/// Deeper than this the interval is 1e-12 of the motion: its travel does not shrink, or cannot.
constexpr std::size_t kDeepest = 40;

/// One bisection over a motion. Pairs are numbered: those of world.pairs first, then capsule by
/// capsule its objects.
struct Bisection {
  const CollisionWorld& world;
  const JointRows& reach;
  const JointMotion& motion;
  CollisionScratch& scratch;
  double band_m;
  bool first_only;
  std::vector<MotionCheck>& failed;

  MotionCheck least;  ///< least slack seen; of motion_clearance(): least distance
  double at_least = std::numeric_limits<double>::infinity();  ///< of motion_clearance()
  bool touching = false;  ///< whether the part of the motion at hand may touch
  TargetPlace target_place = TargetPlace::as_recorded;  ///< in that part

  std::size_t objects() const { return world.scene->objects.size(); }
  std::size_t pairs() const {
    return world.pairs.size() + world.robot->capsules.size() * objects();
  }

  PairSeparation pair_of(std::size_t number) const {
    PairSeparation pair;
    pair.required = world.tolerances.margin;
    if (number < world.pairs.size()) {
      pair.capsule = world.pairs[number][0];
      pair.other = world.pairs[number][1];
      return pair;
    }
    const std::size_t k = number - world.pairs.size();
    pair.object = true;
    pair.capsule = static_cast<int>(k / objects());
    pair.other = static_cast<int>(k % objects());
    if (touching && pair.other == world.target &&
        world.robot->capsules[k / objects()].may_touch_target) {
      pair.required = -world.tolerances.contact_depth;
    }
    return pair;
  }

  void place(double s0, double middle, double s1) {
    motion.position(middle, scratch.position);
    motion.travel(s0, s1, scratch.travel);
    const double middle_s = motion.demonstration_time(middle);
    place_bodies(world, scratch.position, middle_s, scratch);
    for (std::size_t c = 0; c < scratch.bodies.size(); ++c) {
      scratch.body_travel[c] = reach.row(static_cast<Eigen::Index>(c)).dot(scratch.travel);
    }
    for (std::size_t k = 0; k < objects(); ++k) {
      const SceneObject& object = world.scene->objects[k];
      const bool still = object.time.size() < 2 || (static_cast<int>(k) == world.target &&
                                                    target_place != TargetPlace::as_recorded);
      scratch.object_travel[k] = still ? 0
                                       : object_travel(object, motion.demonstration_time(s0),
                                                       middle_s, motion.demonstration_time(s1));
    }
  }

  /// What joints above a common parent do to both bodies does not bring them nearer.
  /// `reach_a`, `reach_b`: [joints] of each.
  double travel_between(int a, const double* reach_a, int b, const double* reach_b) const {
    int last_a = -1, last_b = -1;  // a coupled joint turns neighbouring frames: count it once
    double sum_m = 0;
    while (a != b) {
      const bool first = a > b;  // parents first: the later frame is no parent of the other
      int& frame = first ? a : b;
      int& last = first ? last_a : last_b;
      const RobotTable::Frame& turned = world.robot->frames[static_cast<std::size_t>(frame)];
      if (turned.joint >= 0 && turned.joint != last) {
        sum_m += (first ? reach_a : reach_b)[turned.joint] * scratch.travel[turned.joint];
        last = turned.joint;
      }
      frame = turned.parent;
    }
    return sum_m;
  }

  double travel_of(const PairSeparation& pair) const {
    const auto first = static_cast<std::size_t>(pair.capsule);
    const auto other = static_cast<std::size_t>(pair.other);
    const int frame = world.robot->capsules[first].frame;
    const double* own = reach.row(pair.capsule).data();
    if (!pair.object) {
      return travel_between(frame, own, world.robot->capsules[other].frame,
                            reach.row(pair.other).data());
    }
    if (pair.other == world.target && target_place == TargetPlace::in_hand) {
      return travel_between(frame, own, world.carried.frame, world.carried.reach.data());
    }
    return scratch.body_travel[first] + scratch.object_travel[other];
  }

  /// No more than the pair's slack, at little cost.
  double slack_at_least(const PairSeparation& pair) const {
    const CollisionScratch::Ball& a = scratch.balls[static_cast<std::size_t>(pair.capsule)];
    const double around = a.radius + pair.required;
    const auto other = static_cast<std::size_t>(pair.other);
    if (!pair.object) {
      const CollisionScratch::Ball& b = scratch.balls[other];
      return (a.centre - b.centre).norm() - b.radius - around;
    }
    const Pose& pose = scratch.object_poses[other];
    const Vec3 in_object = pose.linear().transpose() * (a.centre - pose.translation());
    return signed_distance_at_least(world.scene->objects[other], in_object) - around;
  }

  void measure(PairSeparation& pair) const {
    const CapsuleBody& first = scratch.bodies[static_cast<std::size_t>(pair.capsule)];
    const auto other = static_cast<std::size_t>(pair.other);
    pair.separation =
        pair.object ? capsule_solid(first, world.scene->objects[other], scratch.object_poses[other])
                    : capsule_capsule(first, scratch.bodies[other]);
  }

  /// Judges the pairs in scratch.open[depth] over [s0, s1]; what stays open goes one level down.
  void judge(std::size_t depth, double s0, double s1) {
    const double middle = 0.5 * (s0 + s1);
    place(s0, middle, s1);
    std::vector<std::size_t>& further = scratch.open[depth + 1];
    further.clear();
    for (const std::size_t number : scratch.open[depth]) {
      PairSeparation pair = pair_of(number);
      const double bound_m = slack_at_least(pair);
      if (bound_m > least.pair.slack() && bound_m >= travel_of(pair)) continue;
      measure(pair);
      if (pair.slack() < least.pair.slack()) least = {MotionVerdict::free, middle, pair, s0, s1};
      const double travel_m = travel_of(pair);
      if (pair.slack() >= travel_m) continue;
      const bool colliding = !(pair.slack() >= 0);  // NaN too
      const bool last = travel_m < band_m || depth + 1 >= kDeepest;
      if (last || (colliding && (first_only || !(pair.slack() >= -travel_m)))) {
        failed.push_back({colliding ? MotionVerdict::colliding : MotionVerdict::undecided, middle,
                          pair, s0, s1});
        if (first_only) return;
      } else {
        further.push_back(number);
      }
    }
    if (further.empty()) return;
    judge(depth + 1, s0, middle);
    if (first_only && !failed.empty()) return;
    judge(depth + 1, middle, s1);
  }

  /// Where the demonstration's time passes `time_s`, by halving.
  double passing(double time_s) const {
    double low = motion.begin, high = motion.end;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (motion.demonstration_time(middle) < time_s ? low : high) = middle;
    }
    return high;
  }

  bool pair_touches(const PairSeparation& pair) const {
    return touching && pair.object && pair.other == world.target &&
           world.robot->capsules[static_cast<std::size_t>(pair.capsule)].may_touch_target;
  }

  /// Follows the pairs in scratch.open[depth] over [s0, s1] until none can come nearer than what
  /// was seen, less the resolution.
  void approach(std::size_t depth, double s0, double s1, double resolution_m) {
    const double middle = 0.5 * (s0 + s1);
    place(s0, middle, s1);
    std::vector<std::size_t>& further = scratch.open[depth + 1];
    further.clear();
    const auto nearest = [&] { return least.pair.separation.distance - resolution_m; };
    for (const std::size_t number : scratch.open[depth]) {
      PairSeparation pair = pair_of(number);
      if (pair_touches(pair)) continue;
      const double travel_m = travel_of(pair);
      double bound_m = slack_at_least(pair) + pair.required - travel_m;
      if (!(bound_m >= nearest())) {
        measure(pair);
        const double distance = pair.separation.distance;
        if (!(distance >= least.pair.separation.distance)) {
          least = {MotionVerdict::free, middle, pair, s0, s1};
        }
        bound_m = distance - travel_m;
        if (bound_m < nearest() && travel_m > 1e-9 && depth + 1 < kDeepest) {
          further.push_back(number);
          continue;
        }
      }
      at_least = std::min(at_least, bound_m);
    }
    if (further.empty()) return;
    approach(depth + 1, s0, middle, resolution_m);
    approach(depth + 1, middle, s1, resolution_m);
  }

  /// Calls part(from, to) for the parts of the motion in which what may touch, and where the target
  /// is held, does not change, until it says to stop.
  template <class Part>
  void run(Part part) {
    least.pair.separation.distance = std::numeric_limits<double>::infinity();
    least.pair.capsule = -1;
    least.at = motion.begin;
    scratch.open.resize(kDeepest + 1);
    scratch.body_travel.resize(world.robot->capsules.size());
    scratch.object_travel.resize(objects());
    const double begin_s = motion.demonstration_time(motion.begin);
    const double end_s = motion.demonstration_time(motion.end);
    std::array<double, 4> borders{world.touch_begin_s, world.touch_end_s, world.carried.begin_s,
                                  world.carried.end_s};
    for (double& border_s : borders) {
      const bool inside = begin_s < border_s && border_s < end_s;
      border_s = inside ? passing(border_s) : motion.end;  // NaN too
    }
    std::ranges::sort(borders);
    double from = motion.begin;
    for (const double border : borders) {
      if (border > from) {
        scratch.open[0].resize(pairs());
        for (std::size_t k = 0; k < pairs(); ++k) scratch.open[0][k] = k;
        const double middle_s = motion.demonstration_time(0.5 * (from + border));
        touching = middle_s >= world.touch_begin_s && middle_s <= world.touch_end_s;
        target_place = place_of_target(world, middle_s);
        if (!part(from, border)) return;
        from = border;
      }
    }
  }

  void judge_all() {
    run([&](double from, double to) {
      judge(0, from, to);
      return !first_only || failed.empty();
    });
  }
};

std::tuple<bool, int, int> key_of(const PairSeparation& pair) {
  return {pair.object, pair.capsule, pair.other};
}

/// Neighbouring intervals of one pair as one, with what was worst.
void join(std::vector<MotionCheck>& found) {
  std::ranges::stable_sort(found, [](const MotionCheck& a, const MotionCheck& b) {
    return std::tuple(key_of(a.pair), a.begin) < std::tuple(key_of(b.pair), b.begin);
  });
  std::vector<MotionCheck> joined;
  for (const MotionCheck& next : found) {
    if (joined.empty() || key_of(joined.back().pair) != key_of(next.pair) ||
        joined.back().end < next.begin) {
      joined.push_back(next);
      continue;
    }
    MotionCheck& last = joined.back();
    const double end = std::max(last.end, next.end);
    if (!(next.pair.slack() >= last.pair.slack())) {
      const double begin = last.begin;
      last = next;
      last.begin = begin;
    }
    last.end = end;
  }
  found = std::move(joined);
}

}  // namespace

double object_travel(const SceneObject& object, double begin_s, double middle_s, double end_s) {
  const double radius_m = bounding_radius(object);
  const auto way = [&](double from_s, double to_s) {
    Pose last = recorded_pose(object, from_s);
    double length_m = 0;
    const auto go = [&](const Pose& next) {
      const double angle = Eigen::AngleAxisd(last.linear().transpose() * next.linear()).angle();
      length_m += (next.translation() - last.translation()).norm() + radius_m * std::abs(angle);
      last = next;
    };
    const auto first = std::upper_bound(object.time.begin(), object.time.end(), from_s);
    for (auto knot = first; knot != object.time.end() && *knot < to_s; ++knot) {
      go(recorded_pose(object, *knot));
    }
    go(recorded_pose(object, to_s));
    return length_m;
  };
  return std::max(way(begin_s, middle_s), way(middle_s, end_s));
}

void failing_pairs(const CollisionWorld& world, const JointRows& reach, const JointMotion& motion,
                   CollisionScratch& scratch, std::vector<MotionCheck>& out, double band_m) {
  out.clear();
  Bisection bisection{world, reach, motion, scratch, band_m, false, out, {}};
  bisection.judge_all();
  join(out);
}

MotionCheck check_motion(const CollisionWorld& world, const JointRows& reach,
                         const JointMotion& motion, CollisionScratch& scratch, double band_m) {
  std::vector<MotionCheck> failed;
  Bisection bisection{world, reach, motion, scratch, band_m, true, failed, {}};
  bisection.judge_all();
  return failed.empty() ? bisection.least : failed.front();
}

MotionClearance motion_clearance(const CollisionWorld& world, const JointRows& reach,
                                 const JointMotion& motion, CollisionScratch& scratch,
                                 double resolution_m) {
  std::vector<MotionCheck> unused;
  Bisection bisection{world, reach, motion, scratch, 0, false, unused, {}};
  bisection.run([&](double from, double to) {
    bisection.approach(0, from, to, resolution_m);
    return true;
  });
  const MotionCheck& least = bisection.least;
  const double distance = least.pair.separation.distance;
  return {std::min(bisection.at_least, distance), distance, least.at, least.pair};
}

JointMotion straight_motion(const JointVector& from, const JointVector& to, double from_s,
                            double to_s) {
  JointMotion motion;
  motion.position = [from, to](double s, JointVector& q) { q = from + s * (to - from); };
  motion.travel = [reach = JointVector((to - from).cwiseAbs())](double s0, double s1,
                                                                JointVector& travel) {
    travel = 0.5 * (s1 - s0) * reach;
  };
  motion.demonstration_time = [from_s, to_s](double s) { return from_s + s * (to_s - from_s); };
  return motion;
}

}  // namespace morphe
