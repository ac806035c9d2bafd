#pragma once

#include <optional>
#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe::explain {

/// An inferred target that obstructs the person's own fingertips.
struct OversizedTarget {
  std::string tip;      ///< tip whose goal is closest to the target's axis
  double time_s = 0;    ///< demonstration time
  double radius_m = 0;  ///< inferred radius
  /// largest radius that is clear of every fingertip; may be negative
  double allowed_radius_m = 0;
};

/// Checks an inferred cylinder against the fingertips. It is as wide as the distance between thumb
/// and index finger, so that the goals of other fingers may be inside it. The allowed radius is the
/// least distance of a goal from its axis, less `pad_depth`, over the frames before it is attached
/// and the tips at its height. Returns nullopt if the target is not such a cylinder, or does not
/// obstruct.
std::optional<OversizedTarget> find_oversized_target(const RobotModel& robot, const Plan& plan,
                                                     const scene::SceneOptions& options);

}  // namespace morphe::explain
