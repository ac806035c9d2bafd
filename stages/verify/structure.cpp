#include "stages/verify/structure.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "stages/verify/approach_retreat.hpp"
#include "stages/verify/magnitudes.hpp"
#include "stages/verify/separation.hpp"

namespace morphe::verify {
namespace {

constexpr double kCoverageTolerance_s = 1e-6;

bool all_finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

bool is_increasing(const std::vector<double>& values) {
  return std::ranges::adjacent_find(values, std::greater_equal<>()) == values.end();
}

bool verify_motion_arrays(const RobotModel& robot, const Trajectory& trajectory,
                          ViolationLog& violations) {
  const std::vector<double>& time = trajectory.time;
  const std::vector<double>& demonstration_time = trajectory.demonstration_time;
  const auto fits = [&](const JointRows& rows) {
    return rows.rows() == std::ssize(time) && rows.cols() == std::ssize(robot.joint_names);
  };
  if (time.size() < 2 || !fits(trajectory.position) || !fits(trajectory.velocity) ||
      !fits(trajectory.acceleration) || demonstration_time.size() != time.size()) {
    violations.note_plan("structure", "trajectory", static_cast<double>(time.size()), 2);
    return false;
  }
  bool valid = true;
  const auto require_finite = [&](bool is_finite, const char* subject) {
    if (!is_finite) violations.note_plan("finite", subject, kUnknown, kUnknown);
    valid = valid && is_finite;
  };
  require_finite(all_finite(time), "time");
  require_finite(trajectory.position.allFinite(), "position");
  require_finite(trajectory.velocity.allFinite(), "velocity");
  require_finite(trajectory.acceleration.allFinite(), "acceleration");
  require_finite(all_finite(demonstration_time), "demonstration_time");
  if (!valid) return false;

  const auto note_time = [&](const char* subject, int sample, double value, double limit) {
    const CurvePoint point = point_at_sample(trajectory, sample);
    violations.note("time", subject, point, value, limit, limit - value);
    valid = false;
  };
  if (time[0] != 0) note_time("time", 0, time[0], 0);
  for (int k = 1; k < std::ssize(time); ++k) {
    if (time[k] <= time[k - 1]) note_time("time", k, time[k], time[k - 1]);
    if (demonstration_time[k] < demonstration_time[k - 1])
      note_time("demonstration_time", k, demonstration_time[k], demonstration_time[k - 1]);
  }
  return valid;
}

/// Returns the table with the first fault in a robot's values, nullptr if there is no fault.
const char* faulty_robot_table(const RobotModel& robot) {
  const auto positive = [](const JointVector& limits) {
    return limits.allFinite() && (limits.array() > 0).all();
  };
  if (!robot.lower.allFinite() || !robot.upper.allFinite() ||
      !((robot.upper - robot.lower).array() >= 0).all())
    return "robot/lower, upper";
  if (!positive(robot.velocity)) return "robot/velocity";
  if (!positive(robot.acceleration)) return "robot/acceleration";
  if (!positive(robot.jerk)) return "robot/jerk";
  const auto rigid = [](const Pose& pose) {
    return pose.matrix().allFinite() && pose.linear().isUnitary(1e-6) &&
           pose.linear().determinant() > 0;
  };
  for (const RobotModel::Frame& frame : robot.frames) {
    const bool has_axis = std::abs(frame.axis.norm() - 1) < 1e-6 && std::isfinite(frame.ratio) &&
                          std::isfinite(frame.offset);
    if (!rigid(frame.transform) || (frame.joint >= 0 && !has_axis)) return "robot/frames";
  }
  for (const RobotModel::CoupledLimit& own : robot.coupled_limits)
    if (!(own.lower <= own.upper && own.velocity > 0 && own.acceleration > 0 && own.jerk > 0))
      return "robot/coupled_limits";
  for (const RobotModel::BrakingCurve& own : robot.braking_curves) {
    const double sum = own.twice_deceleration + own.velocity_offset + own.lower_end + own.upper_end;
    if (!(std::isfinite(sum) && own.twice_deceleration > 0 && own.velocity_offset >= 0))
      return "robot/braking_curves";
  }
  for (const RobotModel::Tip& tip : robot.tips)
    if (!rigid(tip.transform)) return "robot/tips";
  for (const RobotModel::Capsule& own : robot.capsules)
    if (!is_known(own.from) || !is_known(own.to) || !(own.radius >= 0)) return "robot/capsules";
  return nullptr;
}

bool verify_object_arrays(const SceneObject& object, ViolationLog& violations) {
  const std::size_t poses = object.time.size();
  const bool fits = poses > 0 && object.position.size() == poses &&
                    object.orientation.size() == poses && has_valid_shape(object);
  if (!fits) {
    violations.note_plan("structure", object.name, kUnknown, kUnknown);
    return false;
  }
  bool finite = poses == 1 || all_finite(object.time);
  for (const Vec3& position : object.position) finite = finite && is_known(position);
  for (const Quat& q : object.orientation) finite = finite && std::abs(q.norm() - 1) < 1e-6;
  if (!finite) violations.note_plan("finite", object.name, kUnknown, kUnknown);
  const bool ordered = is_increasing(object.time);
  if (!ordered) violations.note_plan("time", object.name, kUnknown, kUnknown);
  return finite && ordered;
}

bool verify_goal_arrays(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  const Goals& goals = plan.goals;
  const Array2D<double>& pad_share = goals.tip_to_pad_share;
  const std::size_t frames = goals.time.size(), tips = robot.tips.size();
  if (frames == 0) return true;
  const auto reject = [&](const char* cause, const char* subject, double value, double limit) {
    violations.note_plan(cause, subject, value, limit);
    return false;
  };
  if (goals.tip_position.rows != frames || goals.tip_position.cols != tips)
    return reject("structure", "goals", static_cast<double>(goals.tip_position.cols),
                  static_cast<double>(tips));
  if (!is_increasing(goals.time) || !all_finite(goals.time))
    return reject("time", "goals", kUnknown, kUnknown);
  if ((pad_share.rows != 0 && (pad_share.rows != frames || pad_share.cols != tips)) ||
      (!goals.auto_closed.empty() && goals.auto_closed.size() != tips))
    return reject("structure", "goals", static_cast<double>(pad_share.cols),
                  static_cast<double>(tips));
  for (const double share : pad_share.values)
    if (!(share >= 0 && share <= 1)) return reject("structure", "goals/tip_to_pad_share", share, 1);
  for (const std::uint8_t closed : goals.auto_closed)
    if (closed > 1) return reject("structure", "goals/auto_closed", closed, 1);
  return true;
}

void verify_time_coverage(const Plan& plan, ViolationLog& violations) {
  if (plan.goals.time.empty()) return;
  const std::vector<double>& time = plan.trajectory.demonstration_time;
  const auto compare = [&](double own_s, double goal_s) {
    if (!(std::abs(own_s - goal_s) <= kCoverageTolerance_s))
      violations.note_plan("time", "demonstration_time", own_s, goal_s);
  };
  compare(time.front(), plan.goals.time.front());
  compare(time.back(), plan.goals.time.back());
}

}  // namespace

bool verify_structure(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  if (plan.has_trajectory() == plan.trajectory.time.empty()) {
    violations.note_plan("structure", "trajectory", static_cast<double>(plan.trajectory.samples()),
                         0);
    return false;
  }
  if (!plan.has_trajectory()) return false;
  if (!plan.remaining_findings.empty())
    violations.note_plan("structure", "remaining_findings",
                         static_cast<double>(plan.remaining_findings.size()), 0);
  if (const char* faulty_table = faulty_robot_table(robot)) {
    violations.note_plan("structure", faulty_table, kUnknown, kUnknown);
    return false;
  }
  bool valid = verify_motion_arrays(robot, plan.trajectory, violations);
  valid = verify_goal_arrays(robot, plan, violations) && valid;
  for (const SceneObject& object : plan.scene.objects)
    valid = verify_object_arrays(object, violations) && valid;
  if (!valid || !verify_magnitudes(robot, plan, violations)) return false;
  verify_time_coverage(plan, violations);
  return true;
}

bool verify_approach_retreat_structure(const RobotModel& robot, const Plan& plan,
                                       const Trajectory& motion, bool is_approach,
                                       ViolationLog& violations) {
  if (motion.samples() == 0 || plan.trajectory.samples() == 0) return false;
  if (!verify_motion_arrays(robot, motion, violations) || !verify_magnitudes(motion, violations))
    return false;
  const JointRows &own = motion.position, &trajectory = plan.trajectory.position;
  const double gap = is_approach
                         ? (own.bottomRows(1) - trajectory.topRows(1)).cwiseAbs().maxCoeff()
                         : (own.topRows(1) - trajectory.bottomRows(1)).cwiseAbs().maxCoeff();
  if (!(gap <= kJunctionTolerance))
    violations.note_plan("structure", is_approach ? "approach" : "retreat", gap,
                         kJunctionTolerance);
  return true;
}

}  // namespace morphe::verify
