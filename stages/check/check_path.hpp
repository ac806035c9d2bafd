#pragma once

#include <vector>

#include "pipeline/collision/certified.hpp"
#include "pipeline/motion/plan.hpp"

namespace morphe {

struct CheckOptions {
  Tolerances tolerances;
  std::string engine = "closed";  ///< closed: exact distances, FCL beside; fcl: FCL alone
  double jump_step = 0.06;        ///< a joint step that may be a change of basin [rad per 10 ms]
};
template <class Fields>
void fields(Fields& f, CheckOptions& o) {
  f("margin", o.tolerances.margin);
  f("contact_depth", o.tolerances.contact_depth);
  f("tracking_grasp", o.tolerances.tracking_grasp);
  f("tracking", o.tolerances.tracking);
  f("engine", o.engine);
  f("jump_step", o.jump_step);
}
std::string check(const CheckOptions& options);

/// Everything that keeps a path from being executed, joined into intervals and ordered by begin:
/// `self`, `object`, `table` (certified between samples too; an object named "table" is the table),
/// `limit` (joint beyond its limits), `tracking` (tip farther from its goal than allowed in its
/// phase), `jump`. Empty = free. Tips follow the goals at the path's demonstration times.
std::vector<Finding> check_path(const CollisionWorld& world, const Goals& goals,
                                const Movement& movement, const JointPath& path,
                                const CheckOptions& options);

}  // namespace morphe
