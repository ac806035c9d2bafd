#include <algorithm>
#include <cmath>

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/pad.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

/// The error that a certificate may miss between its samples.
constexpr double kInterSampleTolerance_m = 1e-4;
// An undecided interval counts as a violation if the tip travels at most kMinTipTravel_m or at
// least_tolerance kMaxTipTravel_m relative to its goal, or after kMaxTipBisections.
constexpr double kMinTipTravel_m = 1e-5, kMaxTipTravel_m = 10;
constexpr int kMaxTipBisections = 1000000;

/// A part of a piece that has neither a goal frame nor a phase border inside. The goals are linear
/// in it, and the tolerance is constant.
struct GoalInterval {
  double from = 0, to = 1;  ///< shares of the piece
};

class TrackingVerifier {
 public:
  TrackingVerifier(const RobotModel& robot, const Plan& plan, const Curve& curve,
                   ViolationLog& violations)
      : robot_(robot),
        plan_(plan),
        curve_(curve),
        violations_(violations),
        pads_(pad_spheres(robot)) {
    for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
      const Vec3 own = robot.tips[tip].transform.translation();
      const bool has_pad = pads_[tip].capsule >= 0;
      const Vec3 pad = has_pad ? pads_[tip].centre : own;
      motion_bounds_.push_back(
          point_motion_bound(robot, robot.tips[tip].frame, std::max(own.norm(), pad.norm())));
      pad_offsets_.push_back((pad - own).norm());
    }
    borders_ = plan.goals.time;
    for (const Phase& phase : plan.movement.phases)
      borders_.insert(borders_.end(), {phase.begin_s, phase.end_s});
    std::ranges::sort(borders_);
  }

  void run() {
    if (plan_.goals.frames() == 0) return;
    std::vector<double> before = errors_at_sample(0), after;
    for (int piece = 0; piece < curve_.pieces; ++piece, std::swap(before, after)) {
      after = errors_at_sample(piece + 1);
      verify_piece(piece, before, after);
    }
  }

 private:
  double tolerance_at(double time_s) const {
    return is_grasping(plan_.movement.phases, time_s) ? plan_.tolerances.tracking_tolerance_grasp
                                                      : plan_.tolerances.tracking_tolerance;
  }

  /// Returns the error of a tip; NaN if it has no goal at that time.
  double error_of(int tip, double time_s) const {
    const std::optional<Vec3> goal = goal_at(plan_.goals, tip, time_s);
    if (!goal) return kUnknown;
    const Vec3 tracked = tracked_point(robot_, pads_, plan_.goals, tip, time_s);
    return (to_base_frame(poses_, robot_.tips[tip].frame, tracked) - *goal).norm();
  }

  std::vector<double> errors_at_sample(int sample) {
    const Trajectory& trajectory = *curve_.trajectory;
    const double time_s = trajectory.demonstration_time[sample];
    frame_poses(robot_, trajectory.position.row(sample).transpose(), poses_);
    const double tolerance = tolerance_at(time_s);
    std::vector<double> errors;
    for (int tip = 0; tip < std::ssize(robot_.tips); ++tip) {
      const double error = errors.emplace_back(error_of(tip, time_s));
      if (error > tolerance) note(tip, point_at_sample(trajectory, sample), error, tolerance);
    }
    return errors;
  }

  /// Verifies a piece, except for tips that bounds from both ends of the piece prove near enough.
  void verify_piece(int piece, const std::vector<double>& before,
                    const std::vector<double>& after) {
    const std::vector<double>& time = curve_.trajectory->demonstration_time;
    const double begin_s = time[piece], end_s = time[piece + 1];
    const double least_tolerance =
        kInterSampleTolerance_m +
        std::min(plan_.tolerances.tracking_tolerance_grasp, plan_.tolerances.tracking_tolerance);
    std::vector<int> undecided;
    for (int tip = 0; tip < std::ssize(robot_.tips); ++tip) {
      const double twice_bound = before[tip] + after[tip] + max_tip_travel(piece, tip, 1) +
                                 max_goal_travel(tip, begin_s, end_s);
      if (!(0.5 * twice_bound <= least_tolerance)) undecided.push_back(tip);
    }
    if (undecided.empty()) return;
    for (const GoalInterval& part : split_at_borders(begin_s, end_s)) {
      const double middle_s = std::lerp(begin_s, end_s, 0.5 * (part.from + part.to));
      std::vector<int> with_goal;
      for (const int tip : undecided)
        if (goal_at(plan_.goals, tip, middle_s)) with_goal.push_back(tip);
      bisect(piece, part, tolerance_at(middle_s), with_goal);
    }
  }

  std::vector<GoalInterval> split_at_borders(double begin_s, double end_s) const {
    std::vector<GoalInterval> parts{{}};
    const auto first = std::ranges::upper_bound(borders_, begin_s);
    for (auto border = first; border != borders_.end() && *border < end_s; ++border) {
      const double share = (*border - begin_s) / (end_s - begin_s);
      if (share <= parts.back().from) continue;
      parts.back().to = share;
      parts.push_back({share, 1});
    }
    return parts;
  }

  /// Proves that tips are near enough in a part of a piece, throughout which they must have goals.
  void bisect(int piece, const GoalInterval& part, double tolerance, const std::vector<int>& tips) {
    if (tips.empty()) return;
    const double middle = 0.5 * (part.from + part.to), half = 0.5 * (part.to - part.from);
    const double middle_s = curve_.demonstration_time_at(piece, middle);
    const double half_s = curve_.demonstration_time_at(piece, part.to) - middle_s;
    curve_.position_at(piece, middle, q_);
    frame_poses(robot_, q_, poses_);
    std::vector<int> undecided;
    for (const int tip : tips) {
      const double error = error_of(tip, middle_s);
      const double travel = max_tip_travel(piece, tip, half) + half_s * goal_speed(tip, middle_s);
      if (error + travel <= tolerance + kInterSampleTolerance_m) continue;
      const bool violated = !(error <= tolerance + kInterSampleTolerance_m);
      if (!violated && travel > kMinTipTravel_m && travel < kMaxTipTravel_m &&
          bisections_left_ > 0) {
        undecided.push_back(tip);
      } else {
        note(tip, curve_.point_at(piece, middle), error, tolerance);
      }
    }
    if (undecided.empty()) return;
    --bisections_left_;
    bisect(piece, {part.from, middle}, tolerance, undecided);
    bisect(piece, {middle, part.to}, tolerance, undecided);
  }

  /// Returns an upper bound of a tip's travel in a share of a piece.
  double max_tip_travel(int piece, int tip, double share) const {
    const std::vector<double>& time = curve_.trajectory->time;
    return share * (time[piece + 1] - time[piece]) *
           curve_.speed.row(piece).dot(motion_bounds_[tip]);
  }

  /// Returns the sum of two speeds between the frames around a time: of a goal, and of the point in
  /// the link to which it applies [m per s of the demonstration].
  double goal_speed(int tip, double time_s) const {
    const Goals& goals = plan_.goals;
    const auto [before, after, share] = interpolate_goal_frames(goals, time_s);
    if (before == after) return 0;
    double travel = (goals.tip_position(after, tip) - goals.tip_position(before, tip)).norm();
    if (goals.tip_to_pad_share.rows > 0)
      travel += pad_offsets_[tip] *
                std::abs(goals.tip_to_pad_share(after, tip) - goals.tip_to_pad_share(before, tip));
    return travel / (goals.time[after] - goals.time[before]);
  }

  /// Returns an upper bound of the travel of a goal plus that of the point to which it applies,
  /// between two times; NaN if a goal is unknown.
  double max_goal_travel(int tip, double begin_s, double end_s) const {
    if (begin_s == end_s) return 0;
    double travel = 0, from_s = begin_s;
    const std::vector<double>& time = plan_.goals.time;
    for (auto frame = std::ranges::upper_bound(time, begin_s);; ++frame) {
      const double to_s = frame == time.end() ? end_s : std::min(*frame, end_s);
      travel += (to_s - from_s) * goal_speed(tip, 0.5 * (from_s + to_s));
      if (to_s == end_s) return travel;
      from_s = to_s;
    }
  }

  void note(int tip, const CurvePoint& point, double error, double tolerance) {
    violations_.note("tracking", robot_.tips[tip].name, point, error, tolerance, error - tolerance);
  }

  const RobotModel& robot_;
  const Plan& plan_;
  const Curve& curve_;
  ViolationLog& violations_;
  std::vector<PadSphere> pads_;
  int bisections_left_ = kMaxTipBisections;
  std::vector<JointVector> motion_bounds_;  ///< [tips]
  std::vector<double> pad_offsets_;         ///< [tips] distance from the tip to its pad [m]
  std::vector<double> borders_;             ///< times of goal frames, begins and ends of phases [s]
  std::vector<Pose> poses_;
  JointVector q_;
};

}  // namespace

void verify_tracking(const RobotModel& robot, const Plan& plan, const Curve& curve,
                     ViolationLog& violations) {
  TrackingVerifier(robot, plan, curve, violations).run();
}

}  // namespace morphe::verify
