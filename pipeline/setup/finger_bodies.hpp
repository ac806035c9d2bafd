#pragma once

#include <string>
#include <vector>

#include "pipeline/setup/find_hand.hpp"

namespace morphe::setup {

/// Returns the points of a moving frame's body and of bodies fixed to it, in the base frame, with
/// the robot's frames at `poses`. -1 is the body that does not move.
std::vector<Vec3> body_points(const Kinematics& robot, int moving, const BodyPoints& points,
                              const std::vector<Pose>& poses);

/// Returns the farthest frame from an axis that is fixed to the frame `last` and named a tip; else
/// that has no shapes; else -1.
int find_urdf_tip(const Kinematics& robot, int last, const BodyPoints& points);

/// A point of a body, and the evidence for it.
struct BodyPoint {
  int frame = -1;
  Vec3 position = Vec3::Zero();  ///< in the frame [m]
  /// derived: of shapes; read: a frame of the file; assumed: the centre of mass or the joint.
  Provenance sure = Provenance::assumed;

  /// Returns the point in the base frame.
  Vec3 at(const std::vector<Pose>& poses) const { return poses[frame] * position; }
};
/// Returns the middle of a finger's last body: the mean point of its shapes, the tip in the file,
/// the centre of mass, or the origin of the last joint.
BodyPoint body_middle(const Kinematics& robot, const Finger& finger, const BodyPoints& points);
/// Returns the end of a finger's last body, farthest from the point `from` in the base frame at
/// rest: of its shapes, the tip in the file, the point twice as far from the joint as the centre of
/// mass, or the origin of the last joint.
BodyPoint body_end(const Kinematics& robot, const Finger& finger, const BodyPoints& points,
                   const Vec3& from);

/// Returns the mean of points.
Vec3 mean_of(const std::vector<Vec3>& points);
/// Returns the part of a vector that is perpendicular to a unit vector.
Vec3 perpendicular_part(const Vec3& v, const Vec3& axis);

}  // namespace morphe::setup
