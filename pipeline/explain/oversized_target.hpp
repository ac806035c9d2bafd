#pragma once

#include <optional>
#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe::explain {

/// An inferred target that obstructs the person's own fingertips.
struct OversizedTarget {
  std::string tip;              ///< tip whose goal is closest to the target's axis
  double time_s = 0;            ///< demonstration time
  double radius_m = 0;          ///< inferred radius of the target
  double allowed_radius_m = 0;  ///< largest radius clear of every fingertip; may be negative
};

/// Checks an inferred target, a cylinder as wide as the distance between thumb and index finger, in
/// which the goals of other fingers may be. The allowed radius is the least distance of a goal from
/// its axis, less `pad_depth`, over the goals at its height before it is attached. Returns nullopt
/// if the target is not an inferred cylinder, or is less than 2 mm too wide.
std::optional<OversizedTarget> find_oversized_target(const RobotModel& robot, const Plan& plan,
                                                     const scene::SceneOptions& options);

}  // namespace morphe::explain
