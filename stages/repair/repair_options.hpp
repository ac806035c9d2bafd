#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/motion/named.hpp"

namespace morphe::repair {

/// `rrt_connect` is a baseline: all joints at once and shortcuts alone.
enum class Method { humanlike, rrt_connect };
constexpr std::array<std::string_view, 2> names_of(Method) { return {"humanlike", "rrt_connect"}; }

struct RepairOptions {
  Method method = Method::humanlike;
  int attempts = 3;             ///< times the planner is tried, each wider than the last
  int iterations = 3000;        ///< of the planner in one attempt at one interval
  int widen_samples = 20;       ///< added on each side of a finding, once more each attempt
  double range = 0.1;           ///< longest step of the planner, in shares of a joint's span
  int shortcut_attempts = 100;  ///< straight lines tried through a planned interval
  int draw_attempts = 200;      ///< windows of it drawn back to the original path
  int searches = 3;  ///< of other courses for the whole movement, where the first leads nowhere
  double extra_clearance = 0.005;  ///< planned with this much more than the margin [m]
};
template <class Fields>
void fields(Fields& f, RepairOptions& o) {
  f("method", o.method);
  f("attempts", o.attempts);
  f("iterations", o.iterations);
  f("widen_samples", o.widen_samples);
  f("range", o.range);
  f("shortcut_attempts", o.shortcut_attempts);
  f("draw_attempts", o.draw_attempts);
  f("searches", o.searches);
  f("extra_clearance", o.extra_clearance);
}
std::string why_invalid(const RepairOptions& options);

}  // namespace morphe::repair
