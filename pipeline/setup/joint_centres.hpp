#pragma once

#include <optional>
#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// Axes that pass a point within this distance count as meeting in it [m]. Of the shipped arms the
/// Gen3 misses most (5.9 mm); the least offset made on purpose is that of a Gen2 (9.8 mm).
inline constexpr double kMaxAxisDistance_m = 0.01;

/// A point fixed in a frame that corresponds to a joint of the human.
struct JointCentre {
  int frame = -1;
  Vec3 position = Vec3::Zero();  ///< in the frame [m]
  Provenance sure = Provenance::derived;
  double axis_distance_m = 0;  ///< largest distance of the point from the axes that define it
  /// An axis of the joint that does not define the centre, and its distance from it.
  struct Offset {
    int frame = -1;
    double distance_m = 0;
  };
  std::vector<Offset> offset_axes = {};  ///< those farther than kMaxAxisDistance_m
};

/// The shoulder, elbow and wrist of an arm, derived from its axes, not from the frames' origins.
struct ArmCentres {
  JointCentre shoulder, elbow, wrist;
};
/// Returns a centre's position in the base frame, with the robot at rest.
Vec3 position_in_base(const Kinematics& robot, const JointCentre& centre);

/// Returns the shoulder of one to three moving frames. It is on the first of the axes that define
/// it, nearest to all of these: all axes if they pass one point within kMaxAxisDistance_m, else the
/// last or the first two of three that do. If no two meet, it is the point of the last but one of
/// three, nearest to the last, or of the last of two, nearest to the first. On a single axis, it is
/// the origin of its frame (assumed).
JointCentre shoulder_centre(const Kinematics& robot, const std::vector<int>& frames);

/// Returns the elbow: the point of its axis nearest to the shoulder.
JointCentre elbow_centre(const Kinematics& robot, int frame, const Vec3& shoulder);

/// Returns the wrist from the moving frames beyond the elbow: where the first two consecutive axes
/// meet within kMaxAxisDistance_m, else on that of the two that pass each other most closely which
/// bends the wrist, nearest to the other (assumed). Of a single axis, it is the point nearest to
/// the elbow if it is parallel to the elbow's, else the one nearest to the end of the arm
/// (assumed). Without axes, it is that end (assumed). The origin of the last frame stands for an
/// unknown end.
JointCentre wrist_centre(const Kinematics& robot, int elbow, const std::vector<int>& beyond,
                         const std::optional<Vec3>& end);

/// Returns the frame of a finger's middle joint. Of the hinges with axes within 25 degrees of the
/// last one's, it is the last but one of at least three, or the last of two; otherwise -1.
int middle_joint(const Kinematics& robot, const Finger& finger);

}  // namespace morphe::setup
