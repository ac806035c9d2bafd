#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/setup/capsules.hpp"

namespace morphe::setup {

/// The inputs from which a description is generated.
struct SetupRequest {
  std::filesystem::path urdf;
  /// Path of the description; paths in it are relative to its folder.
  std::filesystem::path out;
  /// Name of the robot, "" for that of the URDF.
  std::string name;
  /// Link at which the fingers branch, "" to find it.
  std::string hand;
  /// The folders in which meshes are searched.
  PackagePaths package_paths;
  /// The maximum number of capsules of each link.
  CapsuleBudget budget;
};

/// A generated description of a robot, with a list of properties to be checked before it is used.
struct SetupResult {
  std::string text;                ///< YAML
  std::vector<std::string> notes;  ///< sentences about missing or simplified data
  BodyPoints points;  ///< points of the shapes in the URDF, by the frames of the description
  std::vector<std::string> to_check;  ///< derived or assumed properties, in order of importance
};

/// Generates the description of a URDF: chains, fingers, pads, palm, joint centres, limits, natural
/// posture, capsules and allowed pairs, each marked with its certainty. `before` is an existing
/// description; changes that a person made in it are kept (merge_sections.hpp). Equal files give
/// equal texts.
SetupResult make_description(const SetupRequest& request, const std::optional<std::string>& before);

/// The pose of a hand's base on a flange, with rotations about fixed axes: Rz(yaw) Ry(pitch)
/// Rx(roll).
struct HandMount {
  /// The position [m] and the angles roll, pitch, yaw [rad].
  Vec3 position = Vec3::Zero(), rpy = Vec3::Zero();
};

/// A robot composed of two descriptions, with the hand mounted on the flange of the arm. If no
/// mount is given, the fingers point along the axis of the flange and the back of the hand touches
/// the flange.
struct MountRequest {
  /// The paths of the two descriptions and of the result.
  std::filesystem::path arm, hand, out;
  /// The name of the robot, "" to join the two names.
  std::string name;
  /// The mount, if given.
  std::optional<HandMount> mount = {};
};
/// Generates the description of a hand mounted on an arm.
SetupResult mount_hand(const MountRequest& request, const std::optional<std::string>& before);

}  // namespace morphe::setup
