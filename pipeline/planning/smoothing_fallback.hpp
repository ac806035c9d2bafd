#pragma once

#include <algorithm>
#include <initializer_list>

#include "core/motion/outcome.hpp"
#include "pipeline/planning/constants.hpp"
#include "pipeline/planning/pipeline_config.hpp"
#include "stages/retime/retime.hpp"

namespace morphe::planning {

/// Returns attempt(options). If the options smooth the path and the attempt fails for a reason in
/// `caused_by_smoothing`, returns attempt(options without smoothing) instead.
template <class Attempt>
PlanningFailure retry_without_smoothing(retime::RetimeOptions options,
                                        std::initializer_list<Reason> caused_by_smoothing,
                                        const Attempt& attempt) {
  const PlanningFailure failure = attempt(options);
  const bool smoothed = options.tip_tolerance + options.joint_tolerance > 0;
  if (!smoothed ||
      std::ranges::find(caused_by_smoothing, failure.reason) == caused_by_smoothing.end()) {
    return failure;
  }
  options.tip_tolerance = options.joint_tolerance = 0;
  return attempt(options);
}

/// Returns the config with paths farther from obstacles, which leaves room for smoothing.
inline PipelineConfig farther_from_obstacles(PipelineConfig config) {
  double& activation_m = config.map.clearance.activation_distance_m;
  double& extra_m = config.repair.extra_clearance;
  activation_m = std::max(activation_m, kFartherActivationDistance_m);
  extra_m = std::max(extra_m, kFartherExtraClearance_m);
  return config;
}

}  // namespace morphe::planning
