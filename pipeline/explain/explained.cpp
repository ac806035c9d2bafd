#include "pipeline/explain/explained.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/explain/attempt.hpp"
#include "pipeline/explain/base_shift.hpp"
#include "pipeline/explain/inferred_target.hpp"

namespace morphe::explain {
namespace {

constexpr double kMostShift_m = 0.16;

/// To a millimetre, as placements are written.
Advice advice_of(const BaseShift& found, const Vec3& configured) {
  const Vec3 mm = (1e3 * found.shift).array().round();
  const Vec3 offset = configured + 1e-3 * mm;
  return {Effect::solves,
          {fmt::format("placement.shoulder_offset=[{:.3f}, {:.3f}, {:.3f}]", offset.x(), offset.y(),
                       offset.z())},
          fmt::format("the base {:+.0f}, {:+.0f}, {:+.0f} mm along the world's axes: what single "
                      "postures at {} times have wrong, tips and contacts, goes from {:.1f} to "
                      "{:.1f} mm in all",
                      mm.x(), mm.y(), mm.z(), found.frames, 1e3 * found.before, 1e3 * found.after)};
}

/// A narrower target, to a millimetre, where there can be one; and none.
void add_advice(const TargetTooWide& found, const std::string& target,
                std::vector<TriedAdvice>& all) {
  constexpr double kNarrowest_m = 0.005;
  const std::string words = fmt::format(
      "nobody recorded the {}: its radius of {:.0f} mm is inferred from thumb and "
      "index, and there is room for {:.0f} mm beside the goal of {} at {:.2f} s",
      target, 1e3 * found.radius_m, 1e3 * std::max(0.0, found.allowed_m), found.tip, found.time_s);
  if (found.allowed_m >= kNarrowest_m) {
    const double radius_m = std::floor(1e3 * found.allowed_m) / 1e3;
    all.push_back(
        {{Effect::assumes, {fmt::format("scene.target.radius={:.3f}", radius_m)}, words}, {}});
  }
  all.push_back({{Effect::assumes,
                  {"scene.target.infer=false"},
                  words + "; without it nothing is checked against it, and the plan has no grasp"},
                 {}});
}

bool is_about_contact(Reason reason) {
  return reason == Reason::goal_in_collision || reason == Reason::start_in_collision ||
         reason == Reason::no_path || reason == Reason::tracking || reason == Reason::unreachable;
}

/// Whether the place of the base has to do with it.
bool is_about_place(Reason reason) {
  return reason == Reason::unreachable || reason == Reason::tracking ||
         reason == Reason::goal_in_collision || reason == Reason::start_in_collision ||
         reason == Reason::no_path || reason == Reason::jump || reason == Reason::limit;
}

}  // namespace

std::vector<TriedAdvice> explained_advice(const robot::Robot& robot, const Plan& plan,
                                          const planning::RunConfig* config,
                                          const Demonstration* demonstration) {
  std::vector<TriedAdvice> all;
  if (config && is_about_place(plan.reason)) {
    const planning::PipelineConfig& options = config->loaded.options;
    if (const auto shift = find_base_shift(robot, options, plan, kMostShift_m))
      all.push_back({advice_of(*shift, options.placement.shoulder_offset), {}});
  }
  for (Advice& advice : advice_for(robot, plan)) all.push_back({std::move(advice), {}});
  if (config && is_about_contact(plan.reason)) {
    if (const auto wide = target_too_wide(robot, plan, config->loaded.options.scene))
      add_advice(*wide, plan.movement.target, all);
  }
  if (!config || !demonstration) return all;
  for (TriedAdvice& one : all) {
    if (one.advice.settings.empty()) continue;
    one.plan = plan_again(*config, *demonstration, plan, one.advice.settings);
    if (one.plan->executable()) break;
  }
  return all;
}

}  // namespace morphe::explain
