#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/setup/capsules.hpp"

namespace morphe::setup {

/// The inputs from which a description is generated.
struct SetupRequest {
  std::filesystem::path urdf;
  std::filesystem::path out;  ///< description; paths in it are relative to its folder
  std::string name;           ///< of the robot, "" for that of the URDF
  std::string hand;           ///< link at which the fingers branch, "" to find it
  std::string arm;            ///< link at the end of the arm, or beyond it, "" to find it
  std::string elbow;          ///< joint of the elbow, "" to find it
  std::string first, last;    ///< ends of the arm that a person wrote into the description, or ""
  robot::GivenLimits limits;  ///< of position, which replace those of the URDF
  PackagePaths package_paths;
  CapsuleBudget budget;
  int jobs = 1;  ///< threads
  /// Called with a clause about each step that may take seconds; may be empty.
  std::function<void(const std::string& step)> progress;
};

/// A frame that was derived, for a table.
struct DerivedFrame {
  std::string name, link;
  Vec3 position = Vec3::Zero();  ///< in the base frame, with the robot at rest [m]
  std::string certainty;         ///< and the distances of axes
};

/// A generated description of a robot, with a list of properties to be checked before it is used.
struct SetupResult {
  std::string text;                ///< YAML
  std::vector<std::string> notes;  ///< sentences about missing or simplified data
  BodyPoints points;  ///< of the URDF's shapes; the frames have the same indices in the description
  std::vector<DerivedFrame> derived;  ///< joint centres, flange and palm
  /// Derived or assumed properties, in order of importance; the description keeps them (`check`).
  std::vector<std::string> to_check;
};

/// Generates the description of a URDF: chains, fingers, pads, palm, joint centres, limits, natural
/// posture, capsules and allowed pairs, each marked with its certainty. `before` is the text of an
/// existing description, of which sections that a person changed are kept (merge_sections.hpp).
/// Throws InputError for invalid files, and a URDF without hand and arm.
SetupResult make_description(const SetupRequest& request, const std::optional<std::string>& before);

/// The pose of a hand's base on a flange; its orientation is Rz(yaw) Ry(pitch) Rx(roll).
struct HandMount {
  Vec3 position = Vec3::Zero(), rpy = Vec3::Zero();  ///< [m], roll, pitch, yaw [rad]
};

/// A hand to be mounted on the flange of an arm. If no mount is given, the fingers point along the
/// axis of the flange and the back of the hand touches the flange.
struct MountRequest {
  std::filesystem::path arm, hand, out;  ///< descriptions
  std::string name;                      ///< of the robot, "" to join the two names
  std::optional<HandMount> mount = {};
};
/// Generates the description of a hand mounted on an arm. `before` is as for make_description().
SetupResult mount_hand(const MountRequest& request, const std::optional<std::string>& before);

}  // namespace morphe::setup
