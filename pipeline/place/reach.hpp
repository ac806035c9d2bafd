#pragma once

#include <vector>

#include "core/robot/robot.hpp"
#include "pipeline/place/stand.hpp"
#include "pipeline/place/trials.hpp"

namespace morphe::place {

/// Where a robot's tips get, about the axis z of its base: the cells of distance from its shoulder
/// and angle to z that random postures reach, and their neighbours. What lies outside is out of
/// reach (as far as the postures tell); what lies inside need not be in reach.
class Reach {
 public:
  Reach(const robot::Robot& robot, std::uint64_t seed);
  /// [0, 1] of a trial's tip goals, those that lie outside.
  double share_outside(const Trial& trial, const Stand& stand) const;
  const Vec3& shoulder() const { return shoulder_; }  ///< in the base frame [m]

 private:
  static constexpr int kDistances = 40, kAngles = 18;
  bool inside(std::size_t tip, const Vec3& from_shoulder) const;
  std::size_t cell(std::size_t tip, int distance, int angle) const;

  std::size_t tips_;
  Vec3 shoulder_;
  double step_m_ = 1;
  std::vector<char> reached_;  ///< [tips, distances, angles]
};

/// Whether the base may stand there: the origin of its frame, in every trial,
///   - is not below the table's top (nor less than 5 mm above it) where the table is,
///   - keeps `person_m` from the plumb line through the person's middle, 0.2 m to the left of the
///     right shoulder (to the right of the left one): about half a man's shoulder breadth.
bool base_is_free(const std::vector<Trial>& trials, const Stand& stand, const Vec3& shoulder,
                  Side side, const PlaceOptions& options);

/// The base's origin from the human shoulder, along the world's axes [m].
Vec3 base_from_human_shoulder(const Stand& stand, const Vec3& shoulder);

}  // namespace morphe::place
