#include "stages/reconstruct/joint_centre.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "stages/reconstruct/centre_of_rotation.hpp"
#include "stages/reconstruct/gaps.hpp"

namespace morphe::reconstruct {
namespace {

// Standard deviations of a joint's centre from its initial estimate.
constexpr double kLandmarkPriorSd_m = 0.03, kClusterPriorSd_m = 0.15;  // [m]

std::vector<Vec3> transform_point(const std::vector<Pose>& world_from_body, const Vec3& point) {
  std::vector<Vec3> carried;
  for (const Pose& pose : world_from_body) carried.push_back(pose * point);
  return carried;
}

/// Returns the mean of the seen points; unseen if there is no such point.
Vec3 mean_point(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const Vec3& point : points) {
    if (!is_known(point)) continue;
    sum += point;
    ++count;
  }
  return count > 0 ? Vec3(sum / count) : unknown_point();
}

/// Returns the mean of two bodies' positions of one point. While one of them is hidden, the other
/// is used with the interpolated difference, since switching would cause a step.
std::vector<Vec3> blend_tracks(const std::string& name, const std::vector<Vec3>& a,
                               const std::vector<Vec3>& b, std::vector<Residual>& residuals) {
  if (never_seen(a)) return b;
  if (never_seen(b)) return a;
  std::vector<Vec3> apart, mean;
  std::vector<double> distance;
  for (std::size_t i = 0; i < a.size(); ++i) {
    apart.push_back(a[i] - b[i]);
    distance.push_back(apart.back().norm());
  }
  residuals.push_back(residual_of(name, distance));
  interpolate_unseen(apart);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 half = is_known(apart[i]) ? Vec3(apart[i] / 2) : Vec3::Zero();
    mean.push_back(is_known(a[i]) ? Vec3(a[i] - half) : Vec3(b[i] + half));
  }
  return mean;
}

/// The position of a joint in one body's frame: the mean of its landmarks, or the centre of the
/// body.
struct BodyPoint {
  Vec3 place;
  std::size_t known = 0;  ///< number of landmarks
};

BodyPoint find_body_point(MarkerTrial& trial, const std::vector<Landmark>& landmarks,
                          const MarkerBody& body, HumanMotion& motion) {
  std::vector<Vec3> places;
  for (const Landmark& landmark : landmarks) {
    const Vec3 place = landmark_in_body(trial, landmark, body, motion);
    if (is_known(place)) places.push_back(place);
  }
  return {places.empty() ? mean_point(body.shape) : mean_point(places), places.size()};
}

}  // namespace

std::vector<Vec3> joint_centre(MarkerTrial& trial, const MarkerJoint& joint,
                               const MarkerBody& first, const MarkerBody& second,
                               HumanMotion& motion) {
  const std::size_t frames = trial.clock.count;
  std::vector<Landmark> landmarks;
  for (const std::string& name : joint.landmarks) {
    landmarks.push_back(make_landmark(trial, name, first, motion));
  }
  if (std::ranges::all_of(landmarks, [](const Landmark& l) { return !l.track.empty(); })) {
    std::vector<Vec3> middle(frames, Vec3::Zero());
    for (const Landmark& landmark : landmarks) {
      for (std::size_t i = 0; i < frames; ++i) {
        middle[i] += landmark.track[i] / static_cast<double>(landmarks.size());
      }
    }
    return middle;
  }
  if (!first.exists() && !second.exists()) return std::vector<Vec3>(frames, unknown_point());

  BodyPoint a = find_body_point(trial, landmarks, first, motion),
            b = find_body_point(trial, landmarks, second, motion);
  const bool known = std::max(a.known, b.known) == landmarks.size();
  const std::string pair = fmt::format("{} against {}", first.name, second.name);
  const bool both = first.exists() && second.exists();
  if (!both && known) {
    return first.exists() ? transform_point(first.world_from_body, a.place)
                          : transform_point(second.world_from_body, b.place);
  }
  const bool in_world = first.exists() && !second.exists() && joint.name == "shoulder";
  if (!both && !in_world) {
    motion.reconstruction_notes.push_back(fmt::format(
        "{}: {} were not seen, and {} has no neighbour that it rotates about: not reconstructed",
        joint.name, fmt::join(joint.landmarks, ", "), first.exists() ? first.name : second.name));
    return std::vector<Vec3>(frames, unknown_point());
  }
  std::vector<Pose> other = second.world_from_body;
  if (in_world) {
    other.assign(frames, Pose::Identity());
    b.place = mean_point(transform_point(first.world_from_body, a.place));
  }
  if (joint.refine_by_motion || !known) {
    const bool near = std::max(a.known, b.known) > 0;
    const CentreOfRotation pivot = estimate_centre_of_rotation(
        first.world_from_body, other,
        {a.place, b.place, near ? kLandmarkPriorSd_m : kClusterPriorSd_m});
    if (!is_known(pivot.in_a) || !is_known(pivot.in_b))
      return std::vector<Vec3>(frames, unknown_point());
    a.place = pivot.in_a;
    b.place = pivot.in_b;
    if (!known) {
      motion.estimated.push_back(joint.name);
      motion.reconstruction_notes.push_back(fmt::format(
          "{}: estimated as the centre of rotation of {} and {} ({:.1f} mm RMS; uncertain by "
          "{:.0f} mm along the least certain direction), because not all of {} were seen; a static "
          "trial would show them",
          joint.name, first.name, in_world ? "the world" : second.name, 1000 * pivot.residual_m,
          1000 * pivot.uncertainty_m, fmt::join(joint.landmarks, ", ")));
    }
  }
  return blend_tracks(
      fmt::format("{}, {}", joint.name, in_world ? first.name + " against the world" : pair),
      transform_point(first.world_from_body, a.place), transform_point(other, b.place),
      motion.residuals);
}

}  // namespace morphe::reconstruct
