#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::collision {

/// The target as an attached object. Before begin_s it has its recorded pose. From begin_s to end_s
/// it keeps its pose relative to a frame of the robot. Afterwards it remains where it was released.
struct AttachedTarget {
  int frame = -1;                               ///< robot frame, -1 if the target is not attached
  double begin_s = kUnknown, end_s = kUnknown;  ///< demonstration time; end NaN if never released
  Pose frame_from_object = Pose::Identity();
  Pose base_from_released = Pose::Identity();
  JointVector motion_bounds;  ///< [joints] like a row of Robot::capsule_motion_bounds
};

/// An object on which the target stands when it is taken, when it is released, or both.
struct SupportContact {
  int object = -1;
  double lifted_s = -kInfinity;  ///< contact is allowed up to this demonstration time …
  double lowered_s = kInfinity;  ///< … and again from this one on

  /// Returns true if contact is allowed at a demonstration time.
  bool is_allowed(double time_s) const { return time_s <= lifted_s || time_s >= lowered_s; }
};

/// The target as a body that the hand carries, attached to a frame or as it was recorded: from
/// begin_s on, also after its release, it is checked against every other object of the scene. It
/// must keep the required clearance from all of them, except from its supports:
///   - it stands on what is at most kSupportNoise_m away, or overlaps, when it is taken, until it
///   is
///     first clear of it;
///   - it is put down on what is at most kSupportNoise_m away, or overlaps, at its release, or at
///     the end of a path that ends before: from the last time at which it was clear of it.
/// Meanwhile it may overlap the support by kSupportNoise_m. Clear is a distance of kSupportNoise_m
/// or the required clearance, whichever is larger. `stages/verify` has the same rule
/// (carried_object.hpp).
struct CarriedTarget {
  double begin_s = kUnknown;  ///< demonstration time; NaN if the target is not carried
  std::vector<SupportContact> supports;
  /// Distance from the nearest object at the release, if the path reaches it and the target stood
  /// on an object when it was taken; else 0. Exact up to kMaxReleaseGap_m [m].
  double release_gap_m = 0;
};

}  // namespace morphe::collision
