#include "stages/import/audit/label_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "core/math/rigid.hpp"
#include "core/math/statistics.hpp"
#include "stages/import/audit/constants.hpp"

namespace morphe::imports {
namespace {

/// An assignment of tracks to columns, and how badly each cluster fits it.
struct Labelling {
  Permutation source;
  std::vector<ClusterMisfit> misfits;
};

double total_cost(const Labelling& labelling) {
  double cost_m = 0;
  for (const ClusterMisfit& misfit : labelling.misfits)
    cost_m += std::isnan(misfit.error_m) ? 0 : misfit.cost_m();
  return cost_m;
}

Labelling measured(const Array2D<Vec3>& frames, const LabelModel& model, Permutation source) {
  Labelling labelling{std::move(source), {}};
  for (const RigidCluster& cluster : model.clusters)
    labelling.misfits.push_back(cluster_misfit(frames, cluster, labelling.source));
  return labelling;
}

bool differs_in(const RigidCluster& cluster, const Permutation& a, const Permutation& b) {
  return std::ranges::any_of(cluster.columns, [&](std::size_t k) { return a[k] != b[k]; });
}

/// Returns the labelling with other columns, measuring only the clusters that change. A cluster
/// that is seen far less often than before gets an infinite error.
Labelling changed(const Array2D<Vec3>& frames, const LabelModel& model, const Labelling& before,
                  Permutation source) {
  Labelling after{std::move(source), before.misfits};
  for (std::size_t c = 0; c < model.clusters.size(); ++c) {
    if (!differs_in(model.clusters[c], before.source, after.source)) continue;
    after.misfits[c] = cluster_misfit(frames, model.clusters[c], after.source);
    if (2 * after.misfits[c].frames < std::max<std::size_t>(before.misfits[c].frames, 1))
      after.misfits[c] = {kInfinity, 0, 0};
  }
  return after;
}

double joint_mismatch(const Array2D<Vec3>& frames, const LabelModel& model,
                      const LandmarkJoint& joint, const Permutation& source) {
  const RigidCluster &first = model.clusters[joint.first], &second = model.clusters[joint.second];
  std::vector<double> distances;
  for (std::size_t i = 0; i < frames.rows; ++i) {
    const auto centre_by = [&](const RigidCluster& cluster) {
      return math::fit_rigid_transform(cluster.shape, cluster_points(frames, i, cluster, source)) *
             joint.in_static;
    };
    const double distance_m = (centre_by(first) - centre_by(second)).norm();
    if (std::isfinite(distance_m)) distances.push_back(distance_m);
  }
  return math::median(std::move(distances));
}

/// Returns the sum over the joints of the mismatch above its limit [m].
double joint_excess(const Array2D<Vec3>& frames, const LabelModel& model,
                    const Permutation& source) {
  double excess_m = 0;
  for (const LandmarkJoint& joint : model.joints) {
    const double mismatch_m = joint_mismatch(frames, model, joint, source);
    if (mismatch_m > kMaxJointMismatch_m) excess_m += mismatch_m - kMaxJointMismatch_m;
  }
  return excess_m;
}

std::vector<bool> doubted_clusters(const Array2D<Vec3>& frames, const LabelModel& model,
                                   const Labelling& labelling) {
  std::vector<bool> doubted(model.clusters.size());
  for (std::size_t c = 0; c < model.clusters.size(); ++c) {
    const RigidCluster& cluster = model.clusters[c];
    doubted[c] = labelling.misfits[c].error_m > kMaxMisfit_m ||
                 (cluster.shape.empty() &&
                  outlier_ratio(frames, cluster, labelling.source) > kMaxOutlierRatio);
  }
  for (const LandmarkJoint& joint : model.joints) {
    if (!(joint_mismatch(frames, model, joint, labelling.source) > kMaxJointMismatch_m)) continue;
    doubted[joint.first] = doubted[joint.second] = true;
  }
  return doubted;
}

/// Calls `visit` with all other orders of the markers of a cluster.
template <class Visit>
void for_each_order(const RigidCluster& cluster, const Permutation& source, const Visit& visit) {
  const std::vector<std::size_t>& columns = cluster.columns;
  if (columns.size() > kMaxPermutedMarkers || cluster.shape.empty()) return;
  Permutation order = identity_permutation(columns.size());
  while (std::ranges::next_permutation(order).found) {
    Permutation other = source;
    for (std::size_t k = 0; k < columns.size(); ++k) other[columns[k]] = source[columns[order[k]]];
    visit(std::move(other));
  }
}

/// Calls `visit` with all exchanges of a marker of a cluster with another point; without a shape,
/// which alone tells them apart, not with landmarks.
template <class Visit>
void for_each_exchange(const LabelModel& model, const RigidCluster& cluster,
                       const Permutation& source, const Visit& visit) {
  for (const std::size_t a : cluster.columns) {
    for (std::size_t b = 0; b < source.size(); ++b) {
      if (b == a || (cluster.shape.empty() && model.is_landmark[b])) continue;
      Permutation other = source;
      std::swap(other[a], other[b]);
      visit(std::move(other));
    }
  }
}

std::vector<Permutation> changes_of(const Array2D<Vec3>& frames, const LabelModel& model,
                                    const Labelling& before) {
  std::vector<Permutation> changes;
  const std::vector<bool> doubted = doubted_clusters(frames, model, before);
  const auto add = [&](Permutation source) { changes.push_back(std::move(source)); };
  for (std::size_t c = 0; c < model.clusters.size(); ++c) {
    if (!doubted[c]) continue;
    for_each_order(model.clusters[c], before.source, add);
    for_each_exchange(model, model.clusters[c], before.source, add);
  }
  return changes;
}

/// Returns the changes that fit best, measured on all frames after a choice on a few of them.
std::vector<Labelling> best_changes(const Array2D<Vec3>& frames, const LabelModel& model,
                                    const Labelling& before) {
  std::vector<Permutation> changes = changes_of(frames, model, before);
  if (changes.empty()) return {};
  const Array2D<Vec3> few = sample_frames(frames, 0, frames.rows, kFewFrames);
  const Labelling before_in_few = measured(few, model, before.source);
  std::vector<std::pair<double, std::size_t>> costs;
  for (std::size_t k = 0; k < changes.size(); ++k)
    costs.emplace_back(total_cost(changed(few, model, before_in_few, changes[k])), k);
  std::ranges::sort(costs);
  costs.resize(std::min(costs.size(), kComparedChanges));
  std::vector<Labelling> best;
  for (const auto& [cost_m, k] : costs)
    best.push_back(changed(frames, model, before, std::move(changes[k])));
  return best;
}

/// Returns the misfit of all clusters and joints [m].
double full_cost(const Array2D<Vec3>& frames, const LabelModel& model, const Labelling& labelling) {
  return total_cost(labelling) + kJointWeight * joint_excess(frames, model, labelling.source);
}

/// Keeps the cheapest of the labellings, by misfit and joints, the cheapest first.
void keep_cheapest(const Array2D<Vec3>& frames, const LabelModel& model,
                   std::vector<Labelling>& labellings) {
  double least_m = kInfinity;
  for (const Labelling& labelling : labellings) least_m = std::min(least_m, total_cost(labelling));
  std::vector<std::pair<double, std::size_t>> costs;
  for (std::size_t k = 0; k < labellings.size(); ++k) {
    const double misfit_m = total_cost(labellings[k]);
    if (!std::isfinite(misfit_m)) continue;
    const bool comparable = misfit_m <= least_m + kAlternativeMisfit_m;
    costs.emplace_back(comparable ? full_cost(frames, model, labellings[k]) : misfit_m + kFarCost_m,
                       k);
  }
  std::ranges::sort(costs);
  costs.resize(std::min(costs.size(), kPursuedLabellings));
  std::vector<Labelling> kept;
  for (const auto& [cost_m, k] : costs) kept.push_back(std::move(labellings[k]));
  labellings = std::move(kept);
}

/// Gives the names outside of the clusters their own columns back, if no cluster has taken them,
/// otherwise the column that is left at the end of the chain.
Permutation with_fewest_moves(const LabelModel& model, const Permutation& source) {
  constexpr std::size_t kFree = static_cast<std::size_t>(-1);
  std::vector<std::size_t> taken_by(source.size(), kFree);
  for (const RigidCluster& cluster : model.clusters) {
    for (const std::size_t name : cluster.columns) taken_by[source[name]] = name;
  }
  Permutation moved = source;
  std::vector<bool> in_cluster(source.size());
  for (const RigidCluster& cluster : model.clusters) {
    for (const std::size_t name : cluster.columns) in_cluster[name] = true;
  }
  for (std::size_t name = 0; name < source.size(); ++name) {
    if (in_cluster[name]) continue;
    std::size_t column = name;
    while (taken_by[column] != kFree) column = taken_by[column];
    moved[name] = column;
  }
  return moved;
}

/// Returns true if the clusters that have changed fit, and much better than before.
bool convinces(const Array2D<Vec3>& frames, const LabelModel& model, const Labelling& before,
               const Labelling& after) {
  bool by_distances = false;
  bool better =
      joint_excess(frames, model, before.source) - joint_excess(frames, model, after.source) >
      kMinJointGain_m;
  for (std::size_t c = 0; c < model.clusters.size(); ++c) {
    if (!differs_in(model.clusters[c], before.source, after.source)) continue;
    const bool has_shape = !model.clusters[c].shape.empty();
    const double was_m = before.misfits[c].error_m, is_m = after.misfits[c].error_m;
    if (is_m > (has_shape ? kMaxMisfit_m : kMaxSpread_m)) return false;
    if (!has_shape && (is_m > was_m + kSameCost_m ||
                       outlier_ratio(frames, model.clusters[c], after.source) > kMaxOutlierRatio))
      return false;
    by_distances = by_distances || !has_shape;
    better = better || (has_shape && is_m < kMaxMisfitRatio * was_m);
  }
  return better || (by_distances && total_cost(before) - total_cost(after) > kMinSpreadGain_m);
}

}  // namespace

double label_cost(const Array2D<Vec3>& frames, const LabelModel& model, const Permutation& source) {
  return total_cost(measured(frames, model, source));
}

Permutation find_relabelling(const Array2D<Vec3>& frames, const LabelModel& model) {
  const Labelling recorded = measured(frames, model, identity_permutation(frames.cols));
  if (std::ranges::none_of(doubted_clusters(frames, model, recorded), std::identity()))
    return recorded.source;
  Labelling best = recorded;
  double best_cost_m = full_cost(frames, model, best);
  std::vector<Labelling> pursued = {recorded};
  for (int change = 0; change < kMaxLabelChanges; ++change) {
    std::vector<Labelling> changes;
    for (const Labelling& labelling : pursued) {
      std::vector<Labelling> more = best_changes(frames, model, labelling);
      std::ranges::move(more, std::back_inserter(changes));
    }
    keep_cheapest(frames, model, changes);
    if (changes.empty()) break;
    const double cost_m = full_cost(frames, model, changes.front());
    if (!(cost_m < best_cost_m - kSameCost_m)) break;
    best = changes.front();
    best_cost_m = cost_m;
    pursued = std::move(changes);
  }
  return convinces(frames, model, recorded, best) ? with_fewest_moves(model, best.source)
                                                  : recorded.source;
}

}  // namespace morphe::imports
