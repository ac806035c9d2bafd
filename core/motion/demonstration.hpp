#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"
#include "core/motion/side.hpp"

namespace morphe {

struct MarkerStream {
  std::vector<std::string> names;  ///< [K]
  std::vector<double> time;        ///< [N] [s]
  Table<Vec3> position;            ///< [N, K] [m], NaN = not seen
};

/// Tracked bodies: `sensors` (Liberty: shoulder, elbow, wrist) or a `skeleton`, whose joints of the
/// arm are called right_shoulder, right_elbow, right_wrist, right_index_mcp, _pip, _dip, _tip
/// (thumb: _cmc, _mcp, _ip, _tip) and left_… once the names of the recording are mapped to ours;
/// right_hand and left_hand stand at the wrist, turned as HumanMotion's hand frame.
struct BodyStream {
  std::vector<std::string> names;    ///< [S]
  std::vector<std::string> parents;  ///< [S] skeleton only, "" = root
  std::vector<double> time;          ///< [N] [s]
  Table<Vec3> position;              ///< [N, S] [m]
  Table<Quat> orientation;           ///< [N, S]
  Table<double> confidence = {};     ///< [N, S] 0 to 1 as the tracker gave it, or no rows
  bool rebuilt = false;              ///< joints of a motion that was rebuilt: nothing is filtered
};

struct AngleStream {
  std::vector<std::string> joints;  ///< [k]
  std::vector<double> time;         ///< [N] [s]
  JointRows angles;                 ///< [N, k] [rad]
};

enum class HandKind { glove, joint_angles, keypoints, fingertips };
constexpr std::array<std::string_view, 4> names_of(HandKind) {
  return {"glove", "joint_angles", "keypoints", "fingertips"};
}

struct HandStream {
  HandKind kind = HandKind::fingertips;
  std::vector<std::string> names;  ///< sensors (glove) or joints (joint_angles), else empty
  std::vector<double> time;        ///< [M] [s]
  JointRows angles;                ///< [M, 22 or k] [rad]: glove, joint_angles
  Table<Vec3> position;            ///< [M, 21 or 5] [m]: keypoints, fingertips (thumb … little)
};

/// What was recorded at one go, each stream at its own rate.
struct Streams {
  std::optional<MarkerStream> markers;
  std::optional<BodyStream> sensors;
  std::optional<BodyStream> skeleton;
  std::optional<AngleStream> arm_angles;
  std::optional<HandStream> hand;
};

/// Where a tracked sensor sits on the body: the joint centre it stands for and the axes of its
/// segment (those of HumanMotion's hand frame for the wrist), in the sensor's frame.
struct SensorOffsets {
  std::vector<std::string> sensors;       ///< [S]
  std::vector<Vec3> joint_in_sensor;      ///< [S] [m]
  std::vector<Quat> sensor_from_segment;  ///< [S]
};

struct Label {
  double begin_s = 0, end_s = 0;
  PhaseKind phase = PhaseKind::rest;
};

/// One recording of one person's arm and hand. World frame: X to the subject's right, Y forward,
/// Z up; the importer brings a recording into it.
struct Demonstration {
  std::string name, subject, task;
  Side hand = Side::right;
  std::string source, licence;
  std::optional<double> upper_arm, forearm, hand_length, hand_breadth;  ///< [m]
  Streams streams;
  Streams calibration;                          ///< static trial or calibration pose
  std::optional<SensorOffsets> sensor_offsets;  ///< from the calibration pose; none = at the joints
  std::vector<SceneObject> objects;
  std::vector<Label> labels;  ///< ground truth, where known
  /// What the importer assumed, repaired or left out, a sentence each.
  std::vector<std::string> reports;
};

}  // namespace morphe
