#include "stages/reconstruct/marker_body.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "stages/reconstruct/cluster.hpp"
#include "stages/reconstruct/gaps.hpp"

namespace morphe::reconstruct {
namespace {

constexpr std::size_t kMinClusterMarkers = 3;  ///< least number of markers of a cluster

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

/// Measures the rigid fit of a body to its tracks.
void measure_fit(const MarkerBody& body, const std::vector<std::vector<Vec3>>& tracks,
                 HumanMotion& motion) {
  std::vector<double> misfit;
  for (std::size_t i = 0; i < body.world_from_body.size(); ++i) {
    std::vector<Vec3> now;
    for (const auto& track : tracks) now.push_back(track[i]);
    misfit.push_back(math::rigid_residual(body.world_from_body[i], body.shape, now));
  }
  // The trials' own static poses fit to 0.2-1.1 mm; a forearm plate of another subject is off by 9
  // mm.
  constexpr double kMaxRigidFitRms_m = 0.004;
  const Residual fit = residual_of(fmt::format("{} rigid fit", body.name), misfit);
  motion.residuals.push_back(fit);
  if (fit.rms_m > kMaxRigidFitRms_m) {
    const char* why = body.in_static ? "does not fit the static trial" : "is not rigid";
    motion.reconstruction_notes.push_back(fmt::format(
        "cluster {} {} (RMS {:.1f} mm): markers moved{}", body.name, why, 1000 * fit.rms_m,
        body.in_static ? ", or it is another person's trial" : " on the skin"));
  }
}

}  // namespace

std::vector<Vec3> marker_track(const MarkerStream& markers, const std::string& name) {
  std::vector<Vec3> track(markers.time.size(), unknown_point());
  const auto found = std::ranges::find(markers.names, name);
  if (found == markers.names.end()) return track;
  const auto k = static_cast<std::size_t>(found - markers.names.begin());
  for (std::size_t i = 0; i < track.size(); ++i) track[i] = markers.position(i, k);
  return track;
}

MarkerBody make_marker_body(MarkerTrial& trial, const std::string& cluster, bool needed,
                            HumanMotion& motion) {
  MarkerBody body;
  body.name = cluster;
  const MarkerStream& markers = trial.markers;
  std::vector<std::string> members = members_of(markers, cluster);
  std::vector<std::string> in_static;
  std::vector<Vec3> still;
  for (const std::string& name : members) {
    const Vec3 place = trial.static_trial.at(name, motion.reconstruction_notes);
    if (!is_known(place)) continue;
    in_static.push_back(name);
    still.push_back(place);
  }
  body.in_static = in_static.size() >= kMinClusterMarkers;
  if (body.in_static) {
    for (const std::string& name : members) {
      if (!std::ranges::count(in_static, name)) {
        motion.reconstruction_notes.push_back(fmt::format("static trial: {} is missing", name));
      }
    }
    members = in_static;
  } else if (trial.static_trial.available() && members.size() >= kMinClusterMarkers) {
    motion.reconstruction_notes.push_back(fmt::format(
        "static trial: fewer than three markers of {}: it does not give the joint centres",
        cluster));
  }
  if (members.size() < kMinClusterMarkers) {
    if (needed) {
      motion.reconstruction_notes.push_back(
          fmt::format("cluster {}: only {} of its markers were seen; three are needed", cluster,
                      members.size()));
    }
    return body;
  }
  for (const std::string& name : members) body.tracks.push_back(marker_track(markers, name));
  body.shape = body.in_static ? still : median_shape(body.tracks);
  if (!std::ranges::all_of(body.shape, [](const Vec3& p) { return is_known(p); })) {
    motion.reconstruction_notes.push_back(
        fmt::format("cluster {}: no three of its markers are ever seen together", cluster));
    body.shape.clear();
    return body;
  }
  fill_cluster_gaps(body.shape, body.tracks);
  std::vector<std::vector<Vec3>> smooth;
  for (std::size_t k = 0; k < members.size(); ++k) {
    note_gaps(members[k], markers.time, marker_track(markers, members[k]), body.tracks[k],
              trial.options.max_gap_s, motion.reconstruction_notes);
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
  if (2 * static_cast<std::size_t>(shown) < landmark.recorded.size()) return landmark;
  std::vector<Vec3> filled = landmark.recorded;
  if (body.exists()) {
    std::vector<Vec3> shape = body.shape;
    std::vector<std::vector<Vec3>> tracks = body.tracks;
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
  const Vec3 still = trial.static_trial.at(landmark.name, motion.reconstruction_notes);
  if (body.in_static && is_known(still)) return still;
  if (never_seen(landmark.recorded)) return unknown_point();
  return median_in_body(fit_poses(body.shape, body.tracks), landmark.recorded);
}

}  // namespace morphe::reconstruct
