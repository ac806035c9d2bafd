#pragma once

#include "pipeline/synthesize/body_motion.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// Where the arm is led. Every place is within reach (reach_share): a wrist beyond is drawn back
/// along the way that leads to it.
class Places {
 public:
  Places(const SyntheticMovements& options, const Subject& subject, math::RandomStream& random)
      : options_(options), subject_(subject), random_(random) {}

  ArmState home();                          ///< palm down on the table before the body
  ArmState target(const ArmState& home);    ///< thumb up, the palm beside an object
  ArmState lifted(const ArmState& target);  ///< up and towards the body
  /// Not quite the same place every time: standard deviations of the wrist and of the angles.
  ArmState again(const ArmState& place, double spread_m, double spread_rad);

 private:
  double swivel() { return random_.uniform(options_.elbow_swivel); }
  ArmState within_reach(const Vec3& from, ArmState state) const;

  const SyntheticMovements& options_;
  const Subject& subject_;
  math::RandomStream& random_;
};

}  // namespace morphe::synthesize
