#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/moveit/read_messages.hpp"
#include "tests/support/moveit_problem.hpp"

namespace morphe::moveit {
namespace {

constexpr double kLimitTolerance_rad = 1e-6;  ///< limits are rounded in files [rad]

std::string source_location(const config::ConfigNode& node) {
  return fmt::format("{}:{}", node.file().string(), node.line());
}

/// Reads the robot_state of a scene, or the start_state of a request.
struct StateReader {
  const RobotModel& robot;
  JointVector position;
  Pose world_from_base = Pose::Identity();
  std::set<std::string> unknown;

  void read(const config::ConfigNode& owner, const char* key) {
    if (!owner.has(key)) return;
    const config::ConfigNode state = owner[key];
    refuse(state, "attached_collision_objects", "attached objects are not supported");
    if (state.has("joint_state")) read_joints(state["joint_state"]);
    if (state.has("multi_dof_joint_state")) read_base(state["multi_dof_joint_state"]);
  }

  void read_joints(const config::ConfigNode& node) {
    if (!node.has("name") && !node.has("position")) return;
    const std::vector<std::string> names = node["name"].texts();
    const std::vector<double> values = node["position"].numbers(bounds::kJointPosition);
    if (names.size() != values.size()) {
      node["position"].fail(
          fmt::format("has {} values for {} joints", values.size(), names.size()));
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto found = std::ranges::find(robot.joint_names, names[k]);
      if (found == robot.joint_names.end()) {
        unknown.insert(names[k]);
      } else {
        position[found - robot.joint_names.begin()] = values[k];
      }
    }
  }

  void read_base(const config::ConfigNode& node) {
    const std::vector<config::ConfigNode> transforms = items_of(node, "transforms");
    if (transforms.size() > 1)
      node["transforms"].fail("must have only one transform, that of the base");
    if (!transforms.empty()) world_from_base = read_transform(transforms.front());
  }
};

void check_start(const config::ConfigNode& request, const RobotModel& robot, JointVector& start) {
  for (std::size_t k = 0; k < robot.joints(); ++k) {
    const auto j = static_cast<Eigen::Index>(k);
    const auto fail = [&](const std::string& what) {
      const std::string message = fmt::format("joint '{}' {}", robot.joint_names[k], what);
      if (request.has("start_state")) request["start_state"].fail(message);
      request.fail("start_state: " + message);
    };
    if (std::isnan(start[j])) fail("has no position, here or in the scene");
    const double inside = std::clamp(start[j], robot.lower[j], robot.upper[j]);
    if (std::abs(inside - start[j]) > kLimitTolerance_rad) {
      fail(fmt::format("starts at {}, outside its limits, {} to {}", start[j], robot.lower[j],
                       robot.upper[j]));
    }
    start[j] = inside;
  }
}

void allow_links(const robot::RobotDescription& robot, const std::string& one,
                 const std::string& other, RobotModel& table) {
  const int first = robot.links.at(one), second = robot.links.at(other);
  const int count = static_cast<int>(table.capsules.size());
  for (int i = 0; i < count; ++i) {
    for (int k = i + 1; k < count; ++k) {
      const int a = table.capsules[static_cast<std::size_t>(i)].frame;
      const int b = table.capsules[static_cast<std::size_t>(k)].frame;
      if ((a == first && b == second) || (a == second && b == first)) {
        table.allowed_collision_pairs.push_back({i, k});
      }
    }
  }
}

/// Reads the allowed collision matrix. Rows are lists of booleans, or {enabled: [...]} as in the
/// message.
void read_allowed_collisions(const config::ConfigNode& scene, const robot::RobotDescription& robot,
                             PlanningProblem& problem) {
  if (!scene.has("allowed_collision_matrix")) return;
  const config::ConfigNode matrix = scene["allowed_collision_matrix"];
  if (!matrix.has("entry_names")) return;
  const std::vector<std::string> names = matrix["entry_names"].texts();
  const std::vector<config::ConfigNode> rows = matrix["entry_values"].items();
  if (rows.size() != names.size()) matrix["entry_values"].fail("must be as long as entry_names");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<config::ConfigNode> row =
        (rows[i].is_map() ? rows[i]["enabled"] : rows[i]).items();
    if (row.size() != names.size()) rows[i].fail("must be as long as entry_names");
    for (std::size_t k = 0; k < i; ++k) {
      if (!row[k].boolean()) continue;
      if (robot.links.contains(names[i]) && robot.links.contains(names[k])) {
        allow_links(robot, names[i], names[k], problem.robot);
      } else {
        problem.notes.push_back(fmt::format(
            "{}: the allowed collision of {} and {} is ignored: not both are links of this robot",
            source_location(rows[i]), names[i], names[k]));
      }
    }
  }
  auto& pairs = problem.robot.allowed_collision_pairs;
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

std::string root_link(const robot::RobotDescription& robot) {
  const auto root = std::ranges::find_if(robot.links, [&](const auto& link) {
    return robot.table.frames[static_cast<std::size_t>(link.second)].parent < 0;
  });
  return root == robot.links.end() ? "" : root->first;
}

void refuse_padding(const config::ConfigNode& scene, const char* key, const char* value,
                    double neutral) {
  for (const config::ConfigNode& item : items_of(scene, key)) {
    if (item[value].number() != neutral) item[value].fail("padding and scaling are not supported");
  }
}

}  // namespace

PlanningProblem read_moveit_problem(const std::filesystem::path& scene_file,
                                    const std::filesystem::path& request_file,
                                    const robot::RobotDescription& robot) {
  const config::ConfigNode scene = config::ConfigNode::load(scene_file),
                           request = config::ConfigNode::load(request_file);
  PlanningProblem problem;
  problem.robot = robot.table;
  StateReader state{
      robot.table,
      JointVector::Constant(static_cast<Eigen::Index>(robot.table.joints()), kUnknown),
      Pose::Identity(),
      {}};
  state.read(scene, "robot_state");
  state.read(request, "start_state");
  for (const std::string& joint : state.unknown) {
    problem.notes.push_back(
        fmt::format("{}: joint {} is not an actuated joint of this robot; ignored",
                    source_location(request), joint));
  }
  problem.start = state.position;
  check_start(request, robot.table, problem.start);
  refuse_padding(scene, "link_padding", "padding", 0);
  refuse_padding(scene, "link_scale", "scale", 1);
  refuse(request, "path_constraints", "path constraints are not supported");
  refuse(request, "trajectory_constraints", "trajectory constraints are not supported");
  const FixedFrames frames = read_frames(scene, root_link(robot), state.world_from_base.inverse());
  problem.scene = read_objects(scene, frames);
  read_allowed_collisions(scene, robot, problem);
  problem.goals = read_goals(request, robot, frames);
  return problem;
}

}  // namespace morphe::moveit
