#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/robot/standing.hpp"

namespace morphe::place {

/// The allowed directions of the axis of the base that is up if the robot stands (z unless its legs
/// tell another). World: X to the person's right, Y forward, Z up.
///   any      any direction
///   floor    up; a robot with a body also faces the person's way
///   ceiling  down
///   wall     horizontal, in any direction
///   side     horizontal, to the person's right or left
enum class MountDirection { any, floor, ceiling, wall, side };
constexpr std::array<std::string_view, 5> names_of(MountDirection) {
  return {"any", "floor", "ceiling", "wall", "side"};
}

/// The parts of the config's placement that the search does not change.
struct FixedCoordinates {
  bool x = false, y = false, z = false;  ///< components of `shoulder_offset`
  bool rotation = false;
};

/// The constraints and the effort of `morphe place`.
struct PlaceOptions {
  MountDirection mount = MountDirection::floor;
  robot::Standing standing;  ///< of the robot, by standing_of()
  double max_tilt_rad = 0;   ///< largest angle of the axis to the allowed direction
  FixedCoordinates fixed;
  double person_clearance_m = 0.15;  ///< of the base from the vertical line through the person
  int samples = 16000;               ///< number of poses drawn, of which reachability is evaluated
  int candidates = 600;              ///< number of best poses that are mapped
  int refine = 16;                   ///< number of best poses that are improved
  int plan = 3;                      ///< number of best poses that are planned in full
  int movements = 8;                 ///< maximum number of trials, evenly spread over the dataset
  int jobs = 1;                      ///< number of threads
  std::uint64_t seed = 1;
};
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const PlaceOptions& options);

}  // namespace morphe::place
