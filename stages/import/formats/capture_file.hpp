#pragma once

#include "core/motion/demonstration.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// Reads a table of tracked bodies, points or a glove's sensors (see capture_columns.hpp) as
/// streams in the world and in metres: bodies become `sensors`, points `markers`, the glove `hand`
/// (all 22 sensors, NaN for those missing in the file). Notes are added to `reports`, prefixed by
/// the file's name; keys of the name map that occur in the header are added to `used`. Throws
/// InputError for errors of the header and the rows (capture_table.hpp), a position or rotation
/// with only some of its numbers, a quaternion whose norm differs from 1 by 2 % or more, angles of
/// more than a turn (glove: half a turn), and distances above 30 m. Throws UnresolvedConvention if
/// axes, unit or rate are needed and missing.
Streams read_capture_file(const std::filesystem::path& file, const RecordingFiles& files,
                          std::vector<std::string>& used, std::vector<std::string>& reports);

}  // namespace morphe::imports
