#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace morphe::place {

/// Which way the base's z axis may point. World: X to the person's right, Y forward, Z up.
///   any      anywhere
///   floor    up
///   ceiling  down
///   wall     level, in any direction
///   side     level, to the person's right or left
enum class Mount { any, floor, ceiling, wall, side };
constexpr std::array<std::string_view, 5> names_of(Mount) {
  return {"any", "floor", "ceiling", "wall", "side"};
}

/// What of the config's placement is not searched for.
struct Kept {
  bool x = false, y = false, z = false;  ///< of `shoulder_offset`
  bool rotation = false;
};

/// `morphe place`: what is allowed, and how long it is looked for.
struct PlaceOptions {
  Mount mount = Mount::any;
  double tilt_rad = 0;  ///< by which a mount may lean from its direction
  Kept keep;
  double person_m = 0.15;  ///< the base keeps this far from the person's middle, a plumb line
  int samples = 16000;     ///< places looked at by reach alone
  int candidates = 600;    ///< the best of them, mapped in three trials with a few frames
  int refined = 16;        ///< the best of these, improved over all trials
  int planned = 3;         ///< the best of these, planned in full
  int trials = 8;          ///< movements at most, evenly over the dataset
  int jobs = 1;            ///< threads
  std::uint64_t seed = 1;
};
/// "", or what is wrong.
std::string why_invalid(const PlaceOptions& options);

}  // namespace morphe::place
