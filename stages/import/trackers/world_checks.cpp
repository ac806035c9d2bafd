#include "stages/import/trackers/world_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/statistics.hpp"
#include "core/motion/bounding_box.hpp"

namespace morphe::imports {
namespace {

/// Height of the hands above the head, in the median of a recording.
constexpr double kMaxHandsAboveHead_m = 0.15;
/// Distance of the wrist from a sphere around an object that is held.
constexpr double kHeldObjectDistance_m = 0.3;
constexpr double kStationaryMotion_m = 0.05;  ///< displacement below which an object is stationary
constexpr double kMaxClockOffset_s = 0.1;     ///< an object's clock may differ

/// Returns [N] positions of a joint of the body, empty if it has no joint of that name.
std::vector<Vec3> joint_of(const BodyStream& body, const std::string& name) {
  std::vector<Vec3> points;
  const auto found = std::ranges::find(body.names, name);
  if (found == body.names.end()) return points;
  const auto k = static_cast<std::size_t>(found - body.names.begin());
  for (std::size_t i = 0; i < body.position.rows; ++i) points.push_back(body.position(i, k));
  return points;
}

std::vector<std::vector<Vec3>> wrists_of(const HandClip& clip) {
  std::vector<std::vector<Vec3>> wrists;
  for (const Side side : {Side::right, Side::left}) {
    std::vector<Vec3> wrist = joint_of(clip.body, std::string(name_of(side)) + "_wrist");
    const auto& hand = clip.hands[static_cast<std::size_t>(side)];
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
  std::vector<double> above;
  for (std::size_t i = 0; i < head.size(); ++i) {
    for (const std::vector<Vec3>& wrist : wrists) {
      const double height = wrist[i].z() - head[i].z();
      if (std::isfinite(height)) above.push_back(height);
    }
  }
  if (above.empty()) return;
  const double usual = math::median(above);
  if (usual < kMaxHandsAboveHead_m) return;
  reports.push_back(fmt::format(
      "the median height of the hands above the head is {:.2f} m; another axis may be up (--axes)",
      usual));
}

/// Returns the distance from an object to the nearest wrist that was seen at about that time; NaN
/// if no wrist was seen.
double nearest_wrist_distance(const std::vector<double>& time,
                              const std::vector<std::vector<Vec3>>& wrists, double time_s,
                              const Vec3& object) {
  const auto next = std::ranges::lower_bound(time, time_s);
  double nearest = kUnknown;
  for (const auto at : {next, next == time.begin() ? next : next - 1}) {
    if (at == time.end() || std::abs(*at - time_s) > kMaxClockOffset_s) continue;
    const auto i = static_cast<std::size_t>(at - time.begin());
    for (const std::vector<Vec3>& wrist : wrists) {
      nearest = std::fmin(nearest, (wrist[i] - object).norm());
    }
  }
  return nearest;
}

/// Returns the radius of a sphere around the origin that contains the object's box [m].
double radius_of(const SceneObject& object) {
  const Eigen::AlignedBox3d box = bounding_box(object, Pose::Identity());
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm();
}

/// Returns the displacement of an object, corner to corner, before a hand comes near, while hands
/// are seen [m]. (Afterwards it may roll or swing by itself.).
double displacement_before_contact(const SceneObject& object, const std::vector<double>& time,
                                   const std::vector<std::vector<Vec3>>& wrists) {
  const double near_m = kHeldObjectDistance_m + radius_of(object);
  double most = 0;
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < object.time.size(); ++i) {
    const Vec3& here = object.position[i];
    if (!is_known(here)) continue;
    const double away = nearest_wrist_distance(time, wrists, object.time[i], here);
    if (away <= near_m) break;
    if (std::isnan(away)) {
      box.setEmpty();
      continue;
    }
    box.extend(here);
    most = std::max(most, box.diagonal().norm());
  }
  return most;
}

}  // namespace

void check_world(const HandClip& clip, std::vector<std::string>& reports) {
  const std::vector<std::vector<Vec3>> wrists = wrists_of(clip);
  if (wrists.empty()) return;
  report_up_axis(clip, wrists, reports);
  for (const SceneObject& object : clip.objects) {
    const double moved = displacement_before_contact(object, clip.time, wrists);
    if (moved > kStationaryMotion_m) {
      reports.push_back(
          fmt::format("object {} moves by {:.2f} m before a hand comes near: the reference frame "
                      "may move, as a camera's does, or something else moves the object",
                      object.name, moved));
    }
  }
}

}  // namespace morphe::imports
