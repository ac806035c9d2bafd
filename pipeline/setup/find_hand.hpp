#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/side.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// How sure a derived thing is: read in the file, or its names say so; derived from geometry by a
/// rule that fits most robots; assumed, for nothing tells.
enum class Sure { read, derived, assumed };
constexpr std::array<std::string_view, 3> names_of(Sure) { return {"read", "derived", "assumed"}; }

struct Finger {
  int finger = 0;              ///< 0 thumb … 4 little
  std::vector<int> frames;     ///< that move, from the palm to the last one
  Sure named = Sure::assumed;  ///< which finger it is
};

struct Hand {
  int root = -1;                ///< frame from which the fingers part
  std::vector<Finger> fingers;  ///< the thumb first
  bool gripper = false;         ///< all of them are driven by one joint
  Side side = Side::right;
};

/// Points of what moves with a frame, in that frame: corners of its shapes.
using BodyPoints = std::map<int, std::vector<Vec3>>;

/// The joints from which at least two fingers part, none of them longer than a hand: the one whose
/// link is `called` where that is said. Fingers are known by their names (thumb, FF, …), else by
/// their place: the thumb's last axis is the least parallel to the others', and the others lie from
/// its side on in their order. None for an arm alone. InputError if there are several hands.
std::optional<Hand> find_hand(const Kinematics& robot, const std::string& called);

}  // namespace morphe::setup
