#pragma once

#include "stages/import/clips/clip_arrays.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// Returns SPIDER's key of an array, such as "qpos_wrist_right"; `part` is wrist, finger or obj.
std::string spider_key(const char* part, Side side);

/// Returns true if the arrays are those of SPIDER's trajectory_keypoints.npz.
bool is_spider(const ClipArrays& clip);

/// Reads wrists, fingertips and objects of such a file, in metres with Z up, and task and frame
/// period from ../task_info.json, if it exists. Arrays always at 0 or the identity are left out.
Demonstration read_spider(ClipArrays& clip, const RecordingFiles& files);

}  // namespace morphe::imports
