#pragma once

#include <string>
#include <vector>

#include "core/robot/files/urdf_model.hpp"

namespace morphe::setup {

/// A line through a point, in the base frame.
struct Line {
  Vec3 point = Vec3::Zero(), direction = Vec3::UnitZ();  ///< [m], unit vector
};

/// The frames of a URDF with all joints as near to zero as their limits allow.
struct Kinematics {
  const robot::UrdfModel* model = nullptr;
  JointVector rest;                        ///< joint positions
  std::vector<Pose> base_from_frame;       ///< [frames]
  std::vector<std::vector<int>> children;  ///< [frames]
  std::vector<std::string> link;           ///< [frames]

  const RobotModel& table() const { return model->table; }
  const RobotModel::Frame& frame(int f) const { return model->table.frames[f]; }
  /// Returns the pose of a frame in the base frame.
  const Pose& pose(int f) const { return base_from_frame[f]; }
  /// Returns true if a joint moves the frame relative to its parent.
  bool moves(int f) const { return frame(f).joint >= 0; }
  /// Returns the axis about which a moving frame turns or along which it slides.
  Line axis(int f) const;
  /// Returns +1 or -1: the direction from rest into the larger part of a moving frame's range.
  double closing_sign(int f) const;
};
/// Returns the joint positions nearest to zero within the robot's limits.
JointVector rest_position(const RobotModel& robot);
/// Computes the kinematics of a URDF, which must outlive them.
Kinematics kinematics_of(const robot::UrdfModel& model);

/// Returns the moving frames from `above` (exclusive; -1 = base) to `frame` (inclusive), in order.
std::vector<int> joint_frames_between(const Kinematics& robot, int above, int frame);

/// Returns the point of a line nearest to another point.
Vec3 project_onto_line(const Line& line, const Vec3& point);
/// Returns the point with the least sum of squared distances from lines that are not all parallel.
Vec3 point_nearest_to_lines(const std::vector<Line>& lines);
/// Returns the distance of a point from a line [m].
double distance(const Line& line, const Vec3& point);
/// Returns the distance of two lines from each other [m].
double distance(const Line& one, const Line& other);
/// Returns true if two lines have nearly the same direction, in either sense.
bool are_parallel(const Line& one, const Line& other);

}  // namespace morphe::setup
