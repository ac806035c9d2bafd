#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/statistics.hpp"
#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/marker_clusters.hpp"

namespace morphe::imports {
namespace {

Doubt of_another(std::string subject, double value, double limit, const char* unit,
                 std::string text) {
  return {.flag = {.code = FlagCode::static_trial,
                   .subject = std::move(subject),
                   .value = value,
                   .limit = limit,
                   .unit = unit,
                   .text = std::move(text)}};
}

std::vector<Vec3> marker_track(const Demonstration& recording, const std::string& name) {
  const MarkerStream& markers = *recording.streams.markers;
  const auto column = std::ranges::find(markers.names, name) - markers.names.begin();
  std::vector<Vec3> track(markers.time.size(), unknown_point());
  for (std::size_t i = 0; column < std::ssize(markers.names) && i < track.size(); ++i)
    track[i] = markers.position(i, column);
  return track;
}

/// Returns the positions of a point of the static trial, as a cluster moves it.
std::vector<Vec3> carried(const ClusterPoses& cluster, const Vec3& in_static) {
  std::vector<Vec3> track;
  for (const Pose& pose : cluster.world_from_static) track.emplace_back(pose * in_static);
  return track;
}

/// Returns the median distance between the positions of a point as two clusters move it.
double gap_m(const ClusterPoses& a, const ClusterPoses& b, const Vec3& in_static) {
  const auto by_a = carried(a, in_static), by_b = carried(b, in_static);
  return by_a.size() == by_b.size() ? math::median_distance(by_a, by_b) : kUnknown;
}

/// Returns the median distance of a marker from where a cluster has it in the static trial.
double shift_m(const Demonstration& recording, const ClusterPoses& cluster,
               const std::string& marker) {
  const std::vector<Vec3> recorded = marker_track(recording, marker);
  std::vector<Vec3> seen;
  for (const std::size_t frame : cluster.frames) seen.push_back(recorded[frame]);
  return math::median_distance(carried(cluster, static_position(recording, marker)), seen);
}

double known_or_zero(double value) { return std::isfinite(value) ? value : 0; }

/// Returns the sum of the shifts of finger base, shoulder and elbow, each in units of the largest
/// one of own static trials.
double landmark_shift(const Demonstration& recording, const std::string& side,
                      const std::map<std::string, ClusterPoses>& clusters) {
  const auto at = [&](const char* marker) { return static_position(recording, side + marker); };
  const ClusterPoses &girdle = clusters.at("SHO"), &upper_arm = clusters.at("UAR"),
                     &forearm = clusters.at("LAR"), &hand = clusters.at("HAN");
  const Vec3 elbow = (at("LEP") + at("MEP")) / 2;
  return known_or_zero(shift_m(recording, hand, side + "FB")) / kOwnFingerBaseShift_m +
         known_or_zero(gap_m(girdle, upper_arm, at("GTH"))) / kOwnShoulderGap_m +
         known_or_zero(gap_m(upper_arm, forearm, elbow)) / kOwnElbowGap_m;
}

/// A cluster of the static trial of which the recording has too few markers.
struct MissingCluster {
  std::size_t in_static = 0, recorded = 0;  ///< markers that are seen at all
  std::string first_missing;
};

MissingCluster missing_cluster(const Demonstration& recording, const std::string& cluster) {
  MissingCluster missing;
  for (const std::string& name : recording.calibration.markers->names) {
    if (!is_cluster_marker(name, cluster) || !is_known(static_position(recording, name))) continue;
    ++missing.in_static;
    const bool seen = std::ranges::any_of(marker_track(recording, name),
                                          [](const Vec3& point) { return is_known(point); });
    missing.recorded += seen ? 1 : 0;
    if (!seen && missing.first_missing.empty()) missing.first_missing = name;
  }
  return missing;
}

/// Adds doubts about clusters that only the static trial shows: those of the arm, and both
/// shoulders, which tell where the person faces.
void add_missing_clusters(const Demonstration& recording, const std::string& side,
                          std::vector<Doubt>& doubts) {
  for (const std::string& cluster : {side + "SHO", side + "UAR", side + "LAR", side + "HAN",
                                     (side == "R" ? "L" : "R") + std::string("SHO")}) {
    const MissingCluster missing = missing_cluster(recording, cluster);
    if (missing.in_static < kMinClusterSize || missing.recorded >= kMinClusterSize) continue;
    doubts.push_back(of_another(
        cluster, static_cast<double>(missing.recorded), static_cast<double>(kMinClusterSize), "1",
        fmt::format("{} is in the static trial, not in the recording, which shows {} of the {} "
                    "markers of cluster {} (needed: {}): positions and heading of the body are "
                    "estimated without it",
                    missing.first_missing, missing.recorded, missing.in_static, cluster,
                    kMinClusterSize)));
  }
}

}  // namespace

std::vector<Doubt> check_static_trial(const Demonstration& recording, const AuditInput&) {
  if (!recording.streams.markers || !recording.calibration.markers) return {};
  const auto flagged = [&](FlagCode code) {
    return std::ranges::find(recording.flags, code, &RecordingFlag::code) != recording.flags.end();
  };
  if (flagged(FlagCode::scale)) return {};  // its limits are those of a person's size
  std::vector<Doubt> doubts;
  const std::string side = recording.hand == Side::right ? "R" : "L";
  std::map<std::string, ClusterPoses> clusters;
  for (const char* cluster : {"SHO", "UAR", "LAR", "HAN"}) {
    const ClusterPoses& poses = clusters[cluster] = cluster_poses(recording, side + cluster);
    if (!(poses.misfit_m > kMaxClusterMisfit_m)) continue;
    doubts.push_back(of_another(
        side + cluster, poses.misfit_m, kMaxClusterMisfit_m, "m",
        fmt::format("cluster {}{} has another shape in the static trial (RMS {:.1f} mm): it is of "
                    "another person or session, or markers were moved",
                    side, cluster, 1000 * poses.misfit_m)));
  }
  const bool fits = doubts.empty();
  add_missing_clusters(recording, side, doubts);
  const double shift = landmark_shift(recording, side, clusters);
  if (fits && !flagged(FlagCode::static_trial) && shift > kMaxLandmarkShift) {
    doubts.push_back(of_another(
        "", shift, kMaxLandmarkShift, "1",
        fmt::format(
            "the static trial has shoulder, elbow and finger base elsewhere relative to the "
            "marker clusters (displacement {:.1f}; a person's own trials have at most 2.3): it "
            "is of another person or session",
            shift)));
  }
  return doubts;
}

}  // namespace morphe::imports
