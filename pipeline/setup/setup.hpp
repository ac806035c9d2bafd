#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/setup/capsules.hpp"

namespace morphe::setup {

struct SetupRequest {
  std::filesystem::path urdf;
  std::filesystem::path out;  ///< the description: paths in it are relative to its folder
  std::string name;           ///< "": the URDF's
  std::string hand;           ///< link from which the fingers part, "": found
  MeshPlaces places;
  CapsuleBudget budget;
};

/// A description of a robot that nobody wrote by hand, and what to look at before it is believed.
struct SetupResult {
  std::string text;                   ///< YAML
  std::vector<std::string> notes;     ///< what is missing or was simplified
  BodyPoints points;                  ///< of the URDF's shapes, by the description's frames
  std::vector<std::string> to_check;  ///< what was derived or assumed, in the order of its weight
};

/// Chains, fingers, pads, palm, joint centres, limits, natural posture, capsules and pairs of a
/// URDF, each marked by how sure it is. `before`: the description that is there already; what a
/// person changed in it stays (keep_changes.hpp). The same files give the same text.
SetupResult set_up(const SetupRequest& request, const std::optional<std::string>& before);

/// A hand's place on a flange, of its base; fixed axes: Rz(yaw) Ry(pitch) Rx(roll).
struct HandMount {
  Vec3 position = Vec3::Zero(), rpy = Vec3::Zero();
};

/// A robot of two descriptions: the hand on the arm's flange. Where nobody says how, its fingers
/// point along the flange's axis and its back lies on the flange.
struct MountRequest {
  std::filesystem::path arm, hand, out;
  std::string name;
  std::optional<HandMount> mount = {};
};
SetupResult mount_hand(const MountRequest& request, const std::optional<std::string>& before);

}  // namespace morphe::setup
