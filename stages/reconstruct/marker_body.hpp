#pragma once

#include <string>
#include <vector>

#include "stages/reconstruct/static_trial.hpp"
#include "stages/reconstruct/time_grid.hpp"

namespace morphe::reconstruct {

/// A marker recording with the data needed for its reconstruction.
struct MarkerTrial {
  const MarkerStream& markers;        ///< the recording
  StaticTrial static_trial;           ///< may be unavailable
  TimeGrid clock;                     ///< clock of the reconstructed motion
  const ReconstructOptions& options;  ///< options of the reconstruction
};

/// Returns the recorded positions of one marker, [frame]; always unseen if there is no such marker.
std::vector<Vec3> marker_track(const MarkerStream& markers, const std::string& name);

/// A segment of the body, tracked by its marker cluster. Its frame is the static trial's world or,
/// without a static trial, that of its median shape.
struct MarkerBody {
  std::string name;  ///< prefix of the cluster: RUAR for RUAR1, RUAR2, …
  /// True if the static trial shows the cluster.
  bool in_static = false;
  std::vector<Vec3> shape;  ///< positions of its markers; empty if the body does not exist
  std::vector<std::vector<Vec3>> tracks;  ///< as recorded, with gaps filled from the other markers
  std::vector<Pose> world_from_body;      ///< on the clock, low-passed; NaN if not seen

  /// Returns true if the recording has the body.
  bool exists() const { return !shape.empty(); }
};

/// Creates the body of a cluster of three or more markers. Gaps, a poor fit and (if it is `needed`)
/// a missing cluster are reported in `motion.reconstruction_notes`, the rigidity of the cluster in
/// `motion.residuals`.
MarkerBody make_marker_body(MarkerTrial& trial, const std::string& cluster, bool needed,
                            HumanMotion& motion);

/// A landmark on a bone.
struct Landmark {
  std::string name;
  std::vector<Vec3> recorded;  ///< [frame]
  std::vector<Vec3> track;     ///< on the clock; empty unless seen in half of the recording
};

/// Creates a landmark from the recording, with its gaps filled by the body that it belongs to.
Landmark make_landmark(MarkerTrial& trial, const std::string& name, const MarkerBody& body,
                       HumanMotion& motion);

/// Returns the position of a landmark in a body's frame: from the static trial if it shows the
/// landmark, otherwise the median of the recording; unseen if neither is available.
Vec3 landmark_in_body(MarkerTrial& trial, const Landmark& landmark, const MarkerBody& body,
                      HumanMotion& motion);

}  // namespace morphe::reconstruct
