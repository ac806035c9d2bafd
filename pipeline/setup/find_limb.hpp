#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/side.hpp"
#include "pipeline/setup/find_arm.hpp"
#include "pipeline/setup/setup.hpp"
#include "pipeline/setup/shapes.hpp"

namespace morphe::setup {

/// A path of moving frames from the base to a hand, or to an end without one.
struct Limb {
  int end = -1;           ///< the frame at which the fingers branch, or the last moving one
  bool has_hand = false;  ///< true if fingers branch from `end`
  std::vector<int> path;  ///< moving frames, in order
  std::optional<Arm> arm;
  std::optional<Side> side;  ///< of the body, if it is on one
};

/// Finds the limb to be described: that of `--hand` or `--arm`, else the only one with an arm, of
/// those with a hand if there are any; else the only hand. Legs do not count. Appends to `notes` a
/// sentence about each arm that is left out. Throws InputError if several fit, with a table of
/// them, and if none does.
Limb find_limb(const Kinematics& robot, const SetupRequest& request, const LinkShapes& shapes,
               std::vector<std::string>& notes);

}  // namespace morphe::setup
