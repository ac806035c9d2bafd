#pragma once

#include "stages/import/clips/clip_arrays.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// Returns SPIDER's key of an array, such as "qpos_wrist_right"; `what` is wrist, finger or obj.
std::string spider_key(const char* what, Side side);

/// Returns true if the arrays are those of SPIDER's trajectory_keypoints.npz.
bool is_spider(const ClipArrays& clip);

/// Reads its wrists, fingertips and objects, in metres with Z up. The duration of a frame and the
/// task are read from ../task_info.json, as SPIDER arranges its files. Arrays that are always zero
/// are regarded as missing.
Demonstration read_spider(ClipArrays& clip, const RecordingFiles& files);

}  // namespace morphe::imports
