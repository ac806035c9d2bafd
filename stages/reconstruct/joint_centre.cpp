#include "stages/reconstruct/joint_centre.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "stages/reconstruct/centre_of_rotation.hpp"
#include "stages/reconstruct/gaps.hpp"
#include "stages/reconstruct/residual_sum.hpp"

namespace morphe::reconstruct {
namespace {

// Standard deviations of a joint's centre from its initial estimate.
constexpr double kLandmarkPriorSd_m = 0.03, kClusterPriorSd_m = 0.15;

std::vector<Vec3> transform_point(const std::vector<Pose>& world_from_body, const Vec3& point) {
  std::vector<Vec3> positions;
  for (const Pose& pose : world_from_body) positions.push_back(pose * point);
  return positions;
}

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

/// Returns the mean of the positions that two bodies give of one point. While one body is hidden,
/// the other's position is moved by half of the interpolated difference, which avoids a step.
std::vector<Vec3> blend_tracks(const std::string& name, const std::vector<Vec3>& a,
                               const std::vector<Vec3>& b, std::vector<Residual>& residuals) {
  if (never_seen(a)) return b;
  if (never_seen(b)) return a;
  std::vector<Vec3> difference, mean;
  ResidualSum distances;
  for (int i = 0; i < std::ssize(a); ++i) {
    difference.push_back(a[i] - b[i]);
    distances.add(difference.back().norm());
  }
  residuals.push_back(distances.residual(name));
  interpolate_unseen(difference);
  for (int i = 0; i < std::ssize(a); ++i) {
    const Vec3 half = is_known(difference[i]) ? Vec3(difference[i] / 2) : Vec3::Zero();
    mean.push_back(is_known(a[i]) ? Vec3(a[i] - half) : Vec3(b[i] + half));
  }
  return mean;
}

/// The position of a joint in a body's frame: the mean of its known landmarks, else the body's
/// centre.
struct BodyPoint {
  Vec3 in_body;
  std::ptrdiff_t landmark_count = 0;
};

BodyPoint find_body_point(MarkerTrial& trial, const std::vector<Landmark>& landmarks,
                          const MarkerBody& body, HumanMotion& motion) {
  std::vector<Vec3> known;
  for (const Landmark& landmark : landmarks) {
    const Vec3 in_body = landmark_in_body(trial, landmark, body, motion);
    if (is_known(in_body)) known.push_back(in_body);
  }
  return {mean_point(known.empty() ? body.shape : known), std::ssize(known)};
}

}  // namespace

std::vector<Vec3> joint_centre(MarkerTrial& trial, const MarkerJoint& joint,
                               const MarkerBody& first, const MarkerBody& second,
                               HumanMotion& motion) {
  const std::vector<Vec3> unseen(trial.clock.count, unknown_point());
  std::vector<Landmark> landmarks;
  for (const std::string& name : joint.landmarks) {
    landmarks.push_back(make_landmark(trial, name, first, motion));
  }
  if (std::ranges::all_of(landmarks, [](const Landmark& l) { return !l.track.empty(); })) {
    std::vector<Vec3> mean(trial.clock.count, Vec3::Zero());
    for (const Landmark& landmark : landmarks) {
      for (int i = 0; i < trial.clock.count; ++i) {
        mean[i] += landmark.track[i] / static_cast<double>(landmarks.size());
      }
    }
    return mean;
  }
  if (!first.exists() && !second.exists()) return unseen;

  BodyPoint a = find_body_point(trial, landmarks, first, motion),
            b = find_body_point(trial, landmarks, second, motion);
  const bool known = std::max(a.landmark_count, b.landmark_count) == std::ssize(landmarks);
  const bool both = first.exists() && second.exists();
  if (!both && known) {
    return first.exists() ? transform_point(first.world_from_body, a.in_body)
                          : transform_point(second.world_from_body, b.in_body);
  }
  const bool in_world = first.exists() && !second.exists() && joint.name == "shoulder";
  if (!both && !in_world) {
    motion.reconstruction_notes.push_back(fmt::format(
        "{}: {} were not seen, and {} has no neighbour that it rotates about: not reconstructed",
        joint.name, fmt::join(joint.landmarks, ", "), first.exists() ? first.name : second.name));
    return unseen;
  }
  std::vector<Pose> other = second.world_from_body;
  if (in_world) {
    other.assign(trial.clock.count, Pose::Identity());
    b.in_body = mean_point(transform_point(first.world_from_body, a.in_body));
  }
  const std::string other_name = in_world ? "the world" : second.name;
  if (joint.refine_by_motion || !known) {
    const bool any_landmark = std::max(a.landmark_count, b.landmark_count) > 0;
    const CentreOfRotation pivot = estimate_centre_of_rotation(
        first.world_from_body, other,
        {a.in_body, b.in_body, any_landmark ? kLandmarkPriorSd_m : kClusterPriorSd_m});
    if (!is_known(pivot.in_a) || !is_known(pivot.in_b)) return unseen;
    a.in_body = pivot.in_a;
    b.in_body = pivot.in_b;
    if (!known) {
      motion.estimated.push_back(joint.name);
      motion.reconstruction_notes.push_back(fmt::format(
          "{}: estimated as the centre of rotation of {} and {} ({:.1f} mm RMS; uncertain by "
          "{:.0f} mm along the least certain direction), because not all of {} were seen; a static "
          "trial would show them",
          joint.name, first.name, other_name, 1000 * pivot.residual_m, 1000 * pivot.uncertainty_m,
          fmt::join(joint.landmarks, ", ")));
    }
  }
  return blend_tracks(fmt::format("{}, {} against {}", joint.name, first.name, other_name),
                      transform_point(first.world_from_body, a.in_body),
                      transform_point(other, b.in_body), motion.residuals);
}

}  // namespace morphe::reconstruct
