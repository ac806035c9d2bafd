#pragma once

#include <string>

#include "core/motion/export.hpp"
#include "core/motion/recording_flag.hpp"

namespace morphe {

/// Returns a flag as a line: "spike (mended), 1.42–1.43 s: RFTP moves at 20 m/s …".
MORPHE_EXPORT std::string sentence(const RecordingFlag& flag);

}  // namespace morphe
