#include "stages/reconstruct/marker_body.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "stages/reconstruct/gaps.hpp"
#include "stages/reconstruct/residual_sum.hpp"

namespace morphe::reconstruct {
namespace {

constexpr std::size_t kMinClusterMarkers = 3;

/// Returns the markers of the recording whose names are the cluster's and a number.
std::vector<std::string> members_of(const MarkerStream& markers, const std::string& cluster) {
  std::vector<std::string> members;
  for (const std::string& name : markers.names) {
    const bool numbered = name.size() > cluster.size() && name.starts_with(cluster) &&
                          name.find_first_not_of("0123456789", cluster.size()) == name.npos;
    if (numbered && !never_seen(marker_track(markers, name))) members.push_back(name);
  }
  return members;
}

void measure_fit(const MarkerBody& body, const ClusterTracks& tracks, HumanMotion& motion) {
  ResidualSum misfit;
  for (int i = 0; i < std::ssize(body.world_from_body); ++i) {
    std::vector<Vec3> markers;
    for (const auto& track : tracks) markers.push_back(track[i]);
    misfit.add(math::rigid_residual(body.world_from_body[i], body.shape, markers));
  }
  // The trials' own static poses fit to 0.2-1.1 mm, another subject's forearm plate to 9 mm.
  constexpr double kMaxRigidFitRms_m = 0.004;
  const Residual fit = misfit.residual(fmt::format("{} rigid fit", body.name));
  motion.residuals.push_back(fit);
  if (fit.rms_m > kMaxRigidFitRms_m) {
    const char* defect = body.in_static ? "does not fit the static trial" : "is not rigid";
    motion.reconstruction_notes.push_back(fmt::format(
        "cluster {} {} (RMS {:.1f} mm): markers moved{}", body.name, defect, 1000 * fit.rms_m,
        body.in_static ? ", or it is another person's trial" : " on the skin"));
  }
}

}  // namespace

StaticTrial::StaticTrial(const std::optional<MarkerStream>& trial) : given_(trial.has_value()) {
  for (std::size_t k = 0; given_ && k < trial->names.size(); ++k) {
    Eigen::AlignedBox3d box;
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (std::size_t i = 0; i < trial->position.rows; ++i) {
      const Vec3& point = trial->position(i, k);
      if (!is_known(point)) continue;
      sum += point;
      box.extend(point);
      ++count;
    }
    if (count > 0) markers_[trial->names[k]] = {sum / count, box.diagonal().norm()};
  }
}

Vec3 StaticTrial::mean(const std::string& marker, std::vector<std::string>& problems) {
  constexpr double kMaxMarkerMotion_m = 0.010;  // in quiet trials 1 to 5 mm, breathing and drift
  const auto found = markers_.find(marker);
  if (found == markers_.end()) return unknown_point();
  double& moved_m = found->second.moved_m;
  if (moved_m > kMaxMarkerMotion_m) {
    problems.push_back(fmt::format("static trial: {} moves by {:.1f} mm", marker, 1000 * moved_m));
    moved_m = 0;  // reported once
  }
  return found->second.mean;
}

std::vector<Vec3> marker_track(const MarkerStream& markers, const std::string& name) {
  std::vector<Vec3> track(markers.time.size(), unknown_point());
  const auto k = std::ranges::find(markers.names, name) - markers.names.begin();
  if (k == std::ssize(markers.names)) return track;
  for (int i = 0; i < std::ssize(track); ++i) track[i] = markers.position(i, k);
  return track;
}

MarkerBody make_marker_body(MarkerTrial& trial, const std::string& cluster, bool needed,
                            HumanMotion& motion) {
  MarkerBody body;
  body.name = cluster;
  const MarkerStream& markers = trial.markers;
  std::vector<std::string>& notes = motion.reconstruction_notes;
  std::vector<std::string> members = members_of(markers, cluster), in_static, missing;
  std::vector<Vec3> static_shape;
  for (const std::string& name : members) {
    const Vec3 position = trial.static_trial.mean(name, notes);
    (is_known(position) ? in_static : missing).push_back(name);
    if (is_known(position)) static_shape.push_back(position);
  }
  body.in_static = in_static.size() >= kMinClusterMarkers;
  if (body.in_static) {
    for (const auto& name : missing) notes.push_back("static trial: " + name + " is missing");
    members = in_static;
  } else if (trial.static_trial.available() && members.size() >= kMinClusterMarkers) {
    notes.push_back(fmt::format(
        "static trial: fewer than three markers of {}: it does not give the joint centres",
        cluster));
  }
  if (members.size() < kMinClusterMarkers) {
    if (needed) {
      notes.push_back(fmt::format("cluster {}: only {} of its markers were seen; three are needed",
                                  cluster, members.size()));
    }
    return body;
  }
  for (const std::string& name : members) body.tracks.push_back(marker_track(markers, name));
  body.shape = body.in_static ? static_shape : median_shape(body.tracks);
  if (!std::ranges::all_of(body.shape, [](const Vec3& p) { return is_known(p); })) {
    notes.push_back(
        fmt::format("cluster {}: no three of its markers are ever seen together", cluster));
    body.shape.clear();
    return body;
  }
  fill_cluster_gaps(body.shape, body.tracks);
  ClusterTracks smooth;
  for (int k = 0; k < std::ssize(members); ++k) {
    note_gaps(members[k], markers.time, marker_track(markers, members[k]), body.tracks[k],
              trial.options.max_gap_s, notes);
    smooth.push_back(resample(markers.time, body.tracks[k], trial.clock, trial.options));
  }
  body.world_from_body = fit_poses(body.shape, smooth);
  measure_fit(body, smooth, motion);
  return body;
}

Landmark make_landmark(MarkerTrial& trial, const std::string& name, const MarkerBody& body,
                       HumanMotion& motion) {
  Landmark landmark{name, marker_track(trial.markers, name), {}};
  const auto shown = std::ranges::count_if(landmark.recorded, [](auto& p) { return is_known(p); });
  if (2 * shown < std::ssize(landmark.recorded)) return landmark;
  std::vector<Vec3> filled = landmark.recorded;
  if (body.exists()) {
    std::vector<Vec3> shape = body.shape;
    ClusterTracks tracks = body.tracks;
    shape.push_back(median_in_body(fit_poses(body.shape, body.tracks), landmark.recorded));
    tracks.push_back(landmark.recorded);
    fill_marker_gaps(shape, tracks, shape.size() - 1);
    filled = tracks.back();
  }
  const MarkerStream& markers = trial.markers;
  note_gaps(name, markers.time, landmark.recorded, filled, trial.options.max_gap_s,
            motion.reconstruction_notes);
  landmark.track = resample(markers.time, filled, trial.clock, trial.options);
  return landmark;
}

Vec3 landmark_in_body(MarkerTrial& trial, const Landmark& landmark, const MarkerBody& body,
                      HumanMotion& motion) {
  if (!body.exists()) return unknown_point();
  const Vec3 static_position = trial.static_trial.mean(landmark.name, motion.reconstruction_notes);
  if (body.in_static && is_known(static_position)) return static_position;
  if (never_seen(landmark.recorded)) return unknown_point();
  return median_in_body(fit_poses(body.shape, body.tracks), landmark.recorded);
}

}  // namespace morphe::reconstruct
