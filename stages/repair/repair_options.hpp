#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/motion/enum_names.hpp"

namespace morphe::repair {

/// The repair method; the baseline `rrt_connect` plans all joints at once, with shortcuts only.
enum class Method { humanlike, rrt_connect };
constexpr std::array<std::string_view, 2> names_of(Method) { return {"humanlike", "rrt_connect"}; }

/// The options of repair.
struct RepairOptions {
  Method method = Method::humanlike;
  int attempts = 3;                ///< number of planning attempts, each wider than the last
  int max_iterations = 3000;       ///< iterations of the planner per attempt and interval
  int widen_samples = 20;          ///< samples added on each side of a finding, times the attempt
  double range = 0.1;              ///< longest step of the planner, in shares of a joint's span
  int shortcut_attempts = 100;     ///< number of shortcuts tried in a planned interval
  int pull_back_attempts = 200;    ///< number of windows pulled towards the original path
  int mapping_searches = 3;        ///< number of searches for candidate paths of the whole movement
  double extra_clearance = 0.005;  ///< clearance in addition to the margin during planning [m]
};
template <class Fields>
void fields(Fields& f, RepairOptions& o) {
  f("method", o.method);
  f("attempts", o.attempts);
  f("max_iterations", o.max_iterations);
  f("widen_samples", o.widen_samples);
  f("range", o.range);
  f("shortcut_attempts", o.shortcut_attempts);
  f("pull_back_attempts", o.pull_back_attempts);
  f("mapping_searches", o.mapping_searches);
  f("extra_clearance", o.extra_clearance);
}
/// Returns an error sentence, or "" if the options are valid.
std::string validation_error(const RepairOptions& options);

}  // namespace morphe::repair
