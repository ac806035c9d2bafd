#pragma once

#include <array>
#include <vector>

#include "core/motion/robot_table.hpp"

namespace morphe::map {

/// What a movement costs beside its frames, per 10 ms: weights on (velocity / limit)²,
/// (acceleration / limit)² and (jerk / limit)² of every joint at the human's tempo. Jerk keeps
/// sensor noise out; velocity and acceleration choose, among postures that serve the goals alike,
/// those that the robot can follow without slowing down.
struct MovementCost {
  double velocity = 3e-4, acceleration = 1e-5, jerk = 3e-5;
};
template <class Fields>
void fields(Fields& f, MovementCost& o) {
  f("velocity", o.velocity);
  f("acceleration", o.acceleration);
  f("jerk", o.jerk);
}

/// The cost as weights on squared first, second and third differences of a path whose frames are
/// mean_step(time) apart. [n] each
std::array<JointVector, 3> difference_weights(const RobotTable& robot,
                                              const std::vector<double>& time,
                                              const MovementCost& cost);

inline constexpr double kReferenceStep = 0.01;  ///< weights count per frame of this length [s]
double mean_step(const std::vector<double>& time);

}  // namespace morphe::map
