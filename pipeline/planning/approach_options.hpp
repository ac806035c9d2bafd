#pragma once

#include <string>
#include <vector>

#include "core/motion/key_bounds.hpp"

namespace morphe::planning {

/// The robot's posture before and after a plan, and the motions to and from it (config section
/// `approach`).
struct ApproachOptions {
  /// The home position of one joint.
  struct Joint {
    std::string joint;
    double value = 0;  ///< [rad]
  };
  std::vector<Joint> home;     ///< joints not listed are at 0, or at the limit nearest to 0
  double limit_scaling = 0.5;  ///< factor on the velocity, acceleration and jerk limits
  bool retreat = true;         ///< true if a retreat is planned too
};
template <class Fields>
void fields(Fields& f, ApproachOptions::Joint& o) {
  f.required("joint", o.joint);
  f.required("value", o.value, bounds::kJointPosition);
}
template <class Fields>
void fields(Fields& f, ApproachOptions& o) {
  f("home", o.home);
  f("limit_scaling", o.limit_scaling, bounds::kShare.from(1e-3));
  f("retreat", o.retreat);
}

}  // namespace morphe::planning
