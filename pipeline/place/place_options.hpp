#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace morphe::place {

/// The allowed directions of the base's z axis. World: X to the person's right, Y forward, Z up.
///   any      any direction
///   floor    up
///   ceiling  down
///   wall     horizontal, in any direction
///   side     horizontal, to the person's right or left
enum class MountDirection { any, floor, ceiling, wall, side };
/// Returns the names of the values.
constexpr std::array<std::string_view, 5> names_of(MountDirection) {
  return {"any", "floor", "ceiling", "wall", "side"};
}

/// The parts of the config's placement that are kept in the search.
struct FixedCoordinates {
  /// Components of `shoulder_offset`.
  bool x = false, y = false, z = false;
  /// True if the rotation is kept.
  bool rotation = false;
};

/// The constraints and the effort of `morphe place`.
struct PlaceOptions {
  /// The mount of the base.
  MountDirection mount = MountDirection::any;
  /// Maximum tilt of a mount from its direction [rad].
  double max_tilt_rad = 0;
  /// The coordinates that are kept.
  FixedCoordinates fixed;
  /// Minimum distance of the base from the vertical line through the person's middle [m].
  double person_clearance_m = 0.15;
  /// Number of placements evaluated by reachability only.
  int samples = 16000;
  /// Number of best ones that are mapped in up to three trials with a few frames.
  int candidates = 600;
  /// Number of best ones that are improved over all trials.
  int refine = 16;
  /// Number of best ones that are planned in full.
  int plan = 3;
  /// Maximum number of movements, evenly distributed over the dataset.
  int movements = 8;
  /// Number of threads.
  int jobs = 1;
  /// The seed of the search.
  std::uint64_t seed = 1;
};
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const PlaceOptions& options);

}  // namespace morphe::place
