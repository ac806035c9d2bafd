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
  if (options.scene.target.body && loaded.target.body)
    options.scene.target.body->mesh = loaded.target.body->mesh;
  options.scene.meshes = loaded.meshes;
  return options;
}

}  // namespace

Plan replan(const planning::RunConfig& config, const Demonstration& demonstration, const Plan& plan,
            const std::vector<std::string>& settings) {
  const planning::PipelineConfig options = apply_settings(config, settings);
  const planning::PlanningInputs planner{options, config.loaded.robot};
  const planning::Reconstruction reconstruction =
      planning::reconstruct_demonstration(planner, demonstration);
  const bool has_movement = plan.reason != Reason::no_movement;
  if (!has_movement && reconstruction.movements.empty()) return plan;
  Movement movement = has_movement ? plan.movement : reconstruction.movements.front();
  if (plan.delivered) movement.end_s = plan.delivered->requested_end_s;
  return planning::plan_movement(planner, reconstruction.on_robot_side, reconstruction.motion,
                                 movement);
}

}  // namespace morphe::explain
