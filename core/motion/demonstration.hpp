#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/assumption.hpp"
#include "core/motion/geometry.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/recording_flag.hpp"
#include "core/motion/scene.hpp"
#include "core/motion/side.hpp"

namespace morphe {

/// A stream of marker positions.
struct MarkerStream {
  std::vector<std::string> names;  ///< [K]
  std::vector<double> time;        ///< [N] [s]
  Array2D<Vec3> position;          ///< [N, K] [m], NaN = not seen
};

/// A stream of tracked bodies: sensors on the arm, or the joints of a skeleton. Once the names of
/// the recording are mapped to Morphe's, a skeleton's joints are called right_shoulder,
/// right_elbow, right_wrist, right_index_mcp, right_index_pip, right_index_dip, right_index_tip,
/// right_thumb_cmc, …_mcp, …_ip, …_tip, and likewise left_…. The bodies right_hand and left_hand
/// have their origin at the wrist and the orientation of HumanMotion's hand frame.
struct BodyStream {
  std::vector<std::string> names;    ///< [S]
  std::vector<std::string> parents;  ///< [S] skeleton only, "" = root
  std::vector<double> time;          ///< [N] [s]
  Array2D<Vec3> position;            ///< [N, S] [m]
  Array2D<Quat> orientation;         ///< [N, S]
  Array2D<double> confidence = {};   ///< [N, S] 0 to 1 as given by the tracker, or no rows
  bool reconstructed = false;  ///< true if the motion was reconstructed; it is then not filtered
};

/// A stream of joint angles.
struct AngleStream {
  std::vector<std::string> joints;  ///< [k]
  std::vector<double> time;         ///< [N] [s]
  JointRows angles;                 ///< [N, k] [rad]
};

/// The kind of measurement that a hand stream holds.
enum class HandKind { glove, joint_angles, keypoints, fingertips };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 4> names_of(HandKind) {
  return {"glove", "joint_angles", "keypoints", "fingertips"};
}

/// A stream of measurements of the hand.
struct HandStream {
  HandKind kind = HandKind::fingertips;
  std::vector<std::string> names;  ///< sensors (glove) or joints (joint_angles), else empty
  std::vector<double> time;        ///< [M] [s]
  JointRows angles;                ///< [M, 22 or k] [rad]: glove, joint_angles
  Array2D<Vec3> position;          ///< [M, 21 or 5] [m]: keypoints, fingertips (thumb … little)
};

/// All streams that were recorded at the same time, each with its own sampling rate.
struct Streams {
  std::optional<MarkerStream> markers;
  std::optional<BodyStream> sensors, skeleton;
  std::optional<AngleStream> arm_angles;
  std::optional<HandStream> hand;
};

/// The place of each tracked sensor on the body, in the sensor's frame: the joint centre that it
/// stands for, and the axes of its body segment. The wrist's are those of HumanMotion's hand frame.
struct SensorOffsets {
  std::vector<std::string> sensors;       ///< [S]
  std::vector<Vec3> joint_in_sensor;      ///< [S] [m]
  std::vector<Quat> sensor_from_segment;  ///< [S]
};

/// A phase of a recording as labelled by hand or by the dataset.
struct Label {
  double begin_s = 0, end_s = 0;
  PhaseKind phase = PhaseKind::rest;
};

/// A recording of a person's arm and hand in the world: X to the person's right, Y forward, Z up.
struct Demonstration {
  std::string name, subject, task;
  Side hand = Side::right;
  std::string source, licence;
  std::optional<double> upper_arm, forearm, hand_length, hand_breadth;  ///< [m]
  Streams streams;
  Streams calibration;                          ///< static trial or calibration pose
  std::optional<SensorOffsets> sensor_offsets;  ///< if absent, sensors are at the joints
  std::vector<SceneObject> objects;
  std::vector<Label> labels;                 ///< ground truth, if the dataset has it
  std::vector<RecordingFlag> flags;          ///< doubts about the recording, mended or not
  std::vector<AcceptedFlag> accepted_flags;  ///< doubts that the user has answered in a manifest
  std::vector<std::string> import_notes;     ///< on values that were assumed, repaired or omitted
  std::vector<Assumption> assumptions;       ///< on what the file does not state and nobody gave
};

}  // namespace morphe
