#pragma once

#include <string>
#include <vector>

#include "core/robot/files/urdf_model.hpp"

namespace morphe::setup {

/// A line through a point, in the base frame.
struct Line {
  Vec3 point = Vec3::Zero(), direction = Vec3::UnitZ();
};

/// A URDF's frames with all joints as near to zero as their limits allow.
struct Kinematics {
  const robot::UrdfModel* model = nullptr;
  JointVector rest;
  std::vector<Pose> base_from_frame;
  std::vector<std::vector<int>> children;  ///< [frames]
  std::vector<std::string> link;           ///< [frames] the link that each is

  const RobotTable& table() const { return model->table; }
  const RobotTable::Frame& frame(int f) const {
    return model->table.frames[static_cast<std::size_t>(f)];
  }
  const Pose& pose(int f) const { return base_from_frame[static_cast<std::size_t>(f)]; }
  bool moves(int f) const { return frame(f).joint >= 0; }
  /// Axis of a frame that moves, along which it turns or slides.
  Line axis(int f) const;
  /// +1 or -1: towards the larger side of its range from rest, as a value of the frame.
  double closing_sense(int f) const;
};
Kinematics kinematics_of(const robot::UrdfModel& model);

/// The frames that move on the way from below `above` (-1 = base) to a frame, itself included.
std::vector<int> moving_between(const Kinematics& robot, int above, int frame);

/// The point of a line nearest to another point.
Vec3 foot(const Line& line, const Vec3& point);
/// The point with the least sum of squared distances from lines that are not all parallel.
Vec3 nearest_point(const std::vector<Line>& lines);
double distance(const Line& line, const Vec3& point);

}  // namespace morphe::setup
