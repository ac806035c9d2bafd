#pragma once

#include <concepts>

#include "core/humanlike/frame_goal.hpp"
#include "core/humanlike/loads.hpp"
#include "core/humanlike/robot_state.hpp"
#include "core/solve/quadratic.hpp"

namespace morphe::humanlike {

/// A term that pulls the robot's frames: adds `share` times its value, gradient and curvature at
/// the state to the loads. Goals that were not seen (NaN) add nothing.
template <class T>
concept FrameTerm = requires(const T& term, const RobotState& state, const FrameGoal& goal,
                             double share, Loads& loads) {
  term.add(state, goal, share, loads);
};

/// A term of the joints themselves: adds the same to the model.
template <class T>
concept JointTerm = requires(const T& term, const RobotState& state, const FrameGoal& goal,
                             double share, solve::Quadratic& model) {
  term.add(state, goal, share, model);
};

/// One term of the objective. It is off while its weight is 0, which is its default. `fields`
/// gives it its keys in section `map` of a config; `kGroup` says which modes leave it out and by
/// which of a phase's shares its weight is multiplied.
template <class T>
concept Term = (FrameTerm<T> || JointTerm<T>)&&requires(T& term) {
  { term.weight } -> std::same_as<double&>;
  { T::kGroup } -> std::convertible_to<Group>;
};

}  // namespace morphe::humanlike
