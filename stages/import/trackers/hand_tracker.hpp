#pragma once

#include <string>
#include <vector>

#include "stages/import/recording/format.hpp"
#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {

/// The conversion of a tracker's axes and unit to the world's.
struct TrackerFrame {
  Eigen::Matrix3d world_from_file = Eigen::Matrix3d::Identity();  ///< rotation of the axes
  double unit_m = 1;  ///< metres in one unit of the file

  /// Converts a point.
  Vec3 point(const Vec3& in_file) const { return world_from_file * (unit_m * in_file); }
  /// Converts an orientation.
  Quat rotation(const Quat& in_file) const {
    return (Quat(world_from_file) * in_file).normalized();
  }
  /// Converts a pose.
  Pose pose(const Pose& in_file) const;
};

/// Creates the conversion. `axes` and `unit` are those of the format; given conventions take
/// precedence, and are reported. `because` is the reason for the axes in `reports` ("" if the axes
/// are irrelevant). Throws InputError for a static trial and for names, which are unused in a
/// tracker's file.
TrackerFrame tracker_frame(const RecordingFiles& files, const std::string& axes,
                           const std::string& unit, const std::string& because,
                           std::vector<std::string>& reports);

/// Returns a hand with all joints unseen in `rows` frames.
RecordedHand unseen_hand(std::size_t rows);

/// Appends a time. Throws InputError "FILE:LINE: KEY: must be greater than in the previous row" if
/// it does not increase.
void add_time(double time_s, const std::string& file, std::size_t line, const std::string& key,
              std::vector<double>& time);

/// Checks a clip (hand_checks.hpp) and adds it to the demonstration. Throws InputError if it has
/// neither a hand nor a wrist.
void add_tracked_clip(HandClip&& clip, const RecordingFiles& files, Demonstration& demonstration);

/// Does the same for a clip whose hands have no position in the world: only the shape of one hand
/// is used, the requested one or otherwise the other. Objects and body are left out.
void add_shape(HandClip&& clip, const RecordingFiles& files, const std::string& why,
               Demonstration& demonstration);

/// Returns a placeholder for an object of which only the pose was recorded: a sphere around its
/// origin, which is reported.
SceneObject placeholder_sphere(const std::string& name, std::vector<std::string>& reports);

}  // namespace morphe::imports
