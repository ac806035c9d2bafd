#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe::study {

/// The kinds of obstacles that are put into the robot's way, in turn:
///   elbow   a ball at the height of the elbow, which penetrates the arm by 5 to 25 mm there at
///           an instant in the middle of the path
///   reach   an upright post in the way of the palm, about half-way to the grasp
///   object  an upright box beside the target, at the height of its bottom
///   shelf   a level board, 10 to 40 mm above the highest point of the hand at the grasp; it
///           extends away from the robot, from an edge up to 40 mm before the target's centre
inline constexpr const char* kObstacleKinds[] = {"elbow", "reach", "object", "shelf"};

/// Returns the row of a plan's path with which the grasp begins, the last one without a grasp.
Eigen::Index grasp_row(const Plan& plan);

/// Draws an obstacle of one of the kinds, in the world frame, until the path of `plan` is clear of
/// it in the first posture but not in all. The plan is made without an obstacle, with its base at
/// `world_from_base`. Returns no obstacle if 40 draws fail, or if the target that `object` and
/// `shelf` need is not a cylinder.
std::optional<scene::ConfiguredObject> draw_blocking_obstacle(const robot::Robot& robot,
                                                              const Plan& plan,
                                                              const Pose& world_from_base,
                                                              const std::string& kind,
                                                              std::uint64_t seed);

}  // namespace morphe::study
