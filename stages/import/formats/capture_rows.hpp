#pragma once

#include "core/motion/demonstration.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// A table of tracked bodies, points or a glove's sensors (see capture_columns.hpp) as streams in
/// the world and in metres: bodies become `sensors`, points `markers`, the glove `hand` (all 22
/// sensors, those that the file lacks NaN). No cell, or NaN, was not seen. What was assumed,
/// repaired or left out is said in `reports`, with the file's name in front; names that were
/// renamed go into `used`. InputError for what read_capture_columns() refuses, a row with another
/// number of cells, time that does not advance or jumps by more than an hour, a pose with some of
/// its numbers but not all, a quaternion whose norm is off by more than 2 %, angles of more than a
/// turn (glove: half a turn), and axes, a unit or a rate that is needed but given nowhere.
Streams read_capture_file(const std::filesystem::path& file, const RecordingFiles& files,
                          std::vector<std::string>& used, std::vector<std::string>& reports);

}  // namespace morphe::imports
