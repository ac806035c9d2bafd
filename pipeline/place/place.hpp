#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline/place/score.hpp"

namespace morphe::place {

/// What full plans from a placement are like, movement by movement.
struct Planned {
  Measures measures;  ///< means of the mapped frames, but for
                      ///<   out_of_reach: as plans judge it; colliding: share not executable;
                      ///<   upper_arm: of the trajectory, where there is one; speed: tempo
  int movements = 0, executable = 0;
  double upper_arm_median = 0, upper_arm_max = 0;  ///< of the movements' means [rad]
  double tip_error_max_m = kNotSeen;               ///< of executable plans
};

struct Found {
  Stand stand;
  map::PlacementOptions placement;  ///< of that stand, rounded as it was planned
  Measures tried;                   ///< by the search
  Planned planned;
  Vec3 base = Vec3::Zero();       ///< the base's origin from the human shoulder [m]
  double above_table = kNotSeen;  ///< and above the table's top, mean over the movements [m]
};

/// Called with what is done and its share, from one thread at a time.
using Report = std::function<void(const std::string& what, int done, int of)>;

/// Places for the robot's base, one for all movements, the best first.
///   1. `samples` random places that the constraints allow; the `candidates` with the fewest goals
///      outside of where the robot's tips get (Reach)
///   2. these mapped in one trial, the better third in three, with few frames (score.hpp)
///   3. the best `refined` of them that differ, improved by a compass search over shift and turn
///      (refine.hpp) over all trials: all roughly, the better half finely
///   4. the best `planned` of these that differ, planned in full and ordered by that
/// The same options give the same places with any number of threads. InputError if none is allowed.
std::vector<Found> place(const planning::Planner& planner, const std::vector<Trial>& trials,
                         const PlaceOptions& options, const Report& report);

/// The same full plans of one placement.
Found plan_at(const planning::Planner& planner, const std::vector<Trial>& trials,
              const map::PlacementOptions& placement, int jobs);

}  // namespace morphe::place
