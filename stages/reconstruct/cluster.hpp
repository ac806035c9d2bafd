#pragma once

#include <vector>

#include "pipeline/motion/geometry.hpp"
#include "pipeline/motion/rigid.hpp"

namespace morphe {

/// Tracks of a rigid cluster, [marker][frame], `still` its points in the static trial. A marker
/// that is missing where three others are seen is put where the rigid motion of the others carries
/// it, plus its own deviation from rigidity before and after the gap (interpolated): no step at the
/// gap's ends. Other gaps are left.
void complete_cluster(const std::vector<Vec3>& still, std::vector<std::vector<Vec3>>& tracks);

}  // namespace morphe
