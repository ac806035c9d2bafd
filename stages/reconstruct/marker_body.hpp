#pragma once

#include <string>
#include <vector>

#include "stages/reconstruct/clock.hpp"
#include "stages/reconstruct/static_trial.hpp"

namespace morphe::reconstruct {

/// A marker recording and what it is rebuilt with.
struct MarkerTrial {
  const MarkerStream& markers;
  StaticTrial still;
  Clock clock;
  const ReconstructOptions& options;
};

/// What was recorded of one marker, [frame]; unseen throughout if there is no such marker.
std::vector<Vec3> track_of(const MarkerStream& markers, const std::string& name);

/// A segment of the body as its marker cluster shows it. Its own frame is the static trial's world,
/// or, without one, where its median shape stands.
struct MarkerBody {
  std::string name;  ///< of the cluster: RUAR for RUAR1, RUAR2, …
  bool in_static = false;
  std::vector<Vec3> shape;                ///< of its markers; empty = there is no such body
  std::vector<std::vector<Vec3>> tracks;  ///< as recorded, gaps filled by the others
  std::vector<Pose> world_from_body;      ///< on the clock, low-passed; NaN = not seen

  bool exists() const { return !shape.empty(); }
};

/// The body of a cluster of three or more markers. Gaps, a shape that does not fit and (if it is
/// `needed`) a cluster that is not there are said in `motion.problems`, how rigid it is in
/// `motion.residuals`.
MarkerBody body_of(MarkerTrial& trial, const std::string& cluster, bool needed,
                   HumanMotion& motion);

/// A landmark on the bone.
struct Landmark {
  std::string name;
  std::vector<Vec3> recorded;  ///< [frame]
  std::vector<Vec3> track;     ///< on the clock; empty unless half of the recording shows it
};

/// A landmark as the recording shows it, its gaps filled by the body that it lies on.
Landmark landmark_of(MarkerTrial& trial, const std::string& name, const MarkerBody& body,
                     HumanMotion& motion);

/// Where a landmark lies in a body's frame: by the static trial if there is one that shows it, else
/// the median of the recording; unseen if neither tells.
Vec3 landmark_in_body(MarkerTrial& trial, const Landmark& landmark, const MarkerBody& body,
                      HumanMotion& motion);

}  // namespace morphe::reconstruct
