#include "pipeline/planning/plan_parts.hpp"

#include <fmt/format.h>

#include <functional>
#include <utility>

namespace morphe::planning {

std::vector<Plan> plan_parts(const PlanningInputs& planner, const Demonstration& demonstration,
                             const HumanMotion& recorded, const Movement& movement,
                             const PartsOptions& options) {
  std::vector<Plan> parts;
  const std::function<void(const Movement&, const std::optional<Vec3>&)> plan_part =
      [&](const Movement& part, const std::optional<Vec3>& offset) {
        Plan plan = plan_movement(planner, demonstration, recorded, part, offset);
        const bool mapped = plan.mapped.position.rows() > 0;
        if (plan.has_trajectory() || !mapped ||
            part.end_s - part.begin_s < 2 * options.min_duration_s) {
          parts.push_back(std::move(plan));
          return;
        }
        Movement first = part, second = part;
        first.end_s = second.begin_s = 0.5 * (part.begin_s + part.end_s);
        plan_part(first, plan.goals.base_offset);
        plan_part(second, plan.goals.base_offset);
      };
  plan_part(movement, {});
  if (parts.size() == 1) return parts;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Movement& own = parts[k].movement;
    const std::string part =
        fmt::format("part {} of {} of a movement of {:.2f} s: {:.2f}–{:.2f} s", k + 1, parts.size(),
                    movement.end_s - movement.begin_s, own.begin_s, own.end_s);
    std::string& detail = parts[k].detail;
    detail += (detail.empty() ? "" : "; ") + part;
  }
  return parts;
}

}  // namespace morphe::planning
