#include "pipeline/explain/collect_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/explain/base_shift.hpp"
#include "pipeline/explain/oversized_target.hpp"
#include "pipeline/explain/reasons.hpp"
#include "pipeline/explain/replan.hpp"

namespace morphe::explain {
namespace {

constexpr double kMaxBaseShift_m = 0.16;
Advice advice_of(const BaseShift& found, const Vec3& configured) {
  const Vec3 mm = (1e3 * found.shift).array().round();
  const Vec3 offset = configured + 1e-3 * mm;
  return {AdviceKind::may_solve,
          {fmt::format("placement.shoulder_offset=[{:.3f}, {:.3f}, {:.3f}]", offset.x(), offset.y(),
                       offset.z())},
          fmt::format("move the base by ({:+.0f}, {:+.0f}, {:+.0f}) mm along the world's axes; the "
                      "summed errors of tips and contacts of single postures at {} times then fall "
                      "from {:.1f} to {:.1f} mm",
                      mm.x(), mm.y(), mm.z(), found.frames, 1e3 * found.depth_before,
                      1e3 * found.depth_after)};
}

/// Adds the advice for a narrower target, unless it would be too narrow, and that for no target.
void add_advice(const OversizedTarget& oversized, const std::string& target,
                std::vector<TriedAdvice>& all) {
  constexpr double kMinTargetRadius_m = 0.005;
  const auto add = [&](std::string setting, std::string text) {
    all.push_back({{AdviceKind::changes_assumption, {std::move(setting)}, std::move(text)}, {}});
  };
  const std::string reason = fmt::format(
      "the {} was not recorded: its radius of {:.0f} mm is inferred from thumb and index, but at "
      "most {:.0f} mm fit beside the goal of {} at {:.2f} s",
      target, 1e3 * oversized.radius_m, 1e3 * std::max(0.0, oversized.allowed_radius_m),
      oversized.tip, oversized.time_s);
  const double radius_m = std::floor(1e3 * oversized.allowed_radius_m) / 1e3;
  if (oversized.allowed_radius_m >= kMinTargetRadius_m)
    add(fmt::format("scene.target.radius={:.3f}", radius_m), reason);
  add("scene.target.infer=false",
      reason +
          "; without a target there is no check for collisions with it, and the plan has no "
          "grasp");
}

}  // namespace

std::vector<TriedAdvice> collect_advice(const robot::Robot& robot, const Plan& plan,
                                        const planning::RunConfig* config,
                                        const Demonstration* demonstration) {
  std::vector<TriedAdvice> all;
  const Dependence& depends_on = explanation_of(plan.reason).depends_on;
  const AdviceContext context = config ? advice_context(config->loaded.options) : AdviceContext{};
  if (config && depends_on.base) {
    const planning::PipelineConfig& options = config->loaded.options;
    if (const auto shift = find_base_shift(robot, options, plan, kMaxBaseShift_m))
      all.push_back({advice_of(*shift, options.placement.shoulder_offset), {}});
  }
  for (Advice& advice : advice_for(robot, plan, context)) all.push_back({std::move(advice), {}});
  if (config && depends_on.distance) {
    if (const auto oversized = find_oversized_target(robot, plan, config->loaded.options.scene))
      add_advice(*oversized, plan.movement.target, all);
  }
  if (!config || !demonstration) return all;
  for (TriedAdvice& one : all) {
    if (one.advice.settings.empty()) continue;
    one.plan = replan(*config, *demonstration, plan, one.advice.settings);
    if (one.plan->executable()) break;
  }
  return all;
}

}  // namespace morphe::explain
