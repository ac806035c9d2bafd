#include <algorithm>
#include <cmath>

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/pad.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

/// The error that a certificate may miss between its samples.
constexpr double kInterSampleTolerance_m = 1e-4;
/// Intervals that are still undecided when a tip moves less than this relative to its goal count as
/// violations.
constexpr double kMinTipTravel_m = 1e-5;
/// Intervals with more travel than this between two samples are not bisected and count as
/// violations.
constexpr double kMaxTipTravel_m = 10;
/// The maximum number of bisections; intervals that are undecided by then count as violations.
constexpr int kMaxTipBisections = 1000000;

/// A part of a piece that contains no frame of the goals and no phase border inside, so that goals
/// are linear and the tolerance is constant.
struct GoalInterval {
  double from = 0, to = 1;  ///< shares of the piece
};

class TrackingVerifier {
 public:
  TrackingVerifier(const RobotModel& robot, const Plan& plan, const Curve& curve,
                   ViolationCollector& runs)
      : robot_(robot), plan_(plan), curve_(curve), runs_(runs), pads_(pad_spheres(robot)) {
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const RobotModel::Tip& own = robot.tips[tip];
      double reach = own.transform.translation().norm(), slip = 0;
      if (pads_[tip].capsule >= 0) {
        reach = std::max(reach, pads_[tip].centre.norm());
        slip = (pads_[tip].centre - own.transform.translation()).norm();
      }
      motion_bounds_.push_back(point_motion_bound(robot, own.frame, reach));
      pad_offsets_.push_back(slip);
    }
    borders_ = plan.goals.time;
    for (const Phase& phase : plan.movement.phases)
      borders_.insert(borders_.end(), {phase.begin_s, phase.end_s});
    std::ranges::sort(borders_);
  }

  void run() {
    if (plan_.goals.frames() == 0) return;
    std::vector<double> before = errors_at_sample(0), after;
    for (std::size_t piece = 0; piece < curve_.pieces; ++piece, std::swap(before, after)) {
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
  double error_of(std::size_t tip, double time_s) const {
    const std::optional<Vec3> goal = goal_at(plan_.goals, tip, time_s);
    if (!goal) return kUnknown;
    const Vec3 asked = tracked_point(robot_, pads_, plan_.goals, tip, time_s);
    return (to_base_frame(poses_, robot_.tips[tip].frame, asked) - *goal).norm();
  }

  std::vector<double> errors_at_sample(std::size_t sample) {
    const Trajectory& trajectory = *curve_.trajectory;
    const double time_s = trajectory.demonstration_time[sample];
    frame_poses(robot_, trajectory.position.row(sample).transpose(), poses_);
    const double tolerance = tolerance_at(time_s);
    std::vector<double> errors;
    for (std::size_t tip = 0; tip < robot_.tips.size(); ++tip) {
      const double error = errors.emplace_back(error_of(tip, time_s));
      if (error > tolerance)
        note(tip, {static_cast<int>(2 * sample), static_cast<int>(sample), trajectory.time[sample]},
             error, tolerance);
    }
    return errors;
  }

  /// Verifies a piece; tips that the motion bounds of tip and goal prove to be near enough are
  /// skipped.
  void verify_piece(std::size_t piece, const std::vector<double>& before,
                    const std::vector<double>& after) {
    const Trajectory& trajectory = *curve_.trajectory;
    const double begin_s = trajectory.demonstration_time[piece];
    const double end_s = trajectory.demonstration_time[piece + 1];
    const double least =
        kInterSampleTolerance_m +
        std::min(plan_.tolerances.tracking_tolerance_grasp, plan_.tolerances.tracking_tolerance);
    std::vector<std::size_t> open;
    for (std::size_t tip = 0; tip < robot_.tips.size(); ++tip) {
      const double both = before[tip] + after[tip] + max_tip_travel(piece, tip, 1) +
                          max_goal_travel(tip, begin_s, end_s);
      if (!(0.5 * both <= least)) open.push_back(tip);
    }
    if (open.empty()) return;
    for (const GoalInterval& stretch : split_at_borders(begin_s, end_s)) {
      const double middle_s = std::lerp(begin_s, end_s, 0.5 * (stretch.from + stretch.to));
      std::vector<std::size_t> asked;
      for (const std::size_t tip : open)
        if (goal_at(plan_.goals, tip, middle_s)) asked.push_back(tip);
      bisect(piece, stretch, tolerance_at(middle_s), asked);
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

  /// Proves that the tips, all of which have goals there, are near enough for s in [from, to].
  void bisect(std::size_t piece, const GoalInterval& part, double tolerance,
              const std::vector<std::size_t>& tips) {
    if (tips.empty()) return;
    const double middle = 0.5 * (part.from + part.to), half = 0.5 * (part.to - part.from);
    const double middle_s = curve_.demonstration_time_at(piece, middle);
    const double half_s = curve_.demonstration_time_at(piece, part.to) - middle_s;
    curve_.position_at(piece, middle, q_);
    frame_poses(robot_, q_, poses_);
    std::vector<std::size_t> open;
    for (const std::size_t tip : tips) {
      const double error = error_of(tip, middle_s);
      const double way = max_tip_travel(piece, tip, half) + half_s * goal_speed(tip, middle_s);
      if (error + way <= tolerance + kInterSampleTolerance_m) continue;
      const bool violated = !(error <= tolerance + kInterSampleTolerance_m);
      if (!violated && way > kMinTipTravel_m && way < kMaxTipTravel_m && halvings_left_ > 0) {
        open.push_back(tip);
      } else {
        note(tip,
             {static_cast<int>(2 * piece + 1), static_cast<int>(middle < 0.5 ? piece : piece + 1),
              curve_.time_at(piece, middle)},
             error, tolerance);
      }
    }
    if (open.empty()) return;
    --halvings_left_;
    bisect(piece, {part.from, middle}, tolerance, open);
    bisect(piece, {middle, part.to}, tolerance, open);
  }

  /// Returns an upper bound of a tip's travel in a share of a piece.
  double max_tip_travel(std::size_t piece, std::size_t tip, double share) const {
    const auto& time = curve_.trajectory->time;
    return share * (time[piece + 1] - time[piece]) *
           curve_.speed.row(piece).dot(motion_bounds_[tip]);
  }

  /// Returns the speed of a goal, plus that of the point of the link to which it applies, between
  /// the frames around a time [m per s of the demonstration].
  double goal_speed(std::size_t tip, double time_s) const {
    const Goals& goals = plan_.goals;
    const GoalInterpolation at = interpolate_goal_frames(goals, time_s);
    if (at.before == at.after) return 0;
    double way = (goals.tip_position(at.after, tip) - goals.tip_position(at.before, tip)).norm();
    if (goals.tip_to_pad_share.rows > 0)
      way += pad_offsets_[tip] * std::abs(goals.tip_to_pad_share(at.after, tip) -
                                          goals.tip_to_pad_share(at.before, tip));
    return way / (goals.time[at.after] - goals.time[at.before]);
  }

  /// Returns an upper bound of the travel of a goal, and of the point to which it applies, between
  /// two times; NaN if unknown.
  double max_goal_travel(std::size_t tip, double begin_s, double end_s) const {
    if (begin_s == end_s) return 0;
    double way = 0, from_s = begin_s;
    const auto& time = plan_.goals.time;
    for (auto frame = std::ranges::upper_bound(time, begin_s);; ++frame) {
      const double to_s = frame == time.end() ? end_s : std::min(*frame, end_s);
      way += (to_s - from_s) * goal_speed(tip, 0.5 * (from_s + to_s));
      if (to_s == end_s) return way;
      from_s = to_s;
    }
  }

  void note(std::size_t tip, const CurvePoint& place, double error, double tolerance) {
    runs_.note("tracking", robot_.tips[tip].name, place, error, tolerance, error - tolerance);
  }

  const RobotModel& robot_;
  const Plan& plan_;
  const Curve& curve_;
  ViolationCollector& runs_;
  std::vector<PadSphere> pads_;
  int halvings_left_ = kMaxTipBisections;
  std::vector<JointVector> motion_bounds_;  ///< [tips]
  std::vector<double> pad_offsets_;         ///< [tips] distance from the tip to its pad [m]
  std::vector<double> borders_;  ///< borders of goal frames and phases [demonstration time, s]
  std::vector<Pose> poses_;
  JointVector q_;
};

}  // namespace

void verify_tracking(const RobotModel& robot, const Plan& plan, const Curve& curve,
                     ViolationCollector& runs) {
  TrackingVerifier(robot, plan, curve, runs).run();
}

}  // namespace morphe::verify
