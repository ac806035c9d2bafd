#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/collision/world.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::report {

/// A motion as it is looked at: of its samples those that a display can show and those that say
/// most (the greatest velocity, acceleration and jerk of each joint, the least clearance), T in
/// all.
struct ShownMotion {
  std::string name;  ///< approach, trajectory, retreat; of an infeasible plan path or mapped
  std::vector<double> time, demonstration_time;  ///< [T] time from 0 [s]
  std::vector<int> sample;                       ///< [T] row in the file
  JointRows position;                            ///< [T, n] [rad or m]
  /// [T, n] shares of the limits, signed; of jerk the greatest up to the next one shown. Empty of
  /// path and mapped.
  JointRows velocity, acceleration, jerk;
  std::vector<PhaseKind> phase;   ///< [T]
  std::vector<Origin> origin;     ///< [T]
  std::vector<double> clearance;  ///< [T] the file's; empty of path and mapped
  std::vector<collision::PairSeparation>
      nearest;  ///< [T] the pair with the least slack; capsule -1: none
  struct Touch {
    int row = 0, capsule = 0, other = 0;  ///< other: a capsule, or number of capsules + object
  };
  std::vector<Touch> touching;  ///< pairs nearer than kTouch_m that are asked to touch or do
  std::vector<Pose>
      target_pose;  ///< [T] base_from_object where it is in the hand or released there
  std::vector<std::uint8_t> target_moved;  ///< [T] 0: the target is where it was recorded
  JointRows tip_error, orientation_error;  ///< [T, m] [m], full angle [rad]; NaN = no goal
  std::vector<double> humanlikeness;       ///< [T] metric A, sum over the arm's centres [m^2]
  std::vector<double> speed;               ///< [T] mean of the goal tips' speeds [m/s]
};
inline constexpr double kTouch_m = 1e-3;
inline constexpr double kShownHz = 60;

/// What an infeasible plan fails by: the instant and what is wrong there.
struct WorstInstant {
  double demonstration_s = 0;
  std::string sentence;
};

/// What a plan shows: computed from the file's numbers by the kinematics and distances that planned
/// it.
struct PlanView {
  /// World: X to the person's right, Y forward, Z up, origin at the person's shoulder where the
  /// movement begins (the first place where it was seen; without one the base's).
  Pose world_from_base = Pose::Identity();
  bool upright = false;  ///< false: the file does not say how the base stands; world is the base
  std::vector<ShownMotion> motions;  ///< in the order in which they are played
  std::vector<double> human_speed;   ///< [F] mean of the goal tips' speeds [m/s]; NaN: unknown
  std::optional<WorstInstant> worst;
  std::vector<std::string> advice;  ///< of an infeasible plan: what to try
};

/// `world_from_base` as the file's config has it; none: unknown.
PlanView view_of(const robot::Robot& robot, const std::optional<Eigen::Matrix3d>& world_from_base,
                 const Plan& plan);

/// Where the human's points of the arm were: goals without the common base offset.
Vec3 where_it_was(const Goals& goals, const Vec3& in_common_base);

}  // namespace morphe::report
