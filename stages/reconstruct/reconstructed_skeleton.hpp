#pragma once

#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Returns the motion of a skeleton that was already reconstructed (BodyStream::reconstructed).
/// Shoulder, elbow, wrist and finger joints keep their positions, the hand has the orientation of
/// right_hand, and the tips have those of their joints. Values are not filtered and gaps not
/// bridged; between recorded times they are interpolated linearly. A joint whose confidence is
/// always 0 was estimated. The angles of the arm are computed if no joint of it was estimated.
HumanMotion motion_from_reconstructed(const BodyStream& body, const ReconstructOptions& options);

}  // namespace morphe::reconstruct
