#include "pipeline/planning/plan_requirements.hpp"

#include <fmt/format.h>

#include "core/config/fields.hpp"
#include "core/files/sha256.hpp"
#include "core/motion/input_error.hpp"
#include "pipeline/planning/approach.hpp"
#include "pipeline/planning/assumptions.hpp"
#include "pipeline/planning/pipeline_config.hpp"
#include "pipeline/planning/unpacked_inputs.hpp"
#include "stages/scene/configured_body.hpp"

namespace morphe::planning {
namespace {

robot::RobotDescription robot_in(const std::filesystem::path& file, const UnpackedInputs& files) {
  robot::RobotDescription robot = robot::load_robot(file);
  for (const std::filesystem::path& own : robot.files) {
    if (!files.contains(own))
      throw InputError(fmt::format("{}: names a file that is not in /inputs", file.string()));
  }
  return robot;
}

/// Returns the robot of the first input file that has the configured name and is a valid robot.
robot::RobotDescription robot_of(const PipelineConfig& config, const UnpackedInputs& files) {
  std::string error_text = fmt::format("/inputs: does not contain {}", config.robot.file);
  for (const std::filesystem::path& file : files.find_all(config.robot.file)) {
    try {
      return robot_in(file, files);
    } catch (const InputError& error) {
      error_text = error.what();
    }
  }
  throw InputError(error_text);
}

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

void add_bodies(const std::vector<scene::ConfiguredObject>& objects, PlanRequest& request) {
  for (const scene::ConfiguredObject& object : objects) {
    PlanRequest::Body& body = request.bodies.emplace_back();
    if (object.file.empty()) {
      body.object = scene::configured_body(object, 0);
      body.relative_to = relative_to(object.relative_to);
    } else {
      body.object.name = object.name;
    }
  }
}

/// Returns the objects of the scene file; empty without one, and for a file with meshes.
std::vector<scene::ConfiguredObject> file_objects(const scene::SceneOptions& scene,
                                                  const UnpackedInputs& files) {
  if (scene.file.empty()) return {};
  const std::filesystem::path file = files.find(scene.file);
  if (file.empty()) throw InputError(fmt::format("/inputs: does not contain {}", scene.file));
  scene::SceneOptions file_only;
  file_only.table = scene.table;
  file_only.file = file.string();
  const config::ConfigNode node =
      config::ConfigNode::parse(fmt::format("{{file: '{}'}}", file.string()), "/@config");
  try {
    scene::load_scene_files(file_only, node);
  } catch (const InputError&) {
    return {};
  }
  return file_only.file_objects;
}

}  // namespace

PlanRequest plan_requirements(const PlanFileHeader& header) {
  config::ConfigNode node = config::ConfigNode::parse(header.config, "/@config");
  PipelineConfig config;
  config::read_document(node, config);
  if (config::write_options(config) != header.config)
    throw InputError(
        fmt::format("/@config: differs from what this version writes ({})", header.software));
  const UnpackedInputs files(header.inputs);
  PlanRequest request;
  try {
    robot::RobotDescription robot = robot_of(config, files);
    request.robot = std::move(robot.table);
    request.assumptions = config_assumptions(config, robot.assumed, {});
    add_bodies(config.scene.objects, request);
    add_bodies(file_objects(config.scene, files), request);
  } catch (const InputError& error) {
    throw InputError(files.with_stored_paths(error.what()));
  }
  request.config_sha256 = files::sha256(header.config);
  request.tolerances = tolerances_of(config);
  request.refused_flags = config.audit.refuse;
  request.must_be_known = config.must_be_known;
  request.goal_step_s = 1 / config.reconstruct.rate_hz;
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
