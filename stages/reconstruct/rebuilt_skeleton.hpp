#pragma once

#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// The motion whose joints a skeleton holds (BodyStream::rebuilt), as it was: shoulder, elbow,
/// wrist and finger joints at their places, the hand turned as right_hand, tips as their joints
/// are. Nothing is filtered, bridged or moved. Where the times are not those of the clock, values
/// between them are on straight lines. A joint whose confidence is 0 throughout was estimated.
/// Angles of the arm follow where nothing of it was estimated.
HumanMotion motion_from_rebuilt(const BodyStream& body, const ReconstructOptions& options);

}  // namespace morphe::reconstruct
