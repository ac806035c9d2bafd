#include "stages/import/audit/hand_side.hpp"

#include <string>
#include <vector>

#include "core/math/statistics.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/marker_clusters.hpp"
#include "stages/import/audit/sampled_points.hpp"
#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {
namespace {

/// The plane of a hand: a point of it, and the normal on the palm's side.
struct HandPlane {
  Vec3 base = unknown_point(), palmward = unknown_point();
};

/// Tracks of the points that span the plane of the hand; `radial` is on the thumb's side.
struct HandTracks {
  std::vector<Vec3> wrist, base, radial, ulnar;
};

Vec3 first_known(const Vec3& a, const Vec3& b) { return is_known(a) ? a : b; }

HandTracks hand_tracks(const RecordedPoints& points, const std::string& side) {
  const auto track = [&](const char* part) { return mean_track(points, side + part); };
  HandTracks hand{track("wrist"), track("middle mcp"), track("wrist, thumb"),
                  track("wrist, little")};
  const auto index = track("index mcp"), little = track("little mcp");
  for (int i = 0; i < std::ssize(hand.wrist); ++i) {
    hand.base[i] = first_known(hand.base[i], index[i]);
    if (is_known(hand.radial[i]) && is_known(hand.ulnar[i])) continue;
    hand.radial[i] = index[i];
    hand.ulnar[i] = little[i];
  }
  return hand;
}

HandPlane plane_of(const Vec3& wrist, const Vec3& base, const Vec3& across, Side side) {
  const Vec3 back_of_right = (base - wrist).cross(across).normalized();
  return {base, side == Side::right ? Vec3(-back_of_right) : back_of_right};
}

std::vector<HandPlane> recorded_planes(const RecordedPoints& points, Side side) {
  const HandTracks hand = hand_tracks(points, std::string(name_of(side)) + " ");
  std::vector<HandPlane> planes;
  for (int i = 0; i < std::ssize(hand.wrist); ++i)
    planes.push_back(plane_of(hand.wrist[i], hand.base[i], hand.radial[i] - hand.ulnar[i], side));
  return planes;
}

/// Returns the plane in the static trial, moved with the hand's cluster.
std::vector<HandPlane> carried_planes(const Demonstration& recording,
                                      const RecordedPoints& points) {
  std::vector<HandPlane> planes(points.time.size());  // of the frames of ClusterPoses, too
  const RecordedPoints trial = sampled_points(recording.calibration, recording.hand);
  if (trial.time.empty() || !recording.streams.markers) return planes;
  const Side side = recording.hand;
  const HandTracks hand = hand_tracks(trial, std::string(name_of(side)) + " ");
  const Vec3 across = math::median_point(hand.radial) - math::median_point(hand.ulnar);
  const HandPlane still =
      plane_of(math::median_point(hand.wrist), math::median_point(hand.base), across, side);
  const ClusterPoses cluster = cluster_poses(recording, side == Side::right ? "RHAN" : "LHAN");
  for (std::size_t k = 0; k < cluster.frames.size(); ++k) {
    const Pose& pose = cluster.world_from_static[k];
    planes[k] = {pose * still.base, pose.linear() * still.palmward};
  }
  return planes;
}

}  // namespace

double palmward_tips_m(const Demonstration& recording) {
  const RecordedPoints points = sampled_points(recording.streams, recording.hand);
  const std::string side = std::string(name_of(recording.hand)) + " ";
  std::vector<HandPlane> planes = recorded_planes(points, recording.hand);
  const auto known = [](const HandPlane& plane) { return is_known(plane.palmward); };
  if (std::ranges::none_of(planes, known)) planes = carried_planes(recording, points);
  std::vector<std::vector<Vec3>> tips;
  for (const char* finger : {"thumb tip", "index tip", "middle tip", "ring tip", "little tip"})
    tips.push_back(mean_track(points, side + finger));
  std::vector<double> displacements;
  for (int i = 0; i < std::ssize(planes); ++i) {
    std::vector<double> of_tips;
    for (const std::vector<Vec3>& tip : tips)
      of_tips.push_back((tip[i] - planes[i].base).dot(planes[i].palmward));
    const double mean = math::mean(of_tips);
    if (std::isfinite(mean)) displacements.push_back(mean);
  }
  return math::median(displacements);
}

}  // namespace morphe::imports
