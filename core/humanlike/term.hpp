#pragma once

#include <concepts>

#include "core/humanlike/frame_goal.hpp"
#include "core/humanlike/loads.hpp"
#include "core/humanlike/robot_state.hpp"
#include "core/solve/quadratic.hpp"

namespace morphe::humanlike {

/// A term that depends on the poses of frames: it adds `share` times its value, gradient and
/// curvature at the state to the loads. Goals that are NaN contribute zero.
template <class T>
concept FrameTerm = requires(const T& term, const RobotState& state, const FrameGoal& goal,
                             double share, Loads& loads) {
  term.add(state, goal, share, loads);
};

/// A term that depends directly on the joints: it adds the same quantities to the model.
template <class T>
concept JointTerm = requires(const T& term, const RobotState& state, const FrameGoal& goal,
                             double share, solve::Quadratic& model) {
  term.add(state, goal, share, model);
};

/// A term of the objective. It is inactive while its weight is 0, the default. `fields` declares
/// its keys in section `map` of a config; `kGroup` determines the modes in which it is omitted and
/// the phase-dependent factor of its weight.
template <class T>
concept Term = (FrameTerm<T> || JointTerm<T>)&&requires(T& term) {
  { term.weight } -> std::same_as<double&>;
  { T::kGroup } -> std::convertible_to<TermGroup>;
};

}  // namespace morphe::humanlike
