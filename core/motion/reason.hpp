#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/motion/enum_names.hpp"

namespace morphe {

/// The reason why a movement is not executable; the first value means that it is.
enum class Reason : std::uint8_t {
  none,
  unplanned,           ///< planning was not attempted yet
  no_movement,         ///< no complete reach in the demonstration
  no_shoulder,         ///< the shoulder was never observed
  no_goal,             ///< no fingertip was observed in the grasp
  not_human,           ///< the reconstructed arm is not anatomically possible
  start_in_collision,  ///< the first sample collides in every posture that was found
  goal_in_collision,   ///< the last sample collides, or at some time every posture does
  unreachable,         ///< at some time no posture reaches the goals, even without obstacles
  no_path,             ///< no path around a collision was found
  collision,           ///< the motion collides between the samples
  smoothing,           ///< the path is free, but its smoothed curve is not
  limit,
  jump,
  tracking,
  path,      ///< the input of the time parametrisation is not a path of this robot
  duration,  ///< the path cannot be followed in the requested duration
  no_approach,
  no_retreat,
  no_frame,  ///< the reference frame of an object of the scene is missing
};
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 20> names_of(Reason) {
  return {"",
          "unplanned",
          "no_movement",
          "no_shoulder",
          "no_goal",
          "not_human",
          "start_in_collision",
          "goal_in_collision",
          "unreachable",
          "no_path",
          "collision",
          "smoothing",
          "limit",
          "jump",
          "tracking",
          "path",
          "duration",
          "no_approach",
          "no_retreat",
          "no_frame"};
}

}  // namespace morphe
