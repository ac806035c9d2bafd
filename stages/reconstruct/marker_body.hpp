#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "stages/reconstruct/cluster.hpp"
#include "stages/reconstruct/time_grid.hpp"

namespace morphe::reconstruct {

/// The mean positions of the markers in a static trial.
class StaticTrial {
 public:
  /// Computes the mean positions of a trial, if there is one.
  explicit StaticTrial(const std::optional<MarkerStream>& trial);
  /// Returns true if there is a static trial.
  bool available() const { return given_; }
  /// Returns the mean position of a marker, or an unseen point if the trial does not show it. If it
  /// moved by more than 10 mm, the first call adds a sentence to `problems`.
  Vec3 mean(const std::string& marker, std::vector<std::string>& problems);

 private:
  struct Marker {
    Vec3 mean;
    double moved_m = 0;  ///< diagonal of the box of its positions; 0 once reported
  };
  bool given_ = false;
  std::map<std::string, Marker> markers_;
};

/// A marker recording with the data needed for its reconstruction.
struct MarkerTrial {
  const MarkerStream& markers;
  StaticTrial static_trial;  ///< may be unavailable
  TimeGrid clock;            ///< clock of the reconstructed motion
  const ReconstructOptions& options;
};

/// Returns the recorded positions of one marker, [frame]; always unseen if there is no such marker.
std::vector<Vec3> marker_track(const MarkerStream& markers, const std::string& name);

/// A segment of the body, tracked by its marker cluster. Its frame is the static trial's world if
/// `in_static`, otherwise the world of the frame from which its median shape began.
struct MarkerBody {
  std::string name;                   ///< prefix of the cluster: RUAR for RUAR1, RUAR2, …
  bool in_static = false;             ///< true if the static trial shows the cluster
  std::vector<Vec3> shape;            ///< positions of its markers; empty without such a body
  ClusterTracks tracks;               ///< at recorded times, gaps filled from the other markers
  std::vector<Pose> world_from_body;  ///< on the clock, low-passed; NaN if not seen
  bool exists() const { return !shape.empty(); }  ///< true if the recording has the body
};

/// Creates the body of a cluster of three or more markers; without these it does not exist(). Gaps,
/// a poor fit and, if it is `needed`, a missing cluster are noted in `motion`. The RMS error of the
/// rigid fit is added to `motion.residuals`.
MarkerBody make_marker_body(MarkerTrial& trial, const std::string& cluster, bool needed,
                            HumanMotion& motion);

/// A landmark on a bone.
struct Landmark {
  std::string name;
  std::vector<Vec3> recorded;  ///< [frame]
  std::vector<Vec3> track;     ///< on the clock; empty unless seen in half of the recording
};

/// Creates a landmark from the recording; the motion of the body that it belongs to fills its gaps.
Landmark make_landmark(MarkerTrial& trial, const std::string& name, const MarkerBody& body,
                       HumanMotion& motion);

/// Returns the position of a landmark in a body's frame: from the static trial if it shows the
/// landmark, otherwise the median of the recording; unseen if neither is available.
Vec3 landmark_in_body(MarkerTrial& trial, const Landmark& landmark, const MarkerBody& body,
                      HumanMotion& motion);

}  // namespace morphe::reconstruct
