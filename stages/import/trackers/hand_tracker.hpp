#pragma once

#include <string>
#include <vector>

#include "stages/import/recording/format.hpp"
#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {

/// Of a tracker's file: how its axes and its unit become the world's.
struct TrackerFrame {
  Eigen::Matrix3d world_from_file = Eigen::Matrix3d::Identity();
  double metres = 1;  ///< in one unit of the file

  Vec3 point(const Vec3& in_file) const { return world_from_file * (metres * in_file); }
  Quat turn(const Quat& in_file) const { return (Quat(world_from_file) * in_file).normalized(); }
  Pose pose(const Pose& in_file) const;
};

/// `axes` and `unit` are those of the format; what was given comes before, and is reported.
/// `because` says in `reports` how the axes are known ("" = they do not matter).
/// InputError for a static trial and for names, which a tracker's file has no use for.
TrackerFrame tracker_frame(const RecordingFiles& files, const std::string& axes,
                           const std::string& unit, const std::string& because,
                           std::vector<std::string>& reports);

/// No joint seen in any of `rows` frames.
RecordedHand unseen_hand(std::size_t rows);

/// Time that runs on; InputError "FILE:LINE: KEY: does not follow the row before" if it does not.
void add_time(double time_s, const std::string& file, std::size_t line, const std::string& key,
              std::vector<double>& time);

/// Judges a clip (hand_checks.hpp) and puts it into the demonstration. InputError if it has neither
/// a hand nor a wrist.
void add_tracked(HandClip&& clip, const RecordingFiles& files, Demonstration& demonstration);

/// The same of a clip whose hands have no place in the world: only the shape of one is taken, of
/// the hand that was asked for or else of the other. Objects and body are left out.
void add_shape(HandClip&& clip, const RecordingFiles& files, const std::string& why,
               Demonstration& demonstration);

/// A body of which only the pose was recorded: a ball around its origin, which is reported.
SceneObject ball_for(const std::string& name, std::vector<std::string>& reports);

}  // namespace morphe::imports
