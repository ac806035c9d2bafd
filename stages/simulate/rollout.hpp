#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/motion/named.hpp"
#include "stages/simulate/model_text.hpp"
#include "stages/simulate/program.hpp"
#include "stages/simulate/squeeze.hpp"

namespace morphe::simulate {

/// Why a target was not held: the hand did not take hold of it; it moved too far while the hand
/// did; a finger's motor was at its limit; it slid along the fingers, turned about the line between
/// them, rolled on them; the fingers gave way; no finger is on it any more; the engine gave up.
enum class Failure { none, no_contact, pushed, torque_limit, slip, pivot, roll, sag, lost, engine };
constexpr std::array<std::string_view, 10> names_of(Failure) {
  return {"none",  "no_contact", "pushed", "torque_limit", "slip",
          "pivot", "roll",       "sag",    "lost",         "engine"};
}

/// Of the target's centre, and its turn.
struct Way {
  double distance_m = 0, angle_deg = 0;
};

/// How a target was held under a load.
struct Holding {
  Failure failure = Failure::none;
  std::string detail;  ///< the engine's words
  Way sag;             ///< in the palm's frame, until a second after the load is there
  Way creep;           ///< from then on, the largest
  Way largest;         ///< in all
  double slip_m = 0;   ///< along a finger that touched it, the largest
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
  Holding lift;
  std::vector<Holding> directions;  ///< along the target's -x, x, -y, y, -z, z; or none
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
