#pragma once

#include "pipeline/synthesize/body_motion.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// Draws the states of the arm between which it moves. A wrist farther from the shoulder than
/// options.reach_share allows is moved back towards the wrist that the arm comes from.
class WaypointSampler {
 public:
  /// Samples for one subject; all arguments must outlive the sampler.
  WaypointSampler(const SyntheticMovements& options, const Subject& subject,
                  math::RandomStream& random)
      : options_(options), subject_(subject), random_(random) {}

  /// Draws a resting state: palm down, just above the table in front of the body.
  ArmState draw_home();
  /// Draws a target: thumb up, the palm beside an object.
  ArmState draw_target(const ArmState& home);
  /// Draws a lifted state: up and towards the body.
  ArmState draw_lift(const ArmState& target);
  /// Varies a state by normally distributed deviations of the wrist and of the four angles, with
  /// these standard deviations.
  ArmState perturb(const ArmState& place, double spread_m, double spread_rad);

 private:
  double swivel() { return random_.uniform(options_.elbow_swivel); }
  ArmState clamp_to_reach(const Vec3& from, ArmState state) const;

  const SyntheticMovements& options_;
  const Subject& subject_;
  math::RandomStream& random_;
};

}  // namespace morphe::synthesize
