#include "pipeline/explain/replan.hpp"

#include "core/config/fields.hpp"
#include "pipeline/planning/plan_movement.hpp"

namespace morphe::explain {
namespace {

planning::PipelineConfig apply_settings(const planning::RunConfig& config,
                                        const std::vector<std::string>& settings) {
  config::ConfigNode node = config::ConfigNode::parse(config.effective, "the run's config");
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    node.set(setting.substr(0, equals), setting.substr(equals + 1));
  }
  planning::PipelineConfig options;
  config::read_options(node, options);
  const scene::SceneOptions& loaded = config.loaded.options.scene;
  options.scene.objects = loaded.objects;  // including their meshes
  options.scene.file_objects = loaded.file_objects;
  options.scene.meshes = loaded.meshes;
  return options;
}

}  // namespace

Plan replan(const planning::RunConfig& config, const Demonstration& demonstration, const Plan& plan,
            const std::vector<std::string>& settings) {
  const planning::PipelineConfig options = apply_settings(config, settings);
  const planning::PlanningInputs planner{options, config.loaded.robot};
  planning::StageSeconds ignored;
  const planning::Reconstruction rebuilt =
      planning::reconstruct_demonstration(planner, demonstration, ignored);
  if (plan.reason != Reason::no_movement) {
    return planning::plan_movement(planner, rebuilt.on_robot_side, rebuilt.motion, plan.movement,
                                   ignored);
  }
  if (rebuilt.movements.empty()) return plan;
  return planning::plan_movement(planner, rebuilt.on_robot_side, rebuilt.motion,
                                 rebuilt.movements.front(), ignored);
}

}  // namespace morphe::explain
