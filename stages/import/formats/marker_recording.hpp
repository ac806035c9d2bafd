#pragma once

#include <string>
#include <vector>

#include "stages/import/formats/rigid_bodies.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// The contents of a file of markers, in its own axes, but in metres.
struct MarkerRecording {
  MarkerStream markers;
  RigidBodies bodies;                     ///< on the markers' clock, if the format has them
  double unit_m = 1;                      ///< metres in the file's unit
  std::string subject;                    ///< "" if absent
  std::string axes;                       ///< as Conventions::axes; "" if absent
  std::vector<std::string> import_notes;  ///< assumptions and repairs
};

/// Reads a file of one format.
using MarkerReader = MarkerRecording (*)(const std::filesystem::path& file, const Conventions&);

/// Reads a recording and its static trial into the world, with mapped names. The axes are the
/// user's; without them, the file's; without these, `usual_axes`, which is reported, or, if that is
/// "", throw_unknown_axes(). Points that stand for unseen markers become unseen
/// (unseen_points.hpp); they and markers that were never seen are reported. Points of the recording
/// that are named as joints become a skeleton (extract_joints.hpp); its rigid bodies are added as
/// in rigid_bodies.hpp, those of the static trial are left out. Throws UnresolvedConvention "unit"
/// if the markers extend over more than 30 m or, three or more, over less than 2 mm, and InputError
/// for repeated names.
Demonstration read_marker_recording(const RecordingFiles& files, MarkerReader read,
                                    const std::string& usual_axes = "");

}  // namespace morphe::imports
