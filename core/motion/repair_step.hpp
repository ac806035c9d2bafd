#pragma once

#include <cstdint>
#include <string>

#include "core/motion/geometry.hpp"

namespace morphe {

/// What one rung of the repair ladder, or one attempt of it, made of a path.
struct RepairStep {
  std::int32_t level = 0;  ///< 0: a rung; 1: one of the attempts of the rung above
  std::string name;        ///< "re-solve gently"
  double begin_s = kNotSeen, end_s = kNotSeen;  ///< the stretch that it changed, NaN: nothing
  double change = 0;                            ///< of a joint, the largest [rad or m]
  std::int32_t findings = 0;                    ///< that its path has
  double collisions = 0, others = 0;            ///< their depths together [m or rad]
  std::string worst;                            ///< of them, a sentence; "": the path is free
  bool kept = false;                            ///< it was less bad than what was there
  std::string ended;                            ///< why it went no further, "": it was done
};

}  // namespace morphe
