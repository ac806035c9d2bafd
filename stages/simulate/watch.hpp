#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/physics/state.hpp"
#include "stages/simulate/rollout.hpp"

namespace morphe::simulate {

/// Names of a model's parts as numbers.
struct Parts {
  Parts(const physics::Model& model, const RobotTable& robot, bool lifts_base);

  int target_body = 0, target_geom = 0, palm_body = 0;
  int base_motor = -1;               ///< -1: the base stands
  std::vector<int> bodies, joints;   ///< [frames] joints: -1 where nothing moves
  std::vector<int> motors;           ///< [joints]
  std::vector<int> capsule_of_geom;  ///< [geoms] -1: none
};

/// A capsule on the target.
struct Grip {
  int capsule = 0;
  Vec3 point, inward;  ///< in the world's frame; unit, into the target
  double force_N = 0;  ///< along that
};
/// Of the last step. `touches` is scratch.
std::vector<Grip> grips_of(const physics::State& state, const Parts& parts,
                           std::vector<physics::Touch>& touches);
/// Whether two of them press against each other.
bool opposed(const std::vector<Grip>& grips);

Way way_between(const Pose& from, const Pose& to);

/// Looks at a target that is to be held, from the squeezed state on.
class Watch {
 public:
  Watch(const RobotTable& robot, const Parts& parts, const physics::State& squeezed);
  /// `settled`: from here on the target must not move any more. `at_limit`: a finger's motor is.
  void look(const physics::State& state, bool settled, bool at_limit);
  /// It moved too far: what comes then does not count.
  bool failed() const { return !holding_.held(); }
  Holding verdict() const;

 private:
  /// A point of the target and where on a finger it lay.
  struct Pad {
    int frame;
    Vec3 on_target, on_finger;
  };
  Failure cause(const Pose& from, const Pose& palm_from_target) const;

  const RobotTable& robot_;
  const Parts& parts_;
  Pose start_;        ///< palm_from_target
  Vec3 finger_line_;  ///< unit, in the palm's frame
  std::vector<Pad> pads_;
  std::optional<Pose> settled_;
  std::vector<Grip> grips_;
  std::vector<physics::Touch> touches_;
  bool at_limit_ = false;
  Failure began_ = Failure::none;
  Holding holding_;
};

}  // namespace morphe::simulate
