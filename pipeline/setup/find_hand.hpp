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

/// A finger of a robot hand, or a jaw of a gripper.
struct Finger {
  int finger = 0;           ///< index of the finger, 0 thumb … 4 little
  std::vector<int> frames;  ///< moving frames, from the palm to the tip; empty for a fixed jaw
  Provenance finger_provenance = Provenance::assumed;  ///< certainty of `finger`
  int body = -1;  ///< frame that carries the tip: the last moving one, or that of the jaw
};

/// A chain of a hand that is no finger.
struct LeftOut {
  int frame = -1;      ///< its last moving frame
  std::string reason;  ///< as the end of the sentence "LINK is no finger: …"
};

/// A robot hand.
struct Hand {
  int root = -1;                ///< frame at which the fingers branch
  std::vector<Finger> fingers;  ///< the thumb first
  bool gripper = false;         ///< true if its fingers are two jaws, of one joint each or together
  Vec3 fixed_jaw_end = Vec3::Zero();  ///< of a jaw without joints, in the frame of its body [m]
  std::vector<LeftOut> left_out;
  std::optional<Side> side;   ///< nullopt: it serves both
  std::string side_evidence;  ///< a half-sentence, "" without
  /// Returns true if one of two jaws does not move.
  bool has_fixed_jaw() const { return gripper && fingers.back().frames.empty(); }
};

/// For each frame, points on the surfaces of its shapes, in that frame [m].
using BodyPoints = std::map<int, std::vector<Vec3>>;

/// Returns the frames nearest to the base at which at least two fingers branch, each no longer than
/// a hand; if there are none, the frames that carry one moving jaw beside a fixed one
/// (find_jaw.hpp).
std::vector<int> find_hand_roots(const Kinematics& robot, const BodyPoints& points);

/// Returns the hand that begins at the frame `root`; if a person named it (`named`), a fixed jaw
/// needs less evidence. Chains that cannot be fingers are left out (opposition.hpp), and those
/// beyond the five of a person. Fingers are identified by their names (thumb, FF, …), otherwise by
/// their geometry: the last axis of the thumb is the least parallel to those of the others, and the
/// others are ordered by the places of their tips, from the thumb's side. Returns nullopt if no two
/// fingers or jaws remain.
std::optional<Hand> find_hand(const Kinematics& robot, int root, bool named,
                              const BodyPoints& points);

}  // namespace morphe::setup
