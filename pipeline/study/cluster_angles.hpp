#pragma once

#include <vector>

#include "core/motion/demonstration.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::study {

/// The angles of the ue-adl database by its own definition: rotations R of the marker clusters
/// since the static trial, taken apart one after the other (found by trying all sequences and
/// frames; its files are met to 0.1-1.6 degrees RMS):
///   R_shoulder_girdle^T R_upper_arm   = Rz(horizontal) Rx(flexion) Ry(rotation)   in the world's
///   axes E^T R_upper_arm^T R_forearm E = Rx(elbow) Rz(.) Ry(pronation)
/// with E the elbow's axes in the static trial, where the arm is stretched forward: x from RMEP to
/// RLEP, y forward. [frame] on the clock of reconstruct(), rad; NaN where a cluster is not seen.
struct ClusterAngles {
  std::vector<double> horizontal, flexion, rotation, elbow, pronation;
};

/// Empty unless recording and static trial show the clusters RSHO, RUAR, RLAR and the epicondyles
/// (of a left hand: their mirror images).
ClusterAngles cluster_angles(const Demonstration& demonstration,
                             const reconstruct::ReconstructOptions& options);

}  // namespace morphe::study
