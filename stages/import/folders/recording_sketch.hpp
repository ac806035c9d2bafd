#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// What of a recording is needed to place it among others, without its samples.
struct RecordingSketch {
  std::vector<std::string> folders;  ///< below the dataset, outermost first
  std::string stem;                  ///< the file's name without its extension
  std::string format;
  std::string subject;              ///< that the file names, "" = none
  std::vector<std::string> points;  ///< markers, sensors or joints that were seen, sorted
  std::vector<double> wander;       ///< [m] of each: rms distance from where it is in the mean
  std::size_t samples = 0;
  bool markers = false;  ///< a recording of markers
};

/// The points of a demonstration and how far each wanders; folders, stem and format stay empty.
RecordingSketch sketch_of(const Demonstration& demonstration);

/// Whether the person stands still: of the points the three that wander most do so by less than
/// 20 mm (static trials of ue-adl: below 4 mm, their shortest reaches: 58 mm).
bool stands_still(const RecordingSketch& sketch);

/// The same recording, exported twice: as many samples, and points of the same names wander alike.
bool same_recording(const RecordingSketch& a, const RecordingSketch& b);

/// Which hand a recording tells of.
struct ReachingHand {
  Side side = Side::right;
  std::string why;  ///< a sentence
};

/// The side whose points wander farther, of those whose names say a side: RTHUM, LeftHand, hand_r.
/// Keypoints tell it by how the fingers curl. Otherwise the right one is assumed.
ReachingHand reaching_hand(const Demonstration& demonstration, const RecordingSketch& sketch);

/// Whether there are points whose names say that side. Sensors, gloves and keypoints are those of
/// one hand and say none.
bool shows_hand(const RecordingSketch& sketch, Side side);

}  // namespace morphe::imports
