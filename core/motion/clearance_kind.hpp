#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/motion/enum_names.hpp"
#include "core/motion/geometry.hpp"

namespace morphe {

/// The bodies between which a clearance is measured. `self`: parts of the robot; `table`: the
/// object "table" and the robot, or the target that it carries; `objects`: likewise any other
/// object but the target; `target`: the target and the robot.
enum class ClearanceKind : std::uint8_t { self, table, objects, target };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 4> names_of(ClearanceKind) {
  return {"self", "table", "objects", "target"};
}
/// The number of kinds.
inline constexpr int kClearanceKindCount = 4;

/// The least distance along a trajectory between bodies of one kind that may not touch.
struct KindClearance {
  ClearanceKind kind = ClearanceKind::self;
  double clearance = kUnknown;  ///< lower bound, to 0.01 mm [m]
  std::string first, second;    ///< names of the closest bodies
  double time_s = kUnknown;     ///< time of the trajectory at which they are closest [s]
};

}  // namespace morphe
