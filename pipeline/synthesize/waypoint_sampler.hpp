#pragma once

#include "pipeline/synthesize/body_motion.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// A sampler of waypoints of the arm. Every waypoint is within reach (reach_share): a wrist
/// position out of reach is moved back along the path that leads to it.
class WaypointSampler {
 public:
  /// Samples for one subject; all arguments must outlive the sampler.
  WaypointSampler(const SyntheticMovements& options, const Subject& subject,
                  math::RandomStream& random)
      : options_(options), subject_(subject), random_(random) {}

  /// Draws a resting state: palm down on the table in front of the body.
  ArmState draw_home();
  /// Draws a target: thumb up, the palm beside an object.
  ArmState draw_target(const ArmState& home);
  /// Draws a lifted state: up and towards the body.
  ArmState draw_lift(const ArmState& target);
  /// Varies a state by normally distributed deviations, with standard deviations of the wrist and
  /// of the angles.
  ArmState perturb(const ArmState& place, double spread_m, double spread_rad);

 private:
  double swivel() { return random_.uniform(options_.elbow_swivel); }
  ArmState clamp_to_reach(const Vec3& from, ArmState state) const;

  const SyntheticMovements& options_;
  const Subject& subject_;
  math::RandomStream& random_;
};

}  // namespace morphe::synthesize
