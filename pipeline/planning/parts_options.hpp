#pragma once

#include <string>

#include "core/motion/key_bounds.hpp"

namespace morphe::planning {

/// The options for planning a movement of a hand without an arm in parts (config section `split`).
struct PartsOptions {
  double min_duration_s = 1;  ///< minimum duration of a part [s]
};
template <class Fields>
void fields(Fields& f, PartsOptions& o) {
  f("min_duration_s", o.min_duration_s, bounds::kDuration.from(0.1));
}

}  // namespace morphe::planning
