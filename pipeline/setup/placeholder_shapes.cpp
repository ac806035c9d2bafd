#include "pipeline/setup/placeholder_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::setup {
namespace {

bool is_inside(const SceneObject& object, const Vec3& in_frame) {
  const Pose frame_from_object = Eigen::Translation3d(object.position[0]) * object.orientation[0];
  const Vec3 point = frame_from_object.inverse() * in_frame;
  const double across = std::hypot(point.x(), point.y()), along = std::abs(point.z());
  switch (object.shape) {
    case Shape::sphere:
      return point.norm() < object.size[0];
    case Shape::box:
      return (2 * point.cwiseAbs() - Vec3(object.size[0], object.size[1], object.size[2]))
                 .maxCoeff() < 0;
    case Shape::cylinder:
      return across < object.size[0] && 2 * along < object.size[1];
    case Shape::capsule:
      return std::hypot(across, std::max(0.0, along - object.size[1] / 2)) < object.size[0];
    case Shape::mesh:
      break;
  }
  return false;
}

}  // namespace

std::vector<std::string> remove_finger_placeholder_shapes(const Kinematics& robot, const Hand& hand,
                                                          const std::vector<Pad>& pads,
                                                          LinkShapes& shapes) {
  const RobotModel& table = robot.table();
  std::vector<std::vector<Pose>> postures;
  for (const JointVector& q : {robot.rest, table.lower, table.upper})
    robot::forward_kinematics(table, q, postures.emplace_back());
  std::vector<std::string> links;
  for (auto& [frame, objects] : shapes.shapes_by_frame) {
    if (robot::moving_frame_of(table, frame) != robot::moving_frame_of(table, hand.root)) continue;
    const auto contains_pad = [&, f = frame](const SceneObject& object) {
      return std::ranges::any_of(postures, [&](const std::vector<Pose>& poses) {
        return std::ranges::any_of(pads, [&](const Pad& pad) {
          const Pose base_from_pad = poses[pad.frame] * pad.frame_from_pad;
          return is_inside(object, poses[f].inverse() * base_from_pad.translation());
        });
      });
    };
    if (std::erase_if(objects, contains_pad) > 0) links.push_back(robot.link[frame]);
  }
  return links;
}

}  // namespace morphe::setup
