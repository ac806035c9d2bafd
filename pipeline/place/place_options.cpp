#include "pipeline/place/place_options.hpp"

#include <numbers>

namespace morphe::place {

std::string validation_error(const PlaceOptions& options) {
  if (!(options.max_tilt_rad >= 0 && options.max_tilt_rad <= std::numbers::pi / 2))
    return "tilt: must be from 0 to 90 degrees";
  if (!(options.person_clearance_m >= 0 && options.person_clearance_m < 1))
    return "person-clearance: must be from 0 to 1 m";
  if (options.samples < options.candidates || options.candidates < options.refine ||
      options.refine < options.plan || options.plan < 1)
    return "must satisfy samples >= candidates >= refine >= plan >= 1";
  if (options.movements < 1 || options.jobs < 1) return "movements and jobs: must be positive";
  return "";
}

}  // namespace morphe::place
