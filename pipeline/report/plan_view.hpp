#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/collision/world.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::report {

/// A motion as it is displayed: T samples that a display can show and those with extreme values
/// (the greatest velocity, acceleration and jerk of each joint, and the least clearance).
struct DisplayMotion {
  /// Approach, trajectory or retreat; path or mapped for an infeasible plan.
  std::string name;
  /// [T] time from 0 and time in the demonstration [s].
  std::vector<double> time, demonstration_time;
  /// [T] row in the file.
  std::vector<int> sample;
  /// [T, n] joint positions [rad or m].
  JointRows position;
  /// The ratios to the limits [T, n], with sign; for jerk the greatest value up to the next
  /// displayed sample. They are empty for path and mapped.
  JointRows velocity, acceleration, jerk;
  /// [T] phase of the movement.
  std::vector<PhaseKind> phase;
  /// [T] origin of the sample.
  std::vector<SampleOrigin> origin;
  /// [T] clearance from the file, empty for path and mapped.
  std::vector<double> clearance;
  /// [T] pair with the least slack; capsule -1 if there is no pair.
  std::vector<collision::PairSeparation> nearest;
  /// Two bodies that touch in a row.
  struct Touch {
    /// Row, capsule, and the other capsule or (number of capsules + object).
    int row = 0, capsule = 0, other = 0;
  };
  /// Pairs at most kTouchDistance_m apart.
  std::vector<Touch> touching_pairs;
  /// [T] base_from_object while the target is in the hand or after its release.
  std::vector<Pose> target_pose;
  /// [T] 0 while the target is at its recorded pose.
  std::vector<std::uint8_t> target_moved;
  /// [T, m] position error [m] and full angle [rad], NaN if there is no goal.
  JointRows tip_error, tip_orientation_error;
  /// [T] metric A, summed over the joint centres of the arm [m^2].
  std::vector<double> humanlikeness;
  /// [T] mean speed of the tips with goals [m/s].
  std::vector<double> mean_tip_speed;
};
/// The distance below which two bodies are shown as touching [m].
inline constexpr double kTouchDistance_m = 1e-3;
/// The rate of the displayed samples [Hz].
inline constexpr double kDisplayRate_hz = 60;

/// The instant at which an infeasible plan fails, with a description of the failure.
struct WorstInstant {
  /// The time in the demonstration [s].
  double demonstration_s = 0;
  /// The description of the failure.
  std::string sentence;
};

/// The displayed data of a plan, computed from the numbers in the file by the same kinematics and
/// distances with which it was planned.
struct PlanView {
  /// The pose of the base in the world: X to the person's right, Y forward, Z up, origin at the
  /// person's shoulder at the beginning of the movement (the first position at which it was seen;
  /// the base if it was not seen).
  Pose world_from_base = Pose::Identity();
  /// False if the file does not contain the orientation of the base; the world is then the base.
  bool upright = false;
  /// The motions in the order in which they are played.
  std::vector<DisplayMotion> motions;
  /// [F] mean speed of the goal tips [m/s], NaN if unknown.
  std::vector<double> human_speed;
  /// The instant at which an infeasible plan fails.
  std::optional<WorstInstant> worst;
  /// Advice for an infeasible plan.
  std::vector<std::string> advice;
};

/// Computes the displayed data of a plan. `world_from_base` is taken from the config in the file,
/// empty if unknown.
PlanView make_plan_view(const robot::Robot& robot,
                        const std::optional<Eigen::Matrix3d>& world_from_base, const Plan& plan);

/// Converts a goal of the arm to the position of the human's point by removing the common base
/// offset.
Vec3 without_common_offset(const Goals& goals, const Vec3& in_common_base);

}  // namespace morphe::report
