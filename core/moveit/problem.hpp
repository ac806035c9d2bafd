#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/scene.hpp"
#include "core/robot/files/description.hpp"

namespace morphe::moveit {

/// A point of a link must lie in one of the bodies, everything in the robot's base frame.
struct PositionGoal {
  int frame = -1;  ///< of the robot, -1 = base
  Vec3 point_in_frame = Vec3::Zero();
  std::vector<SceneObject> regions;  ///< spheres, boxes, cylinders; never empty
};

/// base_from_frame = orientation * Rx Ry Rz with angles within +-tolerance, or nearly so: MoveIt
/// measures intrinsic x, y, z angles of the difference.
struct OrientationGoal {
  int frame = -1;
  Quat orientation = Quat::Identity();  ///< base_from_frame
  Vec3 tolerance = Vec3::Zero();        ///< about x, y, z [rad]
};

/// One way of being done: every joint in [lower, upper] (its limits where nothing was asked for)
/// and every link where it is wanted. A joint goal without tolerance has lower = upper for all n.
struct PlanningGoal {
  JointVector lower, upper;  ///< [n] [rad]
  std::vector<PositionGoal> positions;
  std::vector<OrientationGoal> orientations;
};

struct PlanningProblem {
  RobotTable robot;  ///< the description's, with the pairs that the scene allows added
  Scene scene;       ///< in the robot's base frame
  JointVector start;
  std::vector<PlanningGoal> goals;  ///< at least one; any of them will do
  std::vector<std::string> notes;   ///< "FILE:LINE: ...": what was read but has no effect here
};

/// A MoveIt planning scene (moveit_msgs/PlanningScene) and a motion plan request
/// (moveit_msgs/MotionPlanRequest) as YAML, which is how MotionBenchMaker writes them. Objects:
/// boxes, spheres, cylinders, meshes written out, several shapes each ("shelf", "shelf_2", ...).
/// Numbers in m and rad, quaternions x, y, z, w. Joints that the robot does not have (or holds
/// still) are noted. The start is the request's, and where that says nothing the scene's. Pairs of
/// links that the allowed collision matrix names never collide; its entries for objects are noted
/// and stay checked: too much is refused, never too little. Link names are those of the URDF.
/// InputError with file, line and key for what cannot be read and for what would change the
/// question: an unknown or missing shape, a frame, link or joint that does not exist, attached
/// objects, planes, an octomap, padding, path constraints, a start outside the limits.
/// A start or goal in collision is for the planner to find.
PlanningProblem read_moveit_problem(const std::filesystem::path& scene_file,
                                    const std::filesystem::path& request_file,
                                    const robot::RobotDescription& robot);

/// The objects of a planning scene by themselves, in the scene's world frame.
Scene read_moveit_scene(const std::filesystem::path& scene_file);

}  // namespace morphe::moveit
