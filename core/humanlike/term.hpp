#pragma once

#include <concepts>
#include <vector>

#include "core/humanlike/frame_goal.hpp"
#include "core/humanlike/loads.hpp"
#include "core/robot/robot.hpp"
#include "core/solve/quadratic.hpp"

namespace morphe::humanlike {

/// The robot's state in which the terms of a frame's objective are evaluated.
struct RobotState {
  const robot::Robot& robot;
  const JointVector& q;                      ///< [n]
  const std::vector<Pose>& base_from_frame;  ///< [frames] at q

  /// Returns the pose of a frame in the base frame.
  const Pose& pose_of(int frame) const { return base_from_frame[frame]; }
};

/// A term that depends on the poses of frames. It adds `share` times its value, gradient and
/// curvature in the state to the loads; `share` is its weight times the frame's factor. Goals that
/// are NaN contribute zero.
template <class T>
concept FrameTerm = requires(const T& term, const RobotState& state, const FrameGoal& goal,
                             double share, Loads& loads) {
  term.add(state, goal, share, loads);
};

/// A term that depends directly on the joints. It adds the same quantities to the model.
template <class T>
concept JointTerm = requires(const T& term, const RobotState& state, const FrameGoal& goal,
                             double share, solve::Quadratic& model) {
  term.add(state, goal, share, model);
};

/// A term of the objective. It is inactive while its weight is 0, the default. `fields` declares
/// its keys in section `map` of a config. `kGroup` is its TermGroup.
template <class T>
concept Term = (FrameTerm<T> || JointTerm<T>)&&requires(T& term) {
  { term.weight } -> std::same_as<double&>;
  { T::kGroup } -> std::convertible_to<TermGroup>;
};

}  // namespace morphe::humanlike
