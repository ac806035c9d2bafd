#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/collision/distance.hpp"
#include "core/cover/voxels.hpp"

namespace morphe::cover {

/// The limits of the distance by which capsules stand off the body.
struct StandoffLimits {
  double aim_m = 0;                     ///< standoff with which the fewest capsules are taken
  std::vector<std::uint8_t> forbidden;  ///< [voxels] 1 where no capsule may be; empty: nowhere
};

/// Capsules that stand off the body by at most a growth.
struct Segments {
  std::vector<collision::CapsuleBody> capsules;
  double growth_m = 0;
};

/// Chooses at most `budget` capsules that cover all points. The growth is the aim or, if the budget
/// does not suffice for it, the least for which it does. Capsules are chosen greedily by the number
/// of points that they add, from random segments inside the body and from balls about points that
/// remain, which are drawn out along the body's `directions` while they have room; then their ends
/// are moved while they add more. With forbidden voxels only the aim is tried, and the result may
/// be empty. `name` seeds the random numbers.
Segments choose_segments(const Voxels& voxels, const std::vector<Vec3>& points,
                         const std::vector<Vec3>& directions, int budget,
                         const StandoffLimits& limits, const std::string& name);

}  // namespace morphe::cover
