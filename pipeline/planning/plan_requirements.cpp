#include "pipeline/planning/plan_requirements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/files/sha256.hpp"
#include "core/store/plan_header.hpp"
#include "pipeline/planning/approach.hpp"
#include "pipeline/planning/pipeline_config.hpp"
#include "pipeline/run/config_changes.hpp"
#include "stages/map/placement.hpp"
#include "stages/scene/configured_body.hpp"

namespace morphe::planning {
namespace {

PlanRequest::ReferenceFrame relative_to(scene::ReferenceFrame frame) {
  switch (frame) {
    case scene::ReferenceFrame::table:
      return PlanRequest::ReferenceFrame::table;
    case scene::ReferenceFrame::target:
      return PlanRequest::ReferenceFrame::target;
    case scene::ReferenceFrame::shoulder:
      return PlanRequest::ReferenceFrame::shoulder;
    case scene::ReferenceFrame::base:
      return PlanRequest::ReferenceFrame::base;
    default:
      return PlanRequest::ReferenceFrame::world;
  }
}

PlanRequest::Placement placement_of(const PipelineConfig& config, const RobotModel& robot) {
  return {map::rotation_of(config.placement), config.placement.shoulder_offset,
          config.map.base_offset.limit_m, map::is_hand_only(robot)};
}

PlanRequest::TargetShape target_shape(const scene::TargetOptions& target) {
  PlanRequest::TargetShape shape{{}, target.radius, target.min_radius, target.max_radius};
  if (target.body) scene::set_shape(*target.body, shape.body.emplace());
  return shape;
}

std::vector<std::pair<std::string, double>> other_arm(const scene::SceneOptions& scene) {
  std::vector<std::pair<std::string, double>> capsules;
  for (std::size_t k = 0; scene.other_arm && k < scene::kOtherArmNames.size(); ++k)
    capsules.emplace_back(scene::kOtherArmNames[k], scene.other_arm_radii[k]);
  return capsules;
}

/// Returns what the header says otherwise than its inputs and settings.
std::vector<std::string> header_faults(const PlanFileHeader& header, const LoadedConfig& loaded) {
  std::vector<std::string> faults;
  if (loaded.effective != header.config) {
    for (const std::string& change : run::config_changes(header.config, loaded.effective))
      faults.push_back("@config: " + change);
    if (faults.empty())
      faults.push_back(
          fmt::format("@config: differs from what this version writes ({})", header.software));
  }
  if (header.config_sha256 != files::sha256(header.config)) faults.emplace_back("config_sha256");
  for (const PlanFileHeader::Input& input : header.inputs) {
    const auto path = (std::filesystem::path("/inputs") / input.path).lexically_normal();
    if (std::ranges::find(loaded.files, path) == loaded.files.end())
      faults.push_back(path.string() + " is not read");
  }
  if (header.inputs_sha256 != store::inputs_hash(header)) faults.emplace_back("inputs_sha256");
  return faults;
}

}  // namespace

PlanRequest plan_requirements(const PlanFileHeader& header) {
  const LoadedConfig loaded = reload_config(header);
  const PipelineConfig& config = loaded.options;
  PlanRequest request;
  request.header_faults = header_faults(header, loaded);
  request.robot = loaded.robot;
  request.assumptions = loaded.assumptions;
  for (const scene::ConfiguredObject* object : scene::configured_objects(config.scene))
    request.bodies.push_back(
        {scene::configured_body(*object, 0), relative_to(object->relative_to)});
  request.tolerances = tolerances_of(config);
  request.refused_flags = config.audit.refuse;
  request.must_be_known = config.must_be_known;
  request.goal_step_s = 1 / config.reconstruct.rate_hz;
  request.sample_step_s = 1 / config.retime.sample_rate_hz;
  request.placement = placement_of(config, request.robot);
  request.target = target_shape(config.scene.target);
  request.other_arm = other_arm(config.scene);
  request.limit_scaling = config.retime.limit_scaling;
  if (!config.split && !config.segment.whole_recording)
    request.plan_until = config.segment.plan_until;
  for (const segment::TaskEnd& end : config.segment.plan_until_by_task)
    request.plan_until_by_task.emplace_back(end.task, end.until);
  request.partial = config.split ? PartialPlans::never : config.segment.partial;
  if (is_carried_by_palm(config))
    request.carrier_frame = request.robot.frames[request.robot.palm_frame].name;
  if (config.approach)
    request.home = {home_posture(request.robot, *config.approach), config.approach->limit_scaling,
                    config.approach->retreat};
  return request;
}

}  // namespace morphe::planning
