#pragma once

#include <string>
#include <vector>

#include "stages/import/clips/clip_arrays.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {

/// The clock of a clip.
struct ClipClock {
  std::vector<double> time;  ///< of its frames [s]
  double seconds = 1;        ///< in one unit of the times in the file
};

/// Reads the objects of a clip that were ever seen, with distinct names.
///   object_<name>_…   objects with their shapes
///   obj_<side>_…      objects that a hand manipulates, and
///   desk_context_…    objects around these, both with the meshes objects/<id>/visual.obj in the
///                     clip's folder or the one above; without a mesh, with a sphere (reported)
///   support_discs     cylinders at rest
std::vector<SceneObject> read_clip_objects(ClipArrays& clip, const ClipClock& clock,
                                           const TrackerFrame& frame,
                                           std::vector<std::string>& reports);

}  // namespace morphe::imports
