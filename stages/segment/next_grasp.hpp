#pragma once

#include <vector>

#include "stages/segment/interaction.hpp"
#include "stages/segment/movement_unit.hpp"

namespace morphe::segment {

/// Movement units, and for each of them whether it leaves an object for the next grasp: the hand
/// puts a recorded object down in the unit before, does not go home, and then takes another one, or
/// the same one after it was kMaxHandDistance_m away. Such a unit is the last of its movement.
struct LeavingUnits {
  std::vector<MovementUnit> units;
  std::vector<bool> leaves;
};

/// Finds the units that leave an object for the next grasp. One that is also the reach of the next
/// grasp is divided at the time at which the fingertips are farthest from both objects. Home is the
/// place from which the hand set out for the first object.
LeavingUnits find_leaving_units(const HandRecord& hand, std::vector<MovementUnit> units);

}  // namespace morphe::segment
