#include "stages/import/trackers/world_checks.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "core/motion/bounding_box.hpp"
#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

constexpr double kMaxHandsAboveHead_m = 0.15;  ///< median over a recording
constexpr double kHeldObjectDistance_m = 0.3;  ///< of the wrist from a sphere around an object
constexpr double kStationaryMotion_m = 0.05;   ///< largest displacement of an object at rest
constexpr double kMaxClockOffset_s = 0.1;      ///< of an object's pose from that of a wrist

std::vector<Vec3> joint_of(const BodyStream& body, const std::string& name) {
  std::vector<Vec3> points;
  const int k = name_index(body.names, name);
  if (k < 0) return points;
  for (std::size_t i = 0; i < body.position.rows; ++i) points.push_back(body.position(i, k));
  return points;
}

std::vector<std::vector<Vec3>> wrists_of(const HandClip& clip) {
  std::vector<std::vector<Vec3>> wrists;
  for (const Side side : {Side::right, Side::left}) {
    std::vector<Vec3> wrist = joint_of(clip.body, std::string(name_of(side)) + "_wrist");
    const auto& hand = clip.hands[side_index(side)];
    if (wrist.empty() && hand) {
      for (std::size_t i = 0; i < hand->keypoints.rows; ++i) wrist.push_back(hand->keypoints(i, 0));
    }
    if (!wrist.empty()) wrists.push_back(std::move(wrist));
  }
  return wrists;
}

void report_up_axis(const HandClip& clip, const std::vector<std::vector<Vec3>>& wrists,
                    std::vector<std::string>& reports) {
  const std::vector<Vec3> head = joint_of(clip.body, "head");
  std::vector<double> heights;
  for (std::size_t i = 0; i < head.size(); ++i) {
    for (const std::vector<Vec3>& wrist : wrists) {
      const double height = wrist[i].z() - head[i].z();
      if (std::isfinite(height)) heights.push_back(height);
    }
  }
  if (heights.empty()) return;
  const double median_m = math::median(heights);
  if (median_m < kMaxHandsAboveHead_m) return;
  add_note(reports,
           "the median height of the hands above the head is {:.2f} m; another axis may be up "
           "(--axes)",
           median_m);
}

/// Returns the distance of an object to the nearest wrist in the frames before and after a time, if
/// they are at most 0.1 s away; NaN if no wrist was seen in them. `time` is that of `wrists`.
double nearest_wrist_distance(const std::vector<double>& time,
                              const std::vector<std::vector<Vec3>>& wrists, double time_s,
                              const Vec3& object) {
  const auto next = std::ranges::lower_bound(time, time_s) - time.begin();
  double nearest = kUnknown;
  for (const auto i : {next, next == 0 ? next : next - 1}) {
    if (i == std::ssize(time) || std::abs(time[i] - time_s) > kMaxClockOffset_s) continue;
    for (const std::vector<Vec3>& wrist : wrists)
      nearest = std::fmin(nearest, (wrist[i] - object).norm());
  }
  return nearest;
}

/// Returns the radius of a sphere around the origin that contains the object's box [m].
double radius_of(const SceneObject& object) {
  const Eigen::AlignedBox3d box = bounding_box(object, Pose::Identity());
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm();
}

/// Returns the diagonal of the box around an object's positions before a hand first comes near [m],
/// since it may roll or swing afterwards; the largest of the intervals in which a wrist was seen.
double displacement_before_contact(const SceneObject& object, const std::vector<double>& time,
                                   const std::vector<std::vector<Vec3>>& wrists) {
  const double contact_distance_m = kHeldObjectDistance_m + radius_of(object);
  double displacement_m = 0;
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < object.time.size(); ++i) {
    const Vec3& position = object.position[i];
    if (!is_known(position)) continue;
    const double distance_m = nearest_wrist_distance(time, wrists, object.time[i], position);
    if (distance_m <= contact_distance_m) break;
    if (std::isnan(distance_m)) {
      box.setEmpty();
      continue;
    }
    box.extend(position);
    displacement_m = std::max(displacement_m, box.diagonal().norm());
  }
  return displacement_m;
}

}  // namespace

void check_world(const HandClip& clip, std::vector<std::string>& reports) {
  const std::vector<std::vector<Vec3>> wrists = wrists_of(clip);
  if (wrists.empty()) return;
  report_up_axis(clip, wrists, reports);
  for (const SceneObject& object : clip.objects) {
    const double displacement_m = displacement_before_contact(object, clip.time, wrists);
    if (displacement_m > kStationaryMotion_m) {
      add_note(reports,
               "object {} moves by {:.2f} m before a hand comes near: the reference frame may "
               "move, as a camera's does, or something else moves the object",
               object.name, displacement_m);
    }
  }
}

}  // namespace morphe::imports
