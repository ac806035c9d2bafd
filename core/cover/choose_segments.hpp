#pragma once

#include <string>
#include <vector>

#include "core/collision/distance.hpp"
#include "core/cover/voxels.hpp"

namespace morphe::cover {

/// Chooses at most `budget` capsules that cover all points, greedily from random segments inside
/// the body: `deep_thirds` thirds of these are near the medial axis. All radii get the least common
/// growth that suffices; the result is empty if max_growth_m does not. `name` seeds the segments.
std::vector<collision::CapsuleBody> choose_segments(const Voxels& voxels,
                                                    const std::vector<Vec3>& points,
                                                    int deep_thirds, int budget,
                                                    double max_growth_m, const std::string& name);

}  // namespace morphe::cover
