#pragma once

#include <optional>

#include "stages/import/audit/doubt.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// Returns the answer to the question of a doubt in the recording's own conventions: the axes and
/// the unit that the body determines, any other value unchanged. There is no answer if the
/// recording cannot be read with these axes, this unit or this hand, or then has the same doubt.
std::optional<Guess> tested_answer(const RecordingFormat& format, const RecordingFiles& files,
                                   const Doubt& doubt);

}  // namespace morphe::imports
