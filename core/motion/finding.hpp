#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/motion/geometry.hpp"

namespace morphe {

/// The cause of a finding: the robot collides with itself, an object or the table; a joint exceeds
/// a limit or jumps; a tip is too far from its goal.
enum class Cause : std::uint8_t {
  jump,
  joint_limit,
  object_collision,
  self_collision,
  table,
  tracking
};
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 6> names_of(Cause) {
  return {"jump", "joint_limit", "object_collision", "self_collision", "table", "tracking"};
}
/// Returns true if the cause is a collision with the robot itself, an object or the table.
constexpr bool is_collision(Cause cause) {
  return cause == Cause::self_collision || cause == Cause::object_collision ||
         cause == Cause::table;
}

/// The unit of a finding: metre for distances and sliding joints, radian for revolute joints.
enum class FindingUnit : std::uint8_t { metre, radian };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 2> names_of(FindingUnit) { return {"metre", "radian"}; }

/// Lever by which an angle is multiplied to be compared with distances: the length of a finger [m].
inline constexpr double kLeverOfRadian_m = 0.1;

/// An interval of a path that cannot be executed.
struct Finding {
  double begin_s = 0, end_s = 0;  ///< demonstration time
  Cause cause = Cause::jump;
  std::string subject = {}, other_body = {};  ///< capsule, joint or tip; other capsule or object
  double excess = 0;                          ///< amount by which the limit is exceeded [unit], > 0
  FindingUnit unit = FindingUnit::metre;      ///< of excess and limit
  /// The limit at the largest excess: the required distance, negative if the pair may penetrate;
  /// the joint's limit or largest step; the tip's tolerance [unit].
  double limit = 0;

  /// Returns the excess as a distance [m]; an angle is multiplied by kLeverOfRadian_m.
  double excess_m() const {
    return unit == FindingUnit::radian ? kLeverOfRadian_m * excess : excess;
  }
};

}  // namespace morphe
