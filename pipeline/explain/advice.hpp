#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/map/map_options.hpp"
#include "stages/repair/repair_options.hpp"

namespace morphe::planning {
struct PipelineConfig;
}

namespace morphe::explain {

/// The effect of following an advice.
///   may_solve           the same goals may be met by other means; planning shows whether they are
///   relaxes_tolerance   the violation remains, but is permitted
///   changes_assumption  another assumption replaces that about something not recorded
///   changes_input       the user must change the recording, scene or robot, which no key does
enum class AdviceKind { may_solve, relaxes_tolerance, changes_assumption, changes_input };
constexpr std::array<std::string_view, 4> names_of(AdviceKind) {
  return {"may_solve", "relaxes_tolerance", "changes_assumption", "changes_input"};
}

/// An advice for an infeasible plan.
struct Advice {
  AdviceKind kind = AdviceKind::changes_input;
  std::vector<std::string> settings;  ///< KEY=VALUE for `morphe run --set`, to be set together
  std::string sentence;               ///< the reason, with the numbers of the plan
};

/// The values of a run's config on which advice depends: it asks for more than they are.
struct AdviceContext {
  bool placed_by_search = false;   ///< `morphe place` found the placement: it is not advised again
  double base_offset_limit_m = 0;  ///< map.base_offset.limit
  int map_starts = map::MapOptions{}.starts, map_candidates = map::MapOptions{}.candidates;
  int mapping_searches = repair::RepairOptions{}.mapping_searches;
  int repair_attempts = repair::RepairOptions{}.attempts;
  int repair_iterations = repair::RepairOptions{}.max_iterations;
};
/// Returns the context of a config.
AdviceContext advice_context(const planning::PipelineConfig& config);
/// Returns the context of the config in a plans.h5; the default one if this version cannot read it.
AdviceContext advice_context(const std::string& stored_config);

/// Returns at least one advice for an infeasible plan, those that may solve it first.
std::vector<Advice> advice_for(const robot::Robot& robot, const Plan& plan,
                               const AdviceContext& context = {});

/// Returns the sentence, after "may solve it: --set map.starts=96 …: " if there are settings.
std::string text_of(const Advice& advice);

}  // namespace morphe::explain
