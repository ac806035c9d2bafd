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
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

bool verify_motion_arrays(const RobotModel& robot, const Trajectory& trajectory,
                          ViolationCollector& runs) {
  const auto samples = static_cast<Eigen::Index>(trajectory.samples());
  const auto joints = static_cast<Eigen::Index>(robot.joints());
  const auto fits = [&](const JointRows& rows) {
    return rows.rows() == samples && rows.cols() == joints;
  };
  const bool whole = samples >= 2 && fits(trajectory.position) && fits(trajectory.velocity) &&
                     fits(trajectory.acceleration) &&
                     trajectory.demonstration_time.size() == trajectory.samples();
  if (!whole) {
    runs.note_plan("structure", "trajectory", static_cast<double>(samples), 2);
    return false;
  }
  bool good = true;
  const auto finite = [&](bool is_finite, const char* subject) {
    if (!is_finite) runs.note_plan("finite", subject, kUnknown, kUnknown);
    good = good && is_finite;
  };
  finite(all_finite(trajectory.time), "time");
  finite(trajectory.position.allFinite(), "position");
  finite(trajectory.velocity.allFinite(), "velocity");
  finite(trajectory.acceleration.allFinite(), "acceleration");
  finite(all_finite(trajectory.demonstration_time), "demonstration_time");
  if (!good) return false;

  const auto wrong_time = [&](const char* subject, std::size_t sample, double value, double limit) {
    runs.note("time", subject,
              {static_cast<int>(2 * sample), static_cast<int>(sample), trajectory.time[sample]},
              value, limit, limit - value);
    good = false;
  };
  const auto& time = trajectory.time;
  const auto& demonstration = trajectory.demonstration_time;
  if (time[0] != 0) wrong_time("time", 0, time[0], 0);
  for (std::size_t k = 1; k < time.size(); ++k) {
    if (time[k] <= time[k - 1]) wrong_time("time", k, time[k], time[k - 1]);
    if (demonstration[k] < demonstration[k - 1])
      wrong_time("demonstration_time", k, demonstration[k], demonstration[k - 1]);
  }
  return good;
}

/// Returns the fault in the values of a robot whose indices are valid; nullptr if there is no
/// fault.
const char* robot_fault(const RobotModel& robot) {
  const auto positive = [](const JointVector& limits) {
    return limits.allFinite() && (limits.array() > 0).all();
  };
  if (!robot.lower.allFinite() || !robot.upper.allFinite()) return "robot/lower, upper";
  if (!((robot.upper - robot.lower).array() >= 0).all()) return "robot/lower, upper";
  if (!positive(robot.velocity)) return "robot/velocity";
  if (!positive(robot.acceleration)) return "robot/acceleration";
  if (!positive(robot.jerk)) return "robot/jerk";
  const auto rigid = [](const Pose& pose) {
    return pose.matrix().allFinite() && pose.linear().isUnitary(1e-6) &&
           pose.linear().determinant() > 0;
  };
  for (const RobotModel::Frame& frame : robot.frames) {
    const bool turns = std::abs(frame.axis.norm() - 1) < 1e-6 && std::isfinite(frame.ratio) &&
                       std::isfinite(frame.offset);
    if (!rigid(frame.transform) || (frame.joint >= 0 && !turns)) return "robot/frames";
  }
  for (const RobotModel::CoupledLimit& own : robot.coupled_limits) {
    if (!(own.lower <= own.upper && own.velocity > 0 && own.acceleration > 0 && own.jerk > 0))
      return "robot/coupled_limits";
  }
  for (const RobotModel::BrakingCurve& curve : robot.braking_curves) {
    const double sum =
        curve.twice_deceleration + curve.velocity_offset + curve.lower_end + curve.upper_end;
    if (!(std::isfinite(sum) && curve.twice_deceleration > 0 && curve.velocity_offset >= 0))
      return "robot/braking_curves";
  }
  for (const RobotModel::Tip& tip : robot.tips)
    if (!rigid(tip.transform)) return "robot/tips";
  for (const RobotModel::Capsule& capsule : robot.capsules)
    if (!is_known(capsule.from) || !is_known(capsule.to) || !(capsule.radius >= 0))
      return "robot/capsules";
  return nullptr;
}

bool verify_object_arrays(const SceneObject& object, ViolationCollector& runs) {
  const std::size_t poses = object.time.size();
  const bool fits = poses > 0 && object.position.size() == poses &&
                    object.orientation.size() == poses && has_valid_shape(object);
  if (!fits) {
    runs.note_plan("structure", object.name, kUnknown, kUnknown);
    return false;
  }
  bool finite = poses == 1 || all_finite(object.time);
  for (const Vec3& position : object.position) finite = finite && is_known(position);
  for (const Quat& orientation : object.orientation)
    finite = finite && std::abs(orientation.norm() - 1) < 1e-6;
  if (!finite) runs.note_plan("finite", object.name, kUnknown, kUnknown);
  const bool ordered = std::adjacent_find(object.time.begin(), object.time.end(),
                                          std::greater_equal<>()) == object.time.end();
  if (!ordered) runs.note_plan("time", object.name, kUnknown, kUnknown);
  return finite && ordered;
}

