#pragma once

#include <string>
#include <vector>

#include "stages/import/formats/rigid_bodies.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// The contents of a file of markers, in its own axes, but in metres.
struct MarkerRecording {
  MarkerStream markers;                   ///< markers [m]
  RigidBodies bodies;                     ///< on the markers' clock, if the format has them
  std::string subject;                    ///< "" if absent
  std::string axes;                       ///< as Conventions::axes; "" if absent
  std::vector<std::string> import_notes;  ///< assumptions and repairs
};

/// Reads a recording and its static trial into the world. The axes are the given ones, otherwise
/// the file's, otherwise `usual_axes`, which is reported ("" for an InputError that asks for them);
/// names are mapped. A point exactly at the origin, by which some programs denote an unseen marker,
/// becomes unseen. Markers that were never seen and such points are reported. Throws InputError
/// "FILE: unit: …" if the distances between markers are larger than any capture volume or smaller
/// than any hand, and for repeated names. Points that are named as joints become a skeleton
/// (extract_joints.hpp), rigid bodies are added by rigid_bodies.hpp; those of a static trial are
/// left out.
Demonstration read_marker_recording(const RecordingFiles& files,
                                    MarkerRecording (*read)(const std::filesystem::path&,
                                                            const Conventions&),
                                    const std::string& usual_axes = "");

}  // namespace morphe::imports
