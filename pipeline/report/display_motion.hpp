#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/collision/world.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::report {

/// A motion as it is displayed, in T rows: samples of a trajectory, selected by
/// select_display_rows(), or all samples of a path.
struct DisplayMotion {
  std::string name;  ///< approach, trajectory or retreat; path or mapped for an infeasible plan
  std::vector<double> time, demonstration_time;  ///< [T] from 0, of the recording [s]
  std::vector<int> sample;                       ///< [T] index in the file
  JointRows position;                            ///< [T, n] joint positions [rad or m]
  /// Signed ratios to the limits [T, n], of the jerk the greatest until the next row; empty for
  /// paths.
  JointRows velocity, acceleration, jerk;
  std::vector<PhaseKind> phase;      ///< [T]
  std::vector<SampleOrigin> origin;  ///< [T]
  std::vector<double> clearance;     ///< [T] as in the file; empty for path and mapped
  std::vector<collision::PairSeparation> nearest;  ///< [T] pair with least slack; first -1: none
  /// Two bodies that touch in a row.
  struct Touch {
    int row = 0, first = 0, second = 0;  ///< row and bodies (body_index())
  };
  std::vector<Touch> touching_pairs;           ///< pairs at most kTouchDistance_m apart
  std::vector<Pose> target_pose;               ///< [T] base_from_object where the target has moved
  std::vector<std::uint8_t> target_moved;      ///< [T] 0 while the target moves as recorded, else 1
  JointRows tip_error, tip_orientation_error;  ///< [T, m] [m], full angle [rad]; NaN without a goal
  JointRows arm_error;  ///< [T, 4] of upper arm, forearm, swivel angle and palm [rad]; NaN: unknown
  std::vector<double> humanlikeness;   ///< [T] metric A, summed over the arm's centres [m^2]
  std::vector<double> mean_tip_speed;  ///< [T] of the tips with goals [m/s]
};
/// The distance below which two bodies are shown as touching.
inline constexpr double kTouchDistance_m = 1e-3;
/// The rate of the displayed samples.
inline constexpr double kDisplayRate_hz = 60;

/// Returns the index of a capsule or object, where the scene's objects follow the robot's capsules.
int body_index(const RobotModel& robot, bool is_object, int body);

/// Builds the displayed motion of a trajectory of a plan. Errors of tips and arm and metric A are
/// only computed if `follows_goals`, which is false for approach and retreat. In `world`, the
/// target must be attached (collision::attach_target).
DisplayMotion display_trajectory(const std::string& name, const collision::CollisionWorld& world,
                                 const Plan& plan, const Trajectory& trajectory,
                                 bool follows_goals);

/// Builds the displayed motion of a path with joint positions [T, n], T > 0. Its time begins at 0.
DisplayMotion display_path(const std::string& name, const collision::CollisionWorld& world,
                           const Plan& plan, const JointRows& position,
                           const std::vector<double>& demonstration_time,
                           const std::vector<SampleOrigin>& origin);

}  // namespace morphe::report
