#include <fmt/format.h>

#include <algorithm>

#include "core/moveit/read_messages.hpp"
#include "tests/support/moveit_problem.hpp"

namespace morphe::moveit {
namespace {

struct GoalReader {
  const robot::RobotDescription& robot;
  const FixedFrames& frames;
  PlanningGoal goal = {};

  int link_frame(const config::ConfigNode& node) const {
    const config::ConfigNode name = node["link_name"];
    const auto found = robot.links.find(name.text());
    if (found == robot.links.end()) name.fail(fmt::format("there is no link '{}'", name.text()));
    return found->second;
  }

  void joint(const config::ConfigNode& node) {
    const RobotModel& table = robot.table;
    const std::string name = node["joint_name"].text();
    const auto found = std::ranges::find(table.joint_names, name);
    if (found == table.joint_names.end()) {
      node["joint_name"].fail(fmt::format("there is no actuated joint '{}'", name));
    }
    const auto j = static_cast<Eigen::Index>(found - table.joint_names.begin());
    const auto tolerance = [&](const char* key) {
      const double value = node.has(key) ? node[key].number() : 0;
      if (value < 0) node[key].fail("must not be negative");
      return value;
    };
    const double position = node["position"].number();
    goal.lower[j] = std::max(goal.lower[j], position - tolerance("tolerance_below"));
    goal.upper[j] = std::min(goal.upper[j], position + tolerance("tolerance_above"));
    if (goal.lower[j] > goal.upper[j]) {
      node["position"].fail(fmt::format("{} is outside the joint's limits, {} to {}", position,
                                        table.lower[j], table.upper[j]));
    }
  }

  void position(const config::ConfigNode& node) {
    PositionGoal wanted;
    wanted.frame = link_frame(node);
    if (node.has("target_point_offset")) {
      wanted.point_in_frame = read_vector(node["target_point_offset"]);
    }
    const config::ConfigNode region = node["constraint_region"];
    wanted.regions = read_shapes(region, frames.pose_of(node));
    if (region.has("meshes") && !region["meshes"].items().empty()) {
      region["meshes"].fail("must be empty; only primitives are supported as goal regions");
    }
    goal.positions.push_back(std::move(wanted));
  }

  void orientation(const config::ConfigNode& node) {
    OrientationGoal wanted;
    wanted.frame = link_frame(node);
    wanted.orientation = Quat(frames.pose_of(node).linear()) * read_rotation(node["orientation"]);
    static constexpr const char* kKeys[] = {
        "absolute_x_axis_tolerance", "absolute_y_axis_tolerance", "absolute_z_axis_tolerance"};
    for (int k = 0; k < 3; ++k) {
      if (!node.has(kKeys[k])) continue;
      wanted.tolerance[k] = node[kKeys[k]].number();
      if (wanted.tolerance[k] < 0) node[kKeys[k]].fail("must not be negative");
    }
    goal.orientations.push_back(wanted);
  }

  PlanningGoal read(const config::ConfigNode& node) {
    goal = {robot.table.lower, robot.table.upper, {}, {}};
    const auto joints = items_of(node, "joint_constraints");
    const auto positions = items_of(node, "position_constraints");
    const auto orientations = items_of(node, "orientation_constraints");
    refuse(node, "visibility_constraints", "visibility constraints are not supported");
    if (joints.empty() && positions.empty() && orientations.empty())
      node.fail("has no constraints");
    for (const config::ConfigNode& item : joints) joint(item);
    for (const config::ConfigNode& item : positions) position(item);
    for (const config::ConfigNode& item : orientations) orientation(item);
    return goal;
  }
};

}  // namespace

std::vector<PlanningGoal> read_goals(const config::ConfigNode& request,
                                     const robot::RobotDescription& robot,
                                     const FixedFrames& frames) {
  std::vector<PlanningGoal> goals;
  const config::ConfigNode list = request["goal_constraints"];
  GoalReader reader{robot, frames};
  for (const config::ConfigNode& node : list.items()) goals.push_back(reader.read(node));
  if (goals.empty()) list.fail("has no goals");
  return goals;
}

}  // namespace morphe::moveit
