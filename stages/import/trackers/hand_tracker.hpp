#pragma once

#include <string>
#include <vector>

#include "stages/import/recording/format.hpp"
#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {

/// The conversion from a tracker's axes and unit to the world's.
struct TrackerFrame {
  Eigen::Matrix3d world_from_file = Eigen::Matrix3d::Identity();
  double unit_m = 1;  ///< metres in one unit of the file

  /// Converts a point.
  Vec3 point(const Vec3& in_file) const { return world_from_file * (unit_m * in_file); }
  /// Converts an orientation.
  Quat rotation(const Quat& in_file) const {
    return (Quat(world_from_file) * in_file).normalized();
  }
  Pose pose(const Pose& in_file) const;  ///< converts both
};

/// Creates the conversion. `axes` and `unit` are those of the format; the user's conventions take
/// precedence. If the format's axes are used, they are reported with `axes_reason`, unless that is
/// "". Throws InputError for a static trial and a name map, which these formats do not use.
TrackerFrame tracker_frame(const RecordingFiles& files, const std::string& axes,
                           const std::string& unit, const std::string& axes_reason,
                           std::vector<std::string>& reports);

/// Returns a hand with all joints unseen in `rows` frames.
RecordedHand unseen_hand(std::size_t rows);

/// Appends a time. Throws InputError "FILE:LINE: KEY: …" if it is not greater than the last one.
void add_time(double time_s, const std::string& file, std::size_t line, const std::string& key,
              std::vector<double>& time);

/// Hides points that mean an unseen hand (unseen_hands.hpp), drops hands never seen, checks the
/// clip and adds it. Throws InputError without hand and body.
void add_tracked_clip(HandClip&& clip, const RecordingFiles& files, Demonstration& demonstration);

/// Checks a clip whose hands have no position in the world, and adds the keypoints of the requested
/// hand, or of the other one if only that was seen. Objects and body are left out. The notes name
/// `why`, the reason why the position is unknown. Throws InputError if no hand was seen.
void add_shape(HandClip&& clip, const RecordingFiles& files, const std::string& why,
               Demonstration& demonstration);

/// Returns a sphere around the origin of an object without a recorded shape, and reports it.
SceneObject placeholder_sphere(const std::string& name, std::vector<std::string>& reports);

}  // namespace morphe::imports
