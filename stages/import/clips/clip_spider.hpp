#pragma once

#include "stages/import/clips/clip_arrays.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// What SPIDER calls an array: "qpos_wrist_right"; `what`: wrist, finger or obj.
std::string spider_key(const char* what, Side side);

/// Whether the arrays are those of SPIDER's trajectory_keypoints.npz.
bool is_spider(const ClipArrays& clip);

/// Wrists, fingertips and objects of it, in metres with Z up; the time a frame takes and the task
/// from ../task_info.json, as SPIDER lays its files. What is zero throughout is not there.
Demonstration read_spider(ClipArrays& clip, const RecordingFiles& files);

}  // namespace morphe::imports
