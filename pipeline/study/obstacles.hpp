#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe::study {

/// What is put into a robot's way, in turn:
///   elbow   a ball beside the elbow, which it cuts by 5 to 25 mm in the middle of the movement
///   reach   an upright post in the way of the palm, half-way to the grasp
///   object  a box beside the target, on whatever that stands on
///   shelf   a board over the target, 10 to 40 mm above all of the hand at the grasp, from above
///   the
///           target's front half away from the robot
inline constexpr const char* kObstacleKinds[] = {"elbow", "reach", "object", "shelf"};

/// An obstacle that the path of a free plan runs into, away from its first sample. None if no draw
/// of many does. `world_from_base` is the placement of that plan.
std::optional<scene::ConfiguredObject> obstacle_in_the_way(const robot::Robot& robot,
                                                           const Plan& plan,
                                                           const Pose& world_from_base,
                                                           const std::string& kind,
                                                           std::uint64_t seed);

}  // namespace morphe::study
