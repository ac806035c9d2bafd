#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// The properties of a recording that identify it within a dataset, without its samples.
struct RecordingDescriptor {
  std::vector<std::string> folders;     ///< folders below the dataset, outermost first
  std::string stem;                     ///< the file's name without its extension
  std::string format;                   ///< name of its format
  std::string subject;                  ///< subject named in the file, or ""
  std::vector<std::string> points;      ///< names of the markers, sensors or joints seen, sorted
  std::vector<double> rms_deviation_m;  ///< of each of `points` from its mean position
  std::size_t frame_count = 0;          ///< number of frames
  bool has_markers = false;             ///< true for a recording of markers
};

/// Returns the subject and points of a demonstration; folders, stem and format stay empty.
RecordingDescriptor recording_descriptor(const Demonstration& demonstration);

/// Returns true if the third largest rms deviation of a point (with fewer points, the smallest) is
/// below 20 mm. Static trials of ue-adl have below 4 mm, their shortest reaches 58 mm.
bool is_stationary(const RecordingDescriptor& descriptor);

/// Returns true if both have equally many frames, more than half of the points of `a` are also in
/// `b`, and the rms deviations of these points differ by at most 0.5 mm.
bool same_recording(const RecordingDescriptor& a, const RecordingDescriptor& b);

/// The hand that reaches in a recording.
struct ReachingHand {
  Side side = Side::right;
  std::string reason;  ///< a sentence
};

/// Returns the side that the curl of the fingers shows, if there are keypoints of a curled hand.
/// Otherwise it is the side whose points move farther, by their names (RTHUM, LeftHand, hand_r), or
/// the only side that has points. If this does not decide, right is assumed.
ReachingHand reaching_hand(const Demonstration& demonstration,
                           const RecordingDescriptor& descriptor);

/// Returns true if the name of a point contains that side; names of sensors contain no side.
bool has_points_of_side(const RecordingDescriptor& descriptor, Side side);

}  // namespace morphe::imports
