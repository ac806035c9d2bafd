#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/collision/certified.hpp"
#include "core/motion/plan.hpp"

namespace morphe::check {

/// Exact distances, certified between samples; or FCL's verdict alone, at samples less than a
/// margin apart.
enum class Engine { closed, fcl };
constexpr std::array<std::string_view, 2> names_of(Engine) { return {"closed", "fcl"}; }

struct CheckOptions {
  Tolerances tolerances;
  Engine engine = Engine::closed;
  double jump_step = 0.06;  ///< a joint step that may be a change of basin [rad per 10 ms]; one
                            ///< that slides: a tenth of it [m per 10 ms]
};
template <class Fields>
void fields(Fields& f, CheckOptions& o) {
  f("margin", o.tolerances.margin);
  f("contact_depth", o.tolerances.contact_depth);
  f("tracking_grasp", o.tolerances.tracking_grasp);
  f("tracking", o.tolerances.tracking);
  f("out_of_reach_share", o.tolerances.out_of_reach_share);
  f("farthest_tip", o.tolerances.farthest_tip);
  f("engine", o.engine);
  f("jump_step", o.jump_step);
}
std::string why_invalid(const CheckOptions& options);

/// Whether sample k of a path counts to grasp and hold, and its tips by the tighter tolerance:
/// samples beside the grasp do, as some of the motion between does.
bool grasps_around(const Movement& movement, const std::vector<double>& time, std::size_t k);

/// Everything that keeps a path from being executed, one finding for each cause and pair of names
/// in a row of samples, ordered by begin, then cause and names. Empty = free. Times are the path's
/// demonstration times, the tips follow the goals at them.
///   self, object, table  the pair comes nearer than it may, at a sample or on the straight line to
///                        the next one (an object named "table" is the table). From the last sample
///                        before to the first one after. Depth: what is missing at the worst place
///                        that was looked at; where nothing was found but freedom could not be
///                        proved either, the band of 0.1 mm that is left open, less the slack.
///                        A target with an attached_frame moves with it as the path takes it
///   limit                a joint beyond a limit by more than 1e-9 rad (or not a number); depth: by
///                        how much
///   tracking             a tip farther from its goal than its phase allows (grasp and hold, and
///                        the samples beside them: tracking_grasp); depth: what is beyond that
///   jump                 a joint's step that is larger than jump_step in its time and 3 times the
///                        mean of its neighbours: a fast smooth motion is none. Steps to or from a
///                        planned sample are none either. Depth: what is beyond jump_step
std::vector<Finding> check_path(const collision::CollisionWorld& world, const Goals& goals,
                                const Movement& movement, const JointPath& path,
                                const CheckOptions& options);

}  // namespace morphe::check
