#pragma once

#include <string>
#include <vector>

#include "core/robot/files/urdf_model.hpp"

namespace morphe::setup {

/// A line through a point, in the base frame.
struct Line {
  /// A point of the line [m] and its direction (unit vector).
  Vec3 point = Vec3::Zero(), direction = Vec3::UnitZ();
};

/// The frames of a URDF with all joints as near to zero as their limits allow.
struct Kinematics {
  /// The model of the URDF.
  const robot::UrdfModel* model = nullptr;
  /// The joint positions.
  JointVector rest;
  /// The pose of each frame in the base frame.
  std::vector<Pose> base_from_frame;
  /// [frames] children of each frame.
  std::vector<std::vector<int>> children;
  /// [frames] link of each frame.
  std::vector<std::string> link;

  /// Returns the table of the robot model.
  const RobotModel& table() const { return model->table; }
  /// Returns a frame of the table.
  const RobotModel::Frame& frame(int f) const { return model->table.frames[f]; }
  /// Returns the pose of a frame in the base frame.
  const Pose& pose(int f) const { return base_from_frame[f]; }
  /// Returns true if a joint moves the frame relative to its parent.
  bool moves(int f) const { return frame(f).joint >= 0; }
  /// Returns the axis about which a moving frame turns or along which it slides.
  Line axis(int f) const;
  /// Returns +1 or -1: the direction, as a value of the frame, towards the larger part of its
  /// range from rest.
  double closing_sign(int f) const;
};
/// Computes the kinematics of a URDF.
Kinematics kinematics_of(const robot::UrdfModel& model);

/// Returns the moving frames on the path from below `above` (-1 = base) to a frame, including the
/// frame.
std::vector<int> joint_frames_between(const Kinematics& robot, int above, int frame);

/// Returns the point of a line nearest to another point.
Vec3 project_onto_line(const Line& line, const Vec3& point);
/// Returns the point with the least sum of squared distances from lines that are not all parallel.
Vec3 point_nearest_to_lines(const std::vector<Line>& lines);
/// Returns the distance of a point from a line [m].
double distance(const Line& line, const Vec3& point);

}  // namespace morphe::setup
