#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// The properties of a recording that identify it within a dataset, without its samples.
struct RecordingDescriptor {
  std::vector<std::string> folders;  ///< folders below the dataset, outermost first
  std::string stem;                  ///< the file's name without its extension
  std::string format;                ///< name of its format
  std::string subject;               ///< subject named in the file, or ""
  /// Names of the markers, sensors or joints that were seen, sorted.
  std::vector<std::string> points;
  std::vector<double> rms_deviation_m;  ///< [m] rms deviation of each point from its mean position
  std::size_t samples = 0;              ///< number of frames
  bool has_markers = false;             ///< true for a recording of markers
};

/// Returns the points of a demonstration with their deviations; folders, stem and format stay
/// empty.
RecordingDescriptor recording_descriptor(const Demonstration& demonstration);

/// Returns true if the person is stationary: the three largest rms deviations of the points are
/// below 20 mm (static trials of ue-adl: below 4 mm, their shortest reaches: 58 mm).
bool is_stationary(const RecordingDescriptor& sketch);

/// Returns true if two files contain the same recording: the number of samples is equal, and points
/// of the same names have similar deviations.
bool same_recording(const RecordingDescriptor& a, const RecordingDescriptor& b);

/// The hand that reaches in a recording.
struct ReachingHand {
  Side side = Side::right;
  std::string why;  ///< a sentence with the reason
};

/// Returns the side whose points move farther, among those whose names contain a side: RTHUM,
/// LeftHand, hand_r. For keypoints the side follows from the curl of the fingers. Otherwise the
/// right one is assumed.
ReachingHand reaching_hand(const Demonstration& demonstration, const RecordingDescriptor& sketch);

/// Returns true if there are points whose names contain that side. The names of sensors, gloves and
/// keypoints, which belong to a single hand, contain no side.
bool has_points_of_side(const RecordingDescriptor& sketch, Side side);

}  // namespace morphe::imports
