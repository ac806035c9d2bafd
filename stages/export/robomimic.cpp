#include "stages/export/robomimic.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/motion/input_error.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/store/layout.hpp"

namespace morphe::exports {
namespace {

constexpr int kGymType = 2;  ///< type of robomimic's environments without a robot simulator

Eigen::RowVector4d wxyz(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }

}  // namespace

RobomimicHeader robomimic_header(const RobotModel& robot, double rate_hz,
                                 const std::string& not_verified) {
  for (int j = 0; j < std::ssize(robot.joint_names); ++j) {
    if (std::isfinite(robot.upper[j] - robot.lower[j])) continue;
    throw InputError(
        fmt::format("joint {} has no limits to scale actions by", robot.joint_names[j]));
  }
  nlohmann::ordered_json tips = nlohmann::ordered_json::array();
  for (const RobotModel::Tip& tip : robot.tips) tips.push_back(tip.name);
  const nlohmann::ordered_json env_args = {
      {"env_name", robot.name},
      {"type", kGymType},
      {"env_kwargs",
       {{"control_freq", rate_hz}, {"joint_names", robot.joint_names}, {"tip_names", tips}}}};
  return {env_args.dump(), robot.joint_names, robot.lower, robot.upper, not_verified};
}

RobomimicDemo robomimic_demo(const RobotModel& robot, const Plan& plan, bool target) {
  const Trajectory& t = plan.trajectory;
  const Eigen::Index samples = std::ssize(t.time), tips = std::ssize(robot.tips);
  JointRows tip_positions(samples, 3 * tips), palm_position(samples, 3), palm_quat(samples, 4);
  JointRows phase = JointRows::Zero(samples, enum_count<PhaseKind>());
  std::vector<Pose> base_from_frame;
  for (Eigen::Index i = 0; i < samples; ++i) {
    robot::forward_kinematics(robot, t.position.row(i).transpose(), base_from_frame);
    for (Eigen::Index k = 0; k < tips; ++k) {
      tip_positions.block<1, 3>(i, 3 * k) =
          robot::tip_pose(robot, base_from_frame, k).translation().transpose();
    }
    const Pose& palm = base_from_frame[robot.palm_frame];
    palm_position.row(i) = palm.translation().transpose();
    palm_quat.row(i) = wxyz(Quat(palm.linear()));
    // A quaternion and its negative are the same rotation; keep the sign continuous.
    if (i > 0 && palm_quat.row(i).dot(palm_quat.row(i - 1)) < 0) palm_quat.row(i) *= -1;
    phase(i, static_cast<int>(t.phase[i])) = 1;
    if (main_phase_of(t.phase[i]) != t.phase[i]) {
      const PhaseKind main = main_phase_at(plan.movement.phases, t.demonstration_time[i]);
      phase(i, static_cast<int>(main)) = 1;
    }
  }
  RobomimicDemo demo{fmt::format("{}/{:03}", plan.demonstration, plan.movement.index),
                     plan.subject,
                     plan.task,
                     std::string(name_of(plan.status())),
                     t.position.bottomRows(samples - 1),
                     {{"joint_positions", t.position},
                      {"joint_velocities", t.velocity},
                      {"tip_positions", tip_positions},
                      {"palm_position", palm_position},
                      {"palm_orientation", palm_quat},
                      {"demonstration_phase", phase}},
                     plan.grasp.sample >= 0 ? plan.grasp : Grasp(),
                     store::joint_unit(robot.has_prismatic_joint()),
                     plan.flags,
                     t.phase};
  if (target) {
    const Pose& object = plan.grasp.base_from_object;
    demo.observations.emplace_back("target_position",
                                   object.translation().transpose().replicate(samples, 1));
    demo.observations.emplace_back("target_orientation",
                                   wxyz(Quat(object.linear())).replicate(samples, 1));
  }
  return demo;
}

}  // namespace morphe::exports
