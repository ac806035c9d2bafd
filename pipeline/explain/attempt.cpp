#include "pipeline/explain/attempt.hpp"

#include "core/config/fields.hpp"
#include "pipeline/planning/plan_movement.hpp"

namespace morphe::explain {
namespace {

planning::PipelineConfig changed(const planning::RunConfig& config,
                                 const std::vector<std::string>& settings) {
  config::ConfigNode node = config::ConfigNode::parse(config.effective, "the run's config");
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    node.set(setting.substr(0, equals), setting.substr(equals + 1));
  }
  planning::PipelineConfig options;
  config::read_options(node, options);
  const scene::SceneOptions& loaded = config.loaded.options.scene;
  options.scene.objects = loaded.objects;  // with their meshes
  options.scene.file_objects = loaded.file_objects;
  options.scene.meshes = loaded.meshes;
  return options;
}

}  // namespace

Plan plan_again(const planning::RunConfig& config, const Demonstration& demonstration,
                const Plan& plan, const std::vector<std::string>& settings) {
  const planning::PipelineConfig options = changed(config, settings);
  const planning::Planner planner{options, config.loaded.robot};
  planning::StageSeconds ignored;
  const planning::Rebuilt rebuilt = planning::rebuild(planner, demonstration, ignored);
  if (plan.reason != Reason::no_movement) {
    return planning::plan_movement(planner, rebuilt.beside, rebuilt.motion, plan.movement, ignored);
  }
  if (rebuilt.movements.empty()) return plan;
  return planning::plan_movement(planner, rebuilt.beside, rebuilt.motion, rebuilt.movements.front(),
                                 ignored);
}

}  // namespace morphe::explain
