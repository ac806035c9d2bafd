#pragma once

#include <vector>

#include "stages/verify/attached_object.hpp"
#include "stages/verify/body_distance.hpp"
#include "stages/verify/clearance_by_kind.hpp"
#include "stages/verify/curve.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Within this distance, a carried object counts as standing on another one when it is taken or put
/// down, and it may overlap it by as much [m].
inline constexpr double kSupportNoise_m = 0.002;
/// The greatest height above everything else at which a carried object may be released [m].
inline constexpr double kMaxReleaseHeight_m = 0.01;

/// The target as a body in the hand. From the sample at which it is taken (the first one at or
/// after its attach_s) it must be clear of all other objects, also after its release. It may touch
/// one
///   - that is at most kSupportNoise_m away when it is taken, until the first sample at which it is
///     clear of it;
///   - that is at most kSupportNoise_m away at the sample of its release (the first one at or after
///     its release_s, or the last sample), from the last sample at which it is clear of it.
/// Meanwhile it may overlap it by kSupportNoise_m. It is clear at a distance of kSupportNoise_m or
/// the required clearance, whichever is larger.
struct CarriedObject {
  /// The times until which, and from which on, another object may be touched.
  struct Contact {
    double until_s = -kInfinity, from_s = kInfinity;
  };
  int object = -1;                                    ///< -1: nothing is carried
  double begin_s = kInfinity, release_s = kInfinity;  ///< demonstration times of the two samples
  std::vector<Contact> contacts;                      ///< [objects]
  bool stood = false;                 ///< true if it stood on another object when it was taken
  double release_height = kInfinity;  ///< distance from the nearest object at its release [m]

  /// Returns true if another object may be touched in the whole interval.
  bool may_touch(int other, double from_s, double to_s) const {
    const Contact& contact = contacts[other];
    return to_s <= contact.until_s || from_s >= contact.from_s;
  }
  /// Returns the least distance from another object that is allowed in the whole interval [m].
  double required_distance(int other, double from_s, double to_s, double clearance) const {
    return may_touch(other, from_s, to_s) ? -kSupportNoise_m : clearance;
  }
};

/// Returns the target as a body in the hand. `meshes` has one for each object. Nothing is carried
/// without a target with an attach_s that is before the last sample, and a valid shape.
CarriedObject find_carried_object(const RobotModel& robot, const Plan& plan,
                                  const Trajectory& trajectory, const AttachedObject& attached,
                                  const std::vector<Mesh>& meshes);

/// Returns the pose of the carried object at a demonstration time after it was taken.
Pose carried_pose(const RobotModel& robot, const SceneObject& object,
                  const AttachedObject& attached, const JointVector& q, double time_s);

/// The least distances of a carried object from others at times at which they may not touch [m].
struct CarriedClearance {
  std::vector<double> at_samples;  ///< [samples] +infinity if there are no such objects
  ClearanceByKind along_curve = no_clearance();  ///< to 0.01 mm
};
/// Returns the distance of the target, as a body in the hand, from the named object [m]; NaN if one
/// of them does not exist.
double carried_distance(const RobotModel& robot, const Plan& plan, const std::vector<Mesh>& meshes,
                        const AttachedObject& attached, const std::string& other,
                        const JointVector& q, double time_s);

/// Records `object_collision` violations, with the subject "target/object", if the carried object
/// is closer to another one than required at a sample or along the curve; and `release` violations
/// if it stood on another object when it was taken, and is released in transport farther than
/// kMaxReleaseHeight_m from all others.
CarriedClearance verify_carried_object(const RobotModel& robot, const Plan& plan,
                                       const Curve& curve, const std::vector<Mesh>& meshes,
                                       const AttachedObject& attached, ViolationLog& violations);

}  // namespace morphe::verify
