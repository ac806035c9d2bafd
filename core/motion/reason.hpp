#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/motion/enum_names.hpp"

namespace morphe {

/// The reason why a movement is not executable; the first value means that it is.
enum class Reason : std::uint8_t {
  none,
  unplanned,            ///< planning was not attempted yet
  no_movement,          ///< no complete reach in the demonstration
  no_shoulder,          ///< the shoulder was never observed
  no_goal,              ///< no fingertip was observed in the grasp
  implausible_arm,      ///< the reconstructed arm is not anatomically possible
  doubtful_recording,   ///< the recording has a flag that the config refuses
  start_in_collision,   ///< the first sample collides in every posture that was found
  goal_in_collision,    ///< the last sample collides, or at some time every posture does
  unreachable,          ///< at some time no posture reaches the goals, even without obstacles
  no_path,              ///< no path around a collision was found
  smoothing_collision,  ///< the path is free, but its smoothed curve is not
  joint_limit,
  jump,
  tracking,
  invalid_path,        ///< the input of the time parametrisation is not a path of this robot
  duration_too_short,  ///< the path cannot be followed in the requested duration
  not_held,            ///< the target is carried without two opposed contacts
  no_approach,
  no_retreat,
  no_reference_frame,  ///< the reference frame of an object of the scene is missing
  released_in_air,     ///< the hand lets go of the target far above everything
  not_known,           ///< something is assumed that the config requires to be known
  rejected,            ///< verify rejects the trajectory, which is a fault of Morphe
};
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 24> names_of(Reason) {
  // clang-format off
  return {"", "unplanned", "no_movement", "no_shoulder", "no_goal", "implausible_arm", "doubtful_recording",
          "start_in_collision", "goal_in_collision", "unreachable", "no_path",
          "smoothing_collision", "joint_limit", "jump", "tracking", "invalid_path",
          "duration_too_short", "not_held", "no_approach", "no_retreat", "no_reference_frame",
          "released_in_air", "not_known", "rejected"};
  // clang-format on
}

}  // namespace morphe
