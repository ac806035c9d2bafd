#pragma once

#include <vector>

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::humanlike {

/// Natural posture of the joints that only move tips without a goal in this frame: sum of (q_joint
/// - q_follow - value)² over them [rad²].
struct NaturalPosture {
  /// A joint that has a natural posture.
  struct Joint {
    int joint = 0;
    int follow = -1;        ///< joint that it copies, -1 if it copies no joint
    double value = 0;       ///< its position less that of `follow` [rad]
    std::vector<int> tips;  ///< tips that the joint moves
  };
  static constexpr TermGroup kGroup = TermGroup::posture;
  double weight = 0;  ///< [1/rad²]
  std::vector<Joint> joints;
  /// Adds the term at a state, multiplied by `share`, to the model.
  void add(const RobotState& state, const FrameGoal& goal, double share,
           solve::Quadratic& model) const;
  /// Moves the joints that only move tips without a goal to their natural posture in q [n].
  void apply(const FrameGoal& goal, JointVector& q) const;
  /// Returns the root mean square distance from the natural posture over the joints that only move
  /// tips without a goal [rad], or NaN without such joints.
  double distance(const JointVector& q, const FrameGoal& goal) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, NaturalPosture& o) {
  f("posture", o.weight, bounds::kWeight);
}

}  // namespace morphe::humanlike
