#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/scene.hpp"
#include "core/moveit/read_messages.hpp"
#include "core/robot/files/description.hpp"

namespace morphe::moveit {

/// A goal that a point of a link is in one of several bodies, in the robot's base frame.
struct PositionGoal {
  int frame = -1;  ///< frame of the robot, -1 = base
  Vec3 point_in_frame = Vec3::Zero();
  std::vector<SceneObject> regions;  ///< spheres, boxes, cylinders; at least one
};

/// A goal of approximately base_from_frame = orientation * Rx Ry Rz with angles within +-tolerance:
/// MoveIt measures intrinsic x, y, z angles of the difference.
struct OrientationGoal {
  int frame = -1;
  Quat orientation = Quat::Identity();  ///< base_from_frame
  Vec3 tolerance = Vec3::Zero();        ///< about x, y, z [rad]
};

/// A goal: every joint in [lower, upper] (its limits if no joint goal is given) and every link at
/// its position and orientation goals. A joint goal without tolerance has lower = upper for all n.
struct PlanningGoal {
  JointVector lower, upper;  ///< [n] [rad]
  std::vector<PositionGoal> positions;
  std::vector<OrientationGoal> orientations;
};

/// A planning problem read from MoveIt's messages.
struct PlanningProblem {
  /// The description's robot, with the allowed collisions of the scene added.
  RobotModel robot;
  Scene scene;  ///< in the robot's base frame
  JointVector start;
  std::vector<PlanningGoal> goals;  ///< alternative goals, at least one
  /// "FILE:LINE: ...": entries that have no effect here.
  std::vector<std::string> notes;
};

/// Reads a MoveIt planning scene (moveit_msgs/PlanningScene) and a motion plan request
/// (moveit_msgs/MotionPlanRequest) as YAML, as written by MotionBenchMaker. Objects can be boxes,
/// spheres, cylinders and explicit meshes, with several shapes each ("shelf", "shelf_2", ...).
/// Numbers are in m and rad, quaternions x, y, z, w. Joints that the robot does not have (or that
/// are held) are noted. The start state is the request's, or the scene's for joints that the
/// request omits. Pairs of links in the allowed collision matrix are not checked; its entries for
/// objects are noted and ignored, so these pairs are checked: the result may be too strict, but
/// never too permissive. Link names are those of the URDF. Throws InputError with file, line and
/// key for entries that cannot be read or that would change the problem: an unknown or missing
/// shape, a frame, link or joint that does not exist, attached objects, planes, an octomap,
/// padding, path constraints, a start outside the limits. A start or goal in collision is left to
/// the planner to detect.
PlanningProblem read_moveit_problem(const std::filesystem::path& scene_file,
                                    const std::filesystem::path& request_file,
                                    const robot::RobotDescription& robot);

/// Reads the goal_constraints of a request.
std::vector<PlanningGoal> read_goals(const config::ConfigNode& request,
                                     const robot::RobotDescription& robot,
                                     const FixedFrames& frames);

}  // namespace morphe::moveit
