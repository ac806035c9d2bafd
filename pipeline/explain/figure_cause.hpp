#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "pipeline/explain/palm_floor.hpp"
#include "pipeline/explain/wrist_offset.hpp"

namespace morphe::explain {

/// The causes of a figure of posture (docs/steps/explain.md has the rule):
///   small              below 6 degrees
///   placement          where the base is
///   size               the lengths of upper arm and forearm
///   robot_hand         its size and how its fingers reach the tips
///   palm_angle         the palm is turned otherwise than the hand, which moves the wrist
///   tips               the tips are not at their goals, as in a detour
///   wrist_place        one of the three before, without goals that tell them apart
///   placement_or_size  the arm, of the palm's angle
///   weights_or_solver  the same wrist or the same tips would not need it
enum class FigureCause {
  unknown,
  small,
  placement,
  size,
  robot_hand,
  palm_angle,
  tips,
  wrist_place,
  placement_or_size,
  weights_or_solver
};
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 10> names_of(FigureCause) {
  return {"unknown",
          "small",
          "placement",
          "size",
          "robot_hand",
          "palm_angle",
          "tips",
          "wrist_place",
          "placement_or_size",
          "weights_or_solver"};
}

/// The causes of a figure: `all` of them together, unless one of `instead` explains it about as
/// well, so that they cannot be told apart.
struct FigureCauses {
  std::vector<FigureCause> all{FigureCause::unknown};
  std::vector<FigureCause> instead;
};

/// Returns the causes of a link's direction or of the swivel angle, from the driven angle and the
/// one that the wrist or the tips force [rad].
FigureCauses causes_of_direction(double driven, double forced, const WristOffset& wrist);

/// Returns the causes of the palm's angle.
FigureCauses causes_of_palm(double driven, const PalmFloor& floor);

}  // namespace morphe::explain
