#pragma once

#include <string>

#include "core/math/limit_report.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::exports {

/// The use of the robot's limits between the points of a motion, by the two interpolations of
/// controllers: quintics through position, velocity and acceleration, and cubic Hermite pieces
/// through position and velocity.
struct MotionLimitUse {
  math::LimitReport quintic;
  math::CubicLimitReport cubic;
};
/// Computes the use by a motion.
MotionLimitUse limit_use(const RobotModel& robot, const Trajectory& motion);

/// Returns true if the ratio is above 1 by more than rounding.
bool exceeds_limit(const math::LimitUse& use);
/// Returns true if the cubic pieces are within the limits.
bool cubic_holds(const MotionLimitUse& use);

/// The largest use of each limit over the motions that were added.
class WorstLimitUse {
 public:
  void add(const MotionLimitUse& use, const std::string& plan);

  /// Returns a sentence with the use by both interpolations; "" if nothing was added.
  std::string sentence(double rate_hz) const;
  /// Returns the limits that are exceeded and what to do, as a sentence, or "".
  std::string excess_sentence(const RobotModel& robot, double rate_hz) const;

 private:
  struct Use {
    math::LimitUse use;
    std::string plan;
  };
  static void update(Use& worst, const math::LimitUse& use, const std::string& plan);

  Use velocity_, acceleration_, jerk_;  ///< of the quintics
  Use cubic_velocity_, cubic_acceleration_;
};

}  // namespace morphe::exports
