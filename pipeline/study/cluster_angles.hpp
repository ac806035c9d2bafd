#pragma once

#include <vector>

#include "core/motion/demonstration.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::study {

/// The angles of the ue-adl database by its own definition: the rotations R of the marker clusters
/// since the static trial, decomposed into successive rotations. The sequences and frames were
/// found by trying all possible ones; the angles of the files are reproduced to 0.1-1.6 degrees
/// rms:
///   R_shoulder_girdle^T R_upper_arm   = Rz(horizontal) Rx(flexion) Ry(rotation)   in world axes
///   E^T R_upper_arm^T R_forearm E = Rx(elbow) Rz(.) Ry(pronation)
/// E contains the axes of the elbow in the static trial, in which the arm is stretched forward: x
/// points from RMEP to RLEP, y forward. The angles are given for each [frame] of the clock of
/// reconstruct() in rad, NaN if a cluster is not seen.
struct ClusterAngles {
  std::vector<double> horizontal, flexion, rotation, elbow, pronation;
};

/// Computes the cluster angles; empty unless recording and static trial contain the clusters RSHO,
/// RUAR, RLAR and the epicondyles (for a left hand, their mirror images).
ClusterAngles cluster_angles(const Demonstration& demonstration,
                             const reconstruct::ReconstructOptions& options);

}  // namespace morphe::study
