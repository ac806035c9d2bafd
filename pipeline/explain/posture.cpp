#include "pipeline/explain/posture.hpp"

#include <cmath>
#include <vector>

#include "core/humanlike/arm_headroom.hpp"
#include "core/math/statistics.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::explain {
namespace {

/// Sets the least errors, the means over all samples, if the robot can turn its elbow.
void set_least_errors(const robot::Robot& robot, const Plan& plan, PostureSummary& summary) {
  if (!summary.has_elbow_circle) return;
  std::vector<double> upper_arm, forearm;
  std::vector<Pose> frames;
  for (int k = 0; k < std::ssize(plan.trajectory.time); ++k) {
    robot::forward_kinematics(robot, plan.trajectory.position.row(k).transpose(), frames);
    const humanlike::ArmPoints human =
        humanlike::arm_points(plan.goals, plan.trajectory.demonstration_time[k]);
    const humanlike::LeastDirectionErrors least =
        humanlike::least_direction_errors(human, humanlike::arm_points(robot, frames));
    upper_arm.push_back(least.upper_arm);
    forearm.push_back(least.forearm);
  }
  summary.upper_arm.least = math::mean(upper_arm);
  summary.forearm.least = math::mean(forearm);
  if (!std::isnan(summary.swivel.driven)) summary.swivel.least = 0;
}

}  // namespace

PostureSummary posture_summary(const robot::Robot& robot, const Plan& plan) {
  PostureSummary summary;
  if (!plan.has_trajectory() || robot.arm_centres.empty()) return summary;
  const Certificate& certificate = plan.certificate;
  summary.has_elbow_circle = humanlike::has_elbow_circle(robot, plan.trajectory.position);
  summary.upper_arm.driven = summary.upper_arm.least = certificate.upper_arm_error_mean;
  summary.forearm.driven = summary.forearm.least = certificate.forearm_error_mean;
  summary.swivel.driven = summary.swivel.least = certificate.swivel_error_mean;
  summary.palm.driven = certificate.palm_error_mean;
  set_least_errors(robot, plan, summary);
  summary.wrist = wrist_offset(robot, plan);
  summary.palm_floor = palm_floor(robot, plan);
  summary.palm.least = summary.palm_floor.whole_robot;
  summary.upper_arm.with_tips = summary.palm_floor.whole_arm.upper_arm;
  summary.forearm.with_tips = summary.palm_floor.whole_arm.forearm;
  summary.palm.with_tips = summary.palm_floor.whole_arm.palm;
  for (PostureFigure* figure : {&summary.upper_arm, &summary.forearm, &summary.swivel})
    figure->causes = causes_of_direction(
        figure->driven, std::fmin(figure->least, figure->with_tips), summary.wrist);
  summary.palm.causes = causes_of_palm(summary.palm.driven, summary.palm_floor);
  return summary;
}

}  // namespace morphe::explain
