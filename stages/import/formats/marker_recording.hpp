#pragma once

#include <string>
#include <vector>

#include "stages/import/formats/rigid_bodies.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// A file of markers as it stands there: its own axes, but metres.
struct MarkerRecording {
  MarkerStream markers;
  RigidBodies bodies;   ///< on the markers' clock, if the format has them
  std::string subject;  ///< "" = not said
  std::string axes;     ///< as Conventions::axes; "" = not said
  std::vector<std::string> reports;
};

/// Recording and static trial in the world: axes as given, else as the file says, else
/// `usual_axes`, which is reported ("" = an InputError that asks for them); names renamed. A point
/// exactly at the origin is how some programs write what was not seen: it becomes that. Markers
/// that were never seen and such points are reported. InputError "FILE: unit: …" if the markers
/// stand farther apart than in any room or nearer than on any hand, and for names that stand twice.
/// Points that are called as joints become a skeleton (joints_of_points.hpp), rigid bodies what
/// rigid_bodies.hpp says; those of a static trial are left out.
Demonstration read_marker_recording(const RecordingFiles& files,
                                    MarkerRecording (*read)(const std::filesystem::path&,
                                                            const Conventions&),
                                    const std::string& usual_axes = "");

}  // namespace morphe::imports
