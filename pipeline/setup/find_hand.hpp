#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/side.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// The certainty of a property of a generated description.
///   read     stated in the file, or indicated by its names
///   derived  from the geometry, by a rule that fits most robots
///   assumed  without evidence
enum class Provenance { read, derived, assumed };
/// Returns the names of the values.
constexpr std::array<std::string_view, 3> names_of(Provenance) {
  return {"read", "derived", "assumed"};
}

/// A finger of a robot hand.
struct Finger {
  int finger = 0;           ///< index of the finger, 0 thumb … 4 little
  std::vector<int> frames;  ///< moving frames, from the palm to the tip
  Provenance finger_provenance = Provenance::assumed;  ///< certainty of `finger`
};

/// A robot hand.
struct Hand {
  int root = -1;                ///< frame at which the fingers branch
  std::vector<Finger> fingers;  ///< the thumb first
  bool gripper = false;         ///< true if one joint drives all fingers
  Side side = Side::right;
};

/// For each frame, points on the surfaces of its shapes, in that frame [m].
using BodyPoints = std::map<int, std::vector<Vec3>>;

/// Finds the hand: the frame at which at least two fingers branch, each no longer than a hand. If
/// `link_name` is not "", the hand begins at the link of that name. Fingers are identified by their
/// names (thumb, FF, …), otherwise by their geometry: the last axis of the thumb is the least
/// parallel to those of the others, and the others are ordered from the thumb's side. Returns
/// nullopt for an arm alone. Throws InputError for several hands, and if the link does not exist.
std::optional<Hand> find_hand(const Kinematics& robot, const std::string& link_name);

}  // namespace morphe::setup
