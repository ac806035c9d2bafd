#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe::study {

/// The kinds of obstacles that are put into the robot's way, in turn:
///   elbow   a ball beside the elbow that penetrates it by 5 to 25 mm in the middle of the movement
///   reach   an upright post in the way of the palm, half-way to the grasp
///   object  a box beside the target, on the same support
///   shelf   a board over the target, 10 to 40 mm above the whole hand at the grasp, reaching from
///           above the front half of the target away from the robot
inline constexpr const char* kObstacleKinds[] = {"elbow", "reach", "object", "shelf"};

/// Samples an obstacle with which the path of an unobstructed plan collides, but not at its first
/// sample. Returns an empty value if all of many samples fail. `world_from_base` is the placement
/// of that plan.
std::optional<scene::ConfiguredObject> sample_blocking_obstacle(const robot::Robot& robot,
                                                                const Plan& plan,
                                                                const Pose& world_from_base,
                                                                const std::string& kind,
                                                                std::uint64_t seed);

}  // namespace morphe::study
