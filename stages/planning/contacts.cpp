#include "stages/planning/contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "pipeline/collision/mesh_solid.hpp"
#include "pipeline/math/seed.hpp"
#include "stages/grasp/close_fingers.hpp"
#include "stages/grasp/demonstrated.hpp"
#include "stages/planning/place_movement.hpp"

namespace morphe::planning {
namespace {

bool is_among(const std::vector<std::string>& tips, const robot::Robot& robot, std::size_t tip) {
  return std::ranges::find(tips, robot.tips[tip].name) != tips.end();
}

}  // namespace

Tolerances tolerances_of(const PipelineConfig& config, const Contacts& contacts) {
  Tolerances tolerances = config.check.tolerances;
  if (contacts.asked) {
    tolerances.contact_depth = config.grasp->penetration_m;
  }
  return tolerances;
}

void touch_target(const Planner& planner, const Movement& movement, const Contacts& contacts,
                  PlacedMovement& placed) {
  const grasp::GraspOptions& options = *planner.config.grasp;
  if (const SceneObject* target = object_named(placed.scene.objects, movement.target)) {
    const auto mesh = collision::mesh_solid_of(*target, planner.config.scene.meshes);
    placed.touches = grasp::demonstrated_touches(planner.robot, placed.goals, movement,
                                                 {*target, mesh.get()}, options);
    std::erase_if(placed.touches, [&](const grasp::Touch& touch) {
      return is_among(contacts.given_up, planner.robot, touch.tip);
    });
    grasp::aim_pads(planner.robot, placed.touches, movement, *target, placed.goals);
  }
  if (placed.touches.empty() && !movement.target.empty()) {
    placed.notes.push_back(fmt::format(
        "no contact: no fingertip's skin was within {:.0f} mm of {} for {:.0f} % of the grasp",
        1e3 * options.near_m, movement.target, 100 * options.least_share));
  }
}

void close_other_fingers(const Planner& planner, const collision::CollisionWorld& world,
                         const std::vector<std::string>& given_up, std::uint64_t seed, Plan& plan,
                         PlacedMovement& placed, map::MapResult& mapped) {
  const grasp::HoldTime when = grasp::hold_time(plan.movement);
  const bool tips_count = planner.config.map.mode != map::MapMode::joint_to_joint;
  if (placed.touches.empty() || world.target < 0 || !tips_count) return;
  const auto at = std::ranges::lower_bound(plan.goals.time, when.begin_s);
  if (at == plan.goals.time.end()) return;
  const auto frame = at - plan.goals.time.begin();
  std::vector<std::size_t> tips = grasp::tips_without_goals(planner.robot, plan.goals, when);
  std::erase_if(tips, [&](std::size_t tip) { return is_among(given_up, planner.robot, tip); });
  const grasp::ClosedFingers closed =
      grasp::close_fingers(world, *at, tips, mapped.path.position.row(frame).transpose());
  const std::vector<grasp::Closing>& closings = closed.closings;
  placed.notes.insert(placed.notes.end(), closed.open.begin(), closed.open.end());
  if (closings.empty()) return;
  const SceneObject& target = world.scene->objects[static_cast<std::size_t>(world.target)];
  grasp::aim_closings(planner.robot, closings, plan.movement, target, mapped.path.position,
                      plan.goals);
  placed.problem = map::make_mapping_problem(planner.robot, plan.goals, placed.world,
                                             planner.config.map, plan.movement.phases);
  mapped = map::map_again(placed.problem, plan.goals, std::move(mapped), planner.config.map,
                          math::seed_from(seed, "closed"));
  for (const grasp::Closing& closing : closings) placed.touches.push_back(closing.touch);
}

std::vector<std::string> tips_in_the_way(const robot::Robot& robot, const Goals& goals,
                                         const std::vector<Finding>& findings) {
  std::vector<std::string> tips;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    bool touches = false;
    for (std::size_t f = 0; f < goals.frames(); ++f) {
      touches = touches || goals.pad_share(f, tip) > 0;
    }
    if (!touches) continue;
    const std::string &name = robot.tips[tip].name,
                      &link =
                          robot.capsules[static_cast<std::size_t>(robot.pads[tip].capsule)].name;
    const bool concerned = std::ranges::any_of(findings, [&](const Finding& finding) {
      return finding.first == name || finding.first == link || finding.second == link;
    });
    if (concerned) tips.push_back(name);
  }
  return tips;
}

}  // namespace morphe::planning
