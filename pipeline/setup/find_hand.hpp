#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/side.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// The certainty of a derived property: read from the file or indicated by its names; derived from
/// geometry by a rule that fits most robots; or assumed without evidence.
enum class Provenance { read, derived, assumed };
/// Returns the names of the values.
constexpr std::array<std::string_view, 3> names_of(Provenance) {
  return {"read", "derived", "assumed"};
}

/// A finger of a robot hand.
struct Finger {
  int finger = 0;           ///< index of the finger, 0 thumb … 4 little
  std::vector<int> frames;  ///< frames that move, from the palm to the last one
  Provenance finger_provenance = Provenance::assumed;  ///< certainty of `finger`
};

/// A robot hand.
struct Hand {
  /// Frame at which the fingers branch.
  int root = -1;
  /// Fingers, the thumb first.
  std::vector<Finger> fingers;
  /// True if all fingers are driven by one joint.
  bool gripper = false;
  /// The side of the hand.
  Side side = Side::right;
};

/// The points of all bodies fixed to a frame, in that frame: vertices of its shapes.
using BodyPoints = std::map<int, std::vector<Vec3>>;

/// Finds the frame at which at least two fingers branch, each no longer than a hand; if `called` is
/// given, the one whose link has that name. Fingers are identified by their names (thumb, FF, …),
/// otherwise by their geometry: the last axis of the thumb is the least parallel to the others',
/// and the other fingers are ordered from the thumb's side. Returns an empty value for an arm
/// alone. Throws InputError if there are several hands.
std::optional<Hand> find_hand(const Kinematics& robot, const std::string& called);

}  // namespace morphe::setup
