#pragma once

#include <string>
#include <vector>

namespace morphe::planning {

/// Where the robot stands before and after a plan (config section `approach`).
struct ApproachOptions {
  struct Joint {
    std::string joint;
    double value = 0;  ///< [rad]
  };
  std::vector<Joint> home;   ///< joints that are not named: 0, or their nearest limit
  double limit_share = 0.5;  ///< of velocity, acceleration and jerk on the way
  bool back = true;          ///< a retreat too
};
template <class Fields>
void fields(Fields& f, ApproachOptions::Joint& o) {
  f.required("joint", o.joint);
  f.required("value", o.value);
}
template <class Fields>
void fields(Fields& f, ApproachOptions& o) {
  f("home", o.home);
  f("limit_share", o.limit_share);
  f("back", o.back);
}
std::string why_invalid(const ApproachOptions& options);

}  // namespace morphe::planning
