#pragma once

#include <optional>
#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe::explain {

/// A target that nobody recorded, in the way of the person's own fingertips.
struct TargetTooWide {
  std::string tip;      ///< whose goal comes nearest to its axis
  double time_s = 0;    ///< demonstration time
  double radius_m = 0;  ///< as it was inferred
  double allowed_m =
      0;  ///< the largest radius that leaves room for every fingertip; may be negative
};

/// An inferred cylinder is as wide as thumb and index finger are apart; other fingers' goals may
/// lie inside it. Over the frames before it is carried, tips at its height: the least distance of a
/// goal from its axis, less `pad_depth`. None: the target is no such cylinder, or not in the way.
std::optional<TargetTooWide> target_too_wide(const RobotTable& robot, const Plan& plan,
                                             const scene::SceneOptions& options);

}  // namespace morphe::explain