bool verify_goal_arrays(const RobotModel& robot, const Plan& plan, ViolationCollector& runs) {
  const Goals& goals = plan.goals;
  if (goals.frames() == 0) return true;
  if (goals.tip_position.rows != goals.frames() || goals.tip_position.cols != robot.tips.size()) {
    runs.note_plan("structure", "goals", static_cast<double>(goals.tip_position.cols),
                   static_cast<double>(robot.tips.size()));
    return false;
  }
  const bool ordered = std::adjacent_find(goals.time.begin(), goals.time.end(),
                                          std::greater_equal<>()) == goals.time.end();
  if (!ordered || !all_finite(goals.time)) {
    runs.note_plan("time", "goals", kUnknown, kUnknown);
    return false;
  }
  const Array2D<double>& share = goals.tip_to_pad_share;
  if ((share.rows != 0 && (share.rows != goals.frames() || share.cols != robot.tips.size())) ||
      (!goals.auto_closed.empty() && goals.auto_closed.size() != robot.tips.size())) {
    runs.note_plan("structure", "goals", static_cast<double>(share.cols),
                   static_cast<double>(robot.tips.size()));
    return false;
  }
  const auto beyond =
      std::ranges::find_if(share.values, [](double value) { return !(value >= 0 && value <= 1); });
  if (beyond != share.values.end()) {
    runs.note_plan("structure", "goals/tip_to_pad_share", *beyond, 1);
    return false;
  }
  const auto neither =
      std::ranges::find_if(goals.auto_closed, [](auto value) { return value > 1; });
  if (neither != goals.auto_closed.end()) {
    runs.note_plan("structure", "goals/auto_closed", *neither, 1);
    return false;
  }
  return true;
}

/// Checks that the trajectory covers the goals' time: it must neither stand still, nor omit a part,
/// nor continue beyond the goals.
void verify_time_coverage(const Plan& plan, ViolationCollector& runs) {
  if (plan.goals.time.empty()) return;
  const auto& reached = plan.trajectory.demonstration_time;
  const auto meets = [&](double own_s, double goal_s) {
    if (!(std::abs(own_s - goal_s) <= kCoverageTolerance_s))
      runs.note_plan("time", "demonstration_time", own_s, goal_s);
  };
  meets(reached.front(), plan.goals.time.front());
  meets(reached.back(), plan.goals.time.back());
}

}  // namespace

bool verify_structure(const RobotModel& robot, const Plan& plan, ViolationCollector& runs) {
  const bool empty = plan.trajectory.samples() == 0;
  if (plan.has_trajectory() == empty) {
    runs.note_plan("structure", "trajectory", static_cast<double>(plan.trajectory.samples()), 0);
    return false;
  }
  if (!plan.has_trajectory()) return false;
  if (!plan.remaining_findings.empty())
    runs.note_plan("structure", "remaining_findings",
                   static_cast<double>(plan.remaining_findings.size()), 0);
  if (const char* fault = robot_fault(robot)) {
    runs.note_plan("structure", fault, kUnknown, kUnknown);
    return false;
  }
  bool good = verify_motion_arrays(robot, plan.trajectory, runs);
  good = verify_goal_arrays(robot, plan, runs) && good;
  for (const SceneObject& object : plan.scene.objects)
    good = verify_object_arrays(object, runs) && good;
  if (!good || !verify_magnitudes(robot, plan, runs)) return false;
  verify_time_coverage(plan, runs);
  return true;
}

bool verify_approach_retreat_structure(const RobotModel& robot, const Plan& plan,
                                       const Trajectory& transfer, bool at_its_end,
                                       ViolationCollector& runs) {
  if (transfer.samples() == 0 || plan.trajectory.samples() == 0) return false;
  if (!verify_motion_arrays(robot, transfer, runs) || !verify_magnitudes(transfer, runs))
    return false;
  const JointRows& way = plan.trajectory.position;
  const double gap = at_its_end
                         ? (transfer.position.bottomRows(1) - way.topRows(1)).cwiseAbs().maxCoeff()
                         : (transfer.position.topRows(1) - way.bottomRows(1)).cwiseAbs().maxCoeff();
  if (!(gap <= kJunctionTolerance))
    runs.note_plan("structure", at_its_end ? "approach" : "retreat", gap, kJunctionTolerance);
  return true;
}

}  // namespace morphe::verify
