#pragma once

#include "core/motion/demonstration.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// Reads a table of tracked bodies, points or a glove's sensors (see capture_columns.hpp) as
/// streams in the world and in metres: bodies become `sensors`, points `markers`, the glove `hand`
/// (all 22 sensors, NaN for those missing in the file). An empty cell or NaN means not seen.
/// Assumptions, repairs and omissions are added to `reports`, prefixed by the file's name; names
/// that were renamed are added to `used`. Throws InputError for errors of read_capture_columns(), a
/// row with another number of cells, time that does not advance or jumps by more than an hour, a
/// pose with some of its numbers but not all, a quaternion whose norm is off by more than 2 %,
/// angles of more than a turn (glove: half a turn), and missing axes, unit or rate, if needed.
Streams read_capture_file(const std::filesystem::path& file, const RecordingFiles& files,
                          std::vector<std::string>& used, std::vector<std::string>& reports);

}  // namespace morphe::imports
