#include <algorithm>
#include <cmath>

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/pad.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

/// What a certificate may miss between its samples.
constexpr double kBetween_m = 1e-4;
/// Where a tip moves less than this against its goal, what is not proved counts as a violation.
constexpr double kTipBand_m = 1e-5;
/// More travel than this between two samples is not worth bisecting: it counts as a violation.
constexpr double kTipHopeless_m = 10;
/// So often intervals are halved; what is not proved by then counts as a violation.
constexpr int kTipHalvings = 1000000;

/// A stretch of a piece without a frame of the goals or a border of a phase inside: goals are
/// linear there, and one tolerance holds.
struct Stretch {
  double from = 0, to = 1;  ///< shares of the piece
};

class TipJudge {
 public:
  TipJudge(const RobotTable& robot, const Plan& plan, const Curve& curve, ViolationRuns& runs)
      : robot_(robot), plan_(plan), curve_(curve), runs_(runs), pads_(pad_balls(robot)) {
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const RobotTable::Tip& own = robot.tips[tip];
      double reach = own.transform.translation().norm(), slip = 0;
      if (pads_[tip].capsule >= 0) {
        reach = std::max(reach, pads_[tip].centre.norm());
        slip = (pads_[tip].centre - own.transform.translation()).norm();
      }
      levers_.push_back(point_lever(robot, own.frame, reach));
      slips_.push_back(slip);
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
      judge_piece(piece, before, after);
    }
  }

 private:
  double tolerance_at(double time_s) const {
    return is_grasping(plan_.movement.phases, time_s) ? plan_.tolerances.tracking_grasp
                                                      : plan_.tolerances.tracking;
  }

  /// NaN: no goal there.
  double error_of(std::size_t tip, double time_s) const {
    const std::optional<Vec3> goal = goal_at(plan_.goals, tip, time_s);
    if (!goal) return kNotSeen;
    const Vec3 asked = asked_point(robot_, pads_, plan_.goals, tip, time_s);
    return (in_base(poses_, robot_.tips[tip].frame, asked) - *goal).norm();
  }

  std::vector<double> errors_at_sample(std::size_t sample) {
    const Trajectory& trajectory = *curve_.trajectory;
    const double time_s = trajectory.demonstration_time[sample];
    frame_poses(robot_, trajectory.position.row(static_cast<Eigen::Index>(sample)).transpose(),
                poses_);
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

  /// What all tips are sure to hold by how far they and their goals go is not looked into.
  void judge_piece(std::size_t piece, const std::vector<double>& before,
                   const std::vector<double>& after) {
    const Trajectory& trajectory = *curve_.trajectory;
    const double begin_s = trajectory.demonstration_time[piece];
    const double end_s = trajectory.demonstration_time[piece + 1];
    const double least =
        kBetween_m + std::min(plan_.tolerances.tracking_grasp, plan_.tolerances.tracking);
    std::vector<std::size_t> open;
    for (std::size_t tip = 0; tip < robot_.tips.size(); ++tip) {
      const double both =
          before[tip] + after[tip] + tip_way(piece, tip, 1) + goal_way(tip, begin_s, end_s);
      if (!(0.5 * both <= least)) open.push_back(tip);
    }
    if (open.empty()) return;
    for (const Stretch& stretch : stretches(begin_s, end_s)) {
      const double middle_s = std::lerp(begin_s, end_s, 0.5 * (stretch.from + stretch.to));
      std::vector<std::size_t> asked;
      for (const std::size_t tip : open)
        if (goal_at(plan_.goals, tip, middle_s)) asked.push_back(tip);
      bisect(piece, stretch, tolerance_at(middle_s), asked);
    }
  }

  std::vector<Stretch> stretches(double begin_s, double end_s) const {
    std::vector<Stretch> parts{{}};
    const auto first = std::ranges::upper_bound(borders_, begin_s);
    for (auto border = first; border != borders_.end() && *border < end_s; ++border) {
      const double share = (*border - begin_s) / (end_s - begin_s);
      if (share <= parts.back().from) continue;
      parts.back().to = share;
      parts.push_back({share, 1});
    }
    return parts;
  }

  /// Proves tips near enough for s in [from, to], all of which have goals there.
  void bisect(std::size_t piece, const Stretch& part, double tolerance,
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
      const double way = tip_way(piece, tip, half) + half_s * goal_speed(tip, middle_s);
      if (error + way <= tolerance + kBetween_m) continue;
      const bool violated = !(error <= tolerance + kBetween_m);
      if (!violated && way > kTipBand_m && way < kTipHopeless_m && halvings_left_ > 0) {
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

  /// At most so far a tip goes in a share of a piece.
  double tip_way(std::size_t piece, std::size_t tip, double share) const {
    const auto& time = curve_.trajectory->time;
    return share * (time[piece + 1] - time[piece]) *
           curve_.speed.row(static_cast<Eigen::Index>(piece)).dot(levers_[tip]);
  }

  /// Of a goal, and of the point of the link that it is for, between the frames around a time [m/s
  /// of the demonstration].
  double goal_speed(std::size_t tip, double time_s) const {
    const Goals& goals = plan_.goals;
    const GoalShare at = goal_share(goals, time_s);
    if (at.before == at.after) return 0;
    double way = (goals.tip_position(at.after, tip) - goals.tip_position(at.before, tip)).norm();
    if (goals.pad_share.rows > 0)
      way +=
          slips_[tip] * std::abs(goals.pad_share(at.after, tip) - goals.pad_share(at.before, tip));
    return way / (goals.time[at.after] - goals.time[at.before]);
  }

  /// At most so far a goal, and the point that it is for, go between two times; NaN: not told.
  double goal_way(std::size_t tip, double begin_s, double end_s) const {
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

  const RobotTable& robot_;
  const Plan& plan_;
  const Curve& curve_;
  ViolationRuns& runs_;
  std::vector<PadBall> pads_;
  int halvings_left_ = kTipHalvings;
  std::vector<JointVector> levers_;  ///< [tips]
  std::vector<double> slips_;        ///< [tips] from the tip to its pad [m]
  std::vector<double> borders_;      ///< of goals and phases [demonstration time, s]
  std::vector<Pose> poses_;
  JointVector q_;
};

}  // namespace

void judge_tracking(const RobotTable& robot, const Plan& plan, const Curve& curve,
                    ViolationRuns& runs) {
  TipJudge(robot, plan, curve, runs).run();
}

}  // namespace morphe::verify
