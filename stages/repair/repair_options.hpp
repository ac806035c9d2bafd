#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/motion/enum_names.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::repair {

/// The repair method; the baseline `rrt_connect` plans all joints at once, with shortcuts only.
enum class Method { humanlike, rrt_connect };
constexpr std::array<std::string_view, 2> names_of(Method) { return {"humanlike", "rrt_connect"}; }

/// The person's tempo, which a path is made to keep at the expense of its goals (planning's
/// keep_tempo()).
struct TempoOptions {
  double max_duration_ratio = 1.5;   ///< longest duration, over the person's
  double max_tip_error_ratio = 1.3;  ///< largest mean error of the tips, over that of the path
};
template <class Fields>
void fields(Fields& f, TempoOptions& o) {
  f("max_duration_ratio", o.max_duration_ratio, bounds::kFactorFrom1);
  f("max_tip_error_ratio", o.max_tip_error_ratio, bounds::kFactorFrom1);
}

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
  std::optional<TempoOptions> tempo;
};
template <class Fields>
void fields(Fields& f, RepairOptions& o) {
  f("method", o.method);
  f("attempts", o.attempts, bounds::kSearchCountOrNone);
  f("max_iterations", o.max_iterations, bounds::kCount);
  f("widen_samples", o.widen_samples, bounds::kCount);
  f("range", o.range, bounds::kFactor);
  f("shortcut_attempts", o.shortcut_attempts, bounds::kCountOrNone);
  f("pull_back_attempts", o.pull_back_attempts, bounds::kCountOrNone);
  f("mapping_searches", o.mapping_searches, bounds::kSearchCountOrNone);
  f("extra_clearance", o.extra_clearance, bounds::kLength);
  f("tempo", o.tempo);
}

}  // namespace morphe::repair
