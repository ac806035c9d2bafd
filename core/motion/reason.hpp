#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/motion/named.hpp"

namespace morphe {

/// Why a movement is not executable; none: it is.
enum class Reason : std::uint8_t {
  none,
  unplanned,           ///< nothing was tried yet
  no_movement,         ///< no complete reach in the demonstration
  no_shoulder,         ///< the shoulder was never seen
  no_goal,             ///< no fingertip was seen in the grasp
  not_human,           ///< no human arm could have been where the rebuilt one is
  start_in_collision,  ///< the first sample, in every posture that was found
  goal_in_collision,   ///< the last sample, or a time at which every posture collides
  unreachable,         ///< a time for which no posture holds the goals, obstacles or not
  no_path,             ///< no way around a collision
  collision,           ///< of the motion between the samples
  smoothing,           ///< the path is free, the smooth curve through it is not
  limit,
  jump,
  tracking,
  path,      ///< what was to be timed is no path of this robot
  duration,  ///< the path cannot be followed in the time asked for
  no_approach,
  no_retreat,
  no_frame,  ///< what an object of the scene stands on is not there
};
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
