#pragma once

#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Returns the motion contained in a skeleton that was already reconstructed (BodyStream::rebuilt),
/// without change: shoulder, elbow, wrist and finger joints at their positions, the hand with the
/// orientation of right_hand, tips with those of their joints. The data are neither filtered nor
/// bridged nor moved. If the times differ from those of the clock, values are interpolated
/// linearly. A joint whose confidence is always 0 was estimated. The angles of the arm are computed
/// if no joint of it was estimated.
HumanMotion motion_from_reconstructed(const BodyStream& body, const ReconstructOptions& options);

}  // namespace morphe::reconstruct
