#pragma once

#include <vector>

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Natural posture of what no goal asks for: sum of (q_joint - q_follow - value)² over joints that
/// move only tips without a goal in this frame [rad²].
struct NaturalPosture {
  struct Joint {
    int joint = 0;
    int follow = -1;        ///< joint to copy, -1 = none
    double value = 0;       ///< [rad]
    std::vector<int> tips;  ///< tips that the joint moves
  };
  static constexpr Group kGroup = Group::posture;
  double weight = 0;  ///< [1/rad²]
  std::vector<Joint> joints;
  void add(const RobotState& state, const FrameGoal& goal, double share,
           solve::Quadratic& model) const;
  /// Root mean square distance from the natural posture over the active joints [rad]; NaN if none.
  double distance(const JointVector& q, const FrameGoal& goal) const;
};
template <class Fields>
void fields(Fields& f, NaturalPosture& o) {
  f("posture", o.weight);
}

}  // namespace morphe::humanlike
