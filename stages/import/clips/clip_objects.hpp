#pragma once

#include <string>
#include <vector>

#include "stages/import/clips/clip_arrays.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {

/// Reads the objects of a clip, each name once: object_<name>_… with their shapes; obj_<side>_…
/// that a hand manipulates and desk_context_… around it, whose meshes are objects/<id>/visual.obj
/// beside the clip or its folder (without a mesh: a ball, which is reported); support_discs. `time`
/// is the clip's.
std::vector<SceneObject> read_clip_objects(ClipArrays& clip, const std::vector<double>& time,
                                           const TrackerFrame& frame,
                                           std::vector<std::string>& reports);

}  // namespace morphe::imports
