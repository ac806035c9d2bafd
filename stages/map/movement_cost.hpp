#pragma once

#include <array>
#include <vector>

#include "core/motion/key_bounds.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::map {

/// The cost of a movement in addition to that of its frames, per 10 ms: weights on (velocity /
/// limit)², (acceleration / limit)² and (jerk / limit)² of every joint at the human's tempo. The
/// jerk term suppresses sensor noise; velocity and acceleration select, among postures that meet
/// the goals equally well, those that the robot can follow without slowing down.
struct MovementCost {
  double velocity = 2e-3, acceleration = 1e-3, jerk = 2e-3;  ///< weights of the three terms
};
template <class Fields>
void fields(Fields& f, MovementCost& o) {
  f("velocity", o.velocity, bounds::kWeight);
  f("acceleration", o.acceleration, bounds::kWeight);
  f("jerk", o.jerk, bounds::kWeight);
}

/// Returns the weights [n] on the squared first, second and third differences between frames of a
/// path; `time` [s] has at least two.
std::array<JointVector, 3> difference_weights(const RobotModel& robot,
                                              const std::vector<double>& time,
                                              const MovementCost& cost);

inline constexpr double kReferenceStep_s = 0.01;  ///< frame length to which the weights refer
/// Returns the mean time between frames [s].
double mean_step(const std::vector<double>& time);

}  // namespace morphe::map
