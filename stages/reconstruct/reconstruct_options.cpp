#include "stages/reconstruct/reconstruct_options.hpp"

namespace morphe::reconstruct {

std::string validation_error(const ReconstructOptions& o) {
  if (!(o.rate_hz > 0 && o.rate_hz <= 1000)) return "rate_hz must be above 0 and at most 1000";
  if (!(o.cutoff_hz > 0 && o.cutoff_hz < 0.4 * o.rate_hz)) {
    return "cutoff_hz must lie between 0 and 0.4 rate_hz";
  }
  if (!(o.glove_rest_cutoff_hz > 0)) return "glove_rest_cutoff_hz must be positive";
  if (!(o.max_gap_s > 0)) return "max_gap_s must be positive";
  for (const double shift : {o.thumb_marker_to_axis_m, o.index_marker_to_axis_m}) {
    if (!(shift >= 0 && shift < 0.05)) return "marker_to_axis must lie between 0 and 0.05 m";
  }
  return "";
}

std::string validation_error(const HumanOptions& o) {
  if (o.stature_m && !(*o.stature_m > 0.5 && *o.stature_m < 2.5)) {
    return "stature_m must lie between 0.5 and 2.5 m";
  }
  for (const auto& length : {o.upper_arm, o.forearm}) {
    if (length && !(*length > 0)) return "upper_arm and forearm must be positive";
  }
  if (!(o.max_limit_violation_m > 0)) return "max_limit_violation_m must be positive";
  const double share = o.max_reach_share;
  if (!(share > 0 && share < 1)) return "max_reach_share must lie between 0 and 1";
  return "";
}

}  // namespace morphe::reconstruct
