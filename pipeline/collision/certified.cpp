#include "pipeline/collision/certified.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

  std::vector<char> out_of_play;  ///< [pairs] 1: has failed before
  MotionCheck least;              ///< least slack seen
  bool touching = false;          ///< whether the part of the motion at hand may touch

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
      scratch.object_travel[k] = object.time.size() < 2
                                     ? 0
                                     : object_travel(object, motion.demonstration_time(s0),
                                                     middle_s, motion.demonstration_time(s1));
    }
  }

  /// What joints above a common parent do to both capsules does not bring them nearer.
  double travel_between(int first, int second) const {
    const RobotTable& robot = *world.robot;
    int a = robot.capsules[static_cast<std::size_t>(first)].frame;
    int b = robot.capsules[static_cast<std::size_t>(second)].frame;
    int last_a = -1, last_b = -1;  // a coupled joint turns neighbouring frames: count it once
    double sum_m = 0;
    while (a != b) {
      int& frame = a > b ? a : b;  // parents first: the later frame is no parent of the other
      int& last = a > b ? last_a : last_b;
      const int capsule = a > b ? first : second;
      const RobotTable::Frame& turned = robot.frames[static_cast<std::size_t>(frame)];
      if (turned.joint >= 0 && turned.joint != last) {
        sum_m += reach(capsule, turned.joint) * scratch.travel[turned.joint];
        last = turned.joint;
      }
      frame = turned.parent;
    }
    return sum_m;
  }

  double travel_of(const PairSeparation& pair) const {
    if (!pair.object) return travel_between(pair.capsule, pair.other);
    return scratch.body_travel[static_cast<std::size_t>(pair.capsule)] +
           scratch.object_travel[static_cast<std::size_t>(pair.other)];
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

  void fail(std::size_t number, MotionVerdict verdict, double at, const PairSeparation& pair) {
    out_of_play[number] = 1;
    failed.push_back({verdict, at, pair});
  }

  /// Judges the pairs in scratch.open[depth] over [s0, s1]; what stays open goes one level down.
  void judge(std::size_t depth, double s0, double s1) {
    const double middle = 0.5 * (s0 + s1);
    place(s0, middle, s1);
    std::vector<std::size_t>& further = scratch.open[depth + 1];
    further.clear();
    for (const std::size_t number : scratch.open[depth]) {
      if (out_of_play[number]) continue;
      PairSeparation pair = pair_of(number);
      const double at_least = slack_at_least(pair);
      if (at_least > least.pair.slack()) {
        if (at_least >= travel_of(pair)) continue;
      }
      measure(pair);
      if (pair.slack() < least.pair.slack()) least = {MotionVerdict::free, middle, pair};
      const double travel_m = travel_of(pair);
      if (pair.slack() >= travel_m) continue;
      if (!(pair.slack() >= 0)) {  // NaN too
        fail(number, MotionVerdict::colliding, middle, pair);
      } else if (travel_m < band_m || depth + 1 >= kDeepest) {
        fail(number, MotionVerdict::undecided, middle, pair);
      } else {
        further.push_back(number);
      }
      if (first_only && !failed.empty()) return;
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

  void run() {
    out_of_play.assign(pairs(), 0);
    least.pair.separation.distance = std::numeric_limits<double>::infinity();
    least.pair.capsule = -1;
    least.at = motion.begin;
    scratch.open.resize(kDeepest + 1);
    scratch.body_travel.resize(world.robot->capsules.size());
    scratch.object_travel.resize(objects());
    scratch.open[0].resize(pairs());
    for (std::size_t k = 0; k < pairs(); ++k) scratch.open[0][k] = k;
    const double begin_s = motion.demonstration_time(motion.begin);
    const double end_s = motion.demonstration_time(motion.end);
    double from = motion.begin;
    const auto part_to = [&](double to) {
      const double middle_s = motion.demonstration_time(0.5 * (from + to));
      touching = middle_s >= world.touch_begin_s && middle_s <= world.touch_end_s;
      judge(0, from, to);
      from = to;
    };
    for (const double border_s : {world.touch_begin_s, world.touch_end_s}) {
      if (!(begin_s < border_s && border_s < end_s)) continue;
      part_to(passing(border_s));
      if (first_only && !failed.empty()) return;
    }
    part_to(motion.end);
  }
};

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
  Bisection{world, reach, motion, scratch, band_m, false, out, {}, {}}.run();
}

MotionCheck check_motion(const CollisionWorld& world, const JointRows& reach,
                         const JointMotion& motion, CollisionScratch& scratch, double band_m) {
  std::vector<MotionCheck> failed;
  Bisection bisection{world, reach, motion, scratch, band_m, true, failed, {}, {}};
  bisection.run();
  return failed.empty() ? bisection.least : failed.front();
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
