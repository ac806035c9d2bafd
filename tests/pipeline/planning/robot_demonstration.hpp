#pragma once

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/planning/planner.hpp"

namespace morphe::test {

/// A person who moves as the reference robot does: 1.5 s of minimum jerk to a grasp that is held
/// for half a second. The robot's shoulder is the person's, so that world and base are one, and
/// every goal is met by a posture that is known.
struct RobotDemonstration {
  robot::Robot robot{
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table};
  planning::PipelineConfig config;
  HumanMotion motion;
  Movement movement;
  JointVector first, last;  ///< the robot's own postures [n]

  RobotDemonstration() {
    last = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
    last.head(7) << 1.2, -1.0, -1.6, 1.6, 2.5, 0.7, 0.5;
    last.tail(15) << 0.1, 0.5, 0.4, 0, 0.3, 0.3, 0, 0.4, 0.3, 0, 0.4, 0.3, 0, 0.4, 0.3;
    first = last;
    first.head(7) += (Eigen::VectorXd(7) << 0.3, -0.2, 0.1, -0.3, 0.1, 0.1, 0).finished();
    constexpr std::size_t kFrames = 201;
    constexpr double kStep_s = 0.01, kReach_s = 1.5;
    motion.tip = {kFrames, kFingerCount, unknown_point()};
    motion.tip_orientation = {kFrames, kFingerCount, unknown_rotation()};
    motion.finger_joint = {kFrames, kFingerCount, unknown_point()};
    std::vector<Pose> frames;
    for (std::size_t i = 0; i < kFrames; ++i) {
      motion.time.push_back(kStep_s * static_cast<double>(i));
      const double u = std::min(1.0, motion.time.back() / kReach_s);
      robot::forward_kinematics(
          robot, first + u * u * u * (10 - 15 * u + 6 * u * u) * (last - first), frames);
      const auto at = [&](int frame) -> Vec3 {
        return frames[static_cast<std::size_t>(frame)].translation();
      };
      motion.shoulder.push_back(at(robot.shoulder_frame));
      motion.elbow.push_back(at(robot.arm_centres.front()));
      motion.wrist.push_back(at(robot.palm_frame));
      motion.wrist_orientation.emplace_back(
          frames[static_cast<std::size_t>(robot.palm_frame)].linear());
      for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
        const auto finger = static_cast<std::size_t>(robot.tips[tip].finger);
        motion.tip(i, finger) = robot::tip_pose(robot, frames, tip).translation();
      }
    }
    movement.end_s = motion.time.back();
    movement.phases = {{PhaseKind::reach, 0, kReach_s, 1, 1, 1},
                       {PhaseKind::grasp, kReach_s, movement.end_s, 1, 1, 1}};
    config.scene.table.infer = config.scene.target.infer = false;
    config.map.key_frames = 3;
    config.map.starts = 8;
    config.map.reach_search_starts = 8;
  }

  planning::PlanningInputs planner() const { return {config, robot}; }
};

}  // namespace morphe::test
