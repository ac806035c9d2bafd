#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/named.hpp"
#include "stages/simulate/model_text.hpp"
#include "stages/simulate/program.hpp"
#include "stages/simulate/squeeze.hpp"

namespace morphe::simulate {

/// Why a target was not held. Before the lift: the robot was far from its trajectory and what came
/// of it failed; it was moved too far before the hand closed (knocked), or as it did (pushed);
/// nothing touched it, or no two fingers press against each other. Then: a finger's motor was at
/// its limit; it slid along the fingers, turned about the line between them, rolled on them; the
/// fingers gave way; no finger is on it any more. At any time: the engine gave up.
enum class Failure {
  none,
  tracking,
  knocked,
  not_touched,
  no_contact,
  pushed,
  torque_limit,
  slip,
  pivot,
  roll,
  sag,
  lost,
  engine
};
/// Whether the hand had hold of it, so that it was loaded.
constexpr bool was_loaded(Failure failure) {
  return failure == Failure::none ||
         (failure >= Failure::torque_limit && failure != Failure::engine);
}
constexpr std::array<std::string_view, 13> names_of(Failure) {
  return {"none", "tracking", "knocked", "not_touched", "no_contact", "pushed", "torque_limit",
          "slip", "pivot",    "roll",    "sag",         "lost",       "engine"};
}

/// Of the target's centre, and its turn.
struct Way {
  double distance_m = 0, angle_deg = 0;
};

/// How a target was held under a load.
struct Holding {
  Failure failure = Failure::none;
  std::string detail;   ///< the engine's words
  Way sag;              ///< in the palm's frame, until a second after the load is there
  Way creep;            ///< from then on, the largest
  Way largest;          ///< in all
  double slip_m = 0;    ///< along a finger that touched it, the largest
  double needed_N = 0;  ///< for this load (newtons.hpp), infinite: no squeeze is enough
  bool held() const { return failure == Failure::none; }
};

struct Rollout {
  Variation variation;
  /// Largest distance from the written trajectory until the first touch [degrees or mm].
  double arm_error = 0, hand_error = 0;
  double contact_s =
      0;       ///< first touch of robot and target, from the trajectory's start; NaN: none
  Way pushed;  ///< of the target in the base's frame, until it is squeezed, the largest
  double torque_share = 0;  ///< largest torque of a motor, over its limit
  double given_N = 0, needed_down_N = 0, needed_worst_N = 0;  ///< as in newtons.hpp
  /// [presses] Along the normal, all capsules of the finger's last link together, once squeezed.
  std::vector<double> pressed_N;
  Holding lift;
  std::vector<Holding> directions;  ///< along the target's -x, x, -y, y, -z, z; or none
  /// What was foretold: the squeeze that is sent bears the load.
  bool foretold(const Holding& load) const { return load.needed_N <= given_N; }
};

/// A plan, made ready for any number of rollouts.
struct PreparedPlan {
  const robot::Robot* robot = nullptr;
  SimulatedWorld world;
  Squeeze squeeze;
  Program program;
  Pose base_from_target = Pose::Identity();
  double planned_contact_s = 0;  ///< as Rollout::contact_s, in the written trajectory and closing
};

/// One run of the protocol (docs/steps/simulate.md). The same arguments give the same bits.
Rollout roll_out(const PreparedPlan& plan, const Variation& variation,
                 const SimulateOptions& options, bool directions);

}  // namespace morphe::simulate
