#pragma once

#include <vector>

#include "stages/import/audit/label_clusters.hpp"

namespace morphe::imports {

/// A joint whose centre the static trial shows, between two clusters that have a shape.
struct LandmarkJoint {
  std::size_t first = 0, second = 0;  ///< its clusters
  Vec3 in_static;                     ///< its centre in the static trial's world [m]
};

/// The parts of the body that tell which point is which.
struct LabelModel {
  std::vector<RigidCluster> clusters;
  std::vector<LandmarkJoint> joints;  ///< elbows and wrists
  std::vector<bool> is_landmark;      ///< [column] a point near a cluster, but not of it
};

/// Returns the clusters and joints that a recording and its static trial show.
LabelModel label_model(const MarkerStream& markers,
                       const std::optional<MarkerStream>& static_trial);

/// Returns the sum of the costs of all clusters [m], without those that cannot be judged.
double label_cost(const Array2D<Vec3>& frames, const LabelModel& model, const Permutation& source);

/// Returns the columns in which the tracks fit the model, or the recorded ones if these do, or if
/// no others do clearly. A cluster is doubted if its markers do not keep the places of the static
/// trial (misfit above 4 mm), if they put a joint elsewhere than its neighbour does (by 60 mm), or,
/// without a static trial, if they do not keep their distances or one of them is far from the
/// others. Repeatedly makes the one change that fits best: any order of a doubted cluster, or an
/// exchange of one of its markers with any other point. Orders that fit alike, as those of a
/// rectangle do, are compared by the joints. Afterwards all changed clusters have to fit.
Permutation find_relabelling(const Array2D<Vec3>& frames, const LabelModel& model);

}  // namespace morphe::imports
