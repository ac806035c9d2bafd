#include "pipeline/setup/finger_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/tree.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

/// Depth of the end of a body, whose points are averaged [m]; chosen by hand: a fingertip's radius
/// is two to three times as large.
constexpr double kFarEndDepth_m = 0.003;

std::optional<Vec3> centre_of_mass(const Kinematics& robot, int frame) {
  const auto inertia = robot.model->inertias.find(robot.link[frame]);
  if (inertia == robot.model->inertias.end()) return std::nullopt;
  const Vec3 centre = inertia->second.link_from_inertia.translation();
  return centre.norm() > 1e-4 ? std::optional(centre) : std::nullopt;
}

/// Returns the mean of the points that are about as far from `from` as the farthest.
Vec3 farthest_part(const std::vector<Vec3>& points, const Vec3& from) {
  double farthest_m = 0;
  for (const Vec3& point : points) farthest_m = std::max(farthest_m, (point - from).norm());
  std::vector<Vec3> end;
  for (const Vec3& point : points)
    if ((point - from).norm() > farthest_m - kFarEndDepth_m) end.push_back(point);
  return mean_of(end);
}

/// Returns the tip in the file, else the centre of mass times `factor`, else the joint's origin.
BodyPoint point_without_shapes(const Kinematics& robot, const Finger& finger,
                               const BodyPoints& points, double factor) {
  BodyPoint found{finger.body, Vec3::Zero(), Provenance::assumed};
  const int tip = find_urdf_tip(robot, finger.body, points);
  if (tip >= 0) {
    found.position = robot.pose(finger.body).inverse() * robot.pose(tip).translation();
    found.sure = Provenance::read;
  } else if (const std::optional<Vec3> centre = centre_of_mass(robot, finger.body)) {
    found.position = factor * *centre;
  }
  return found;
}

}  // namespace

Vec3 mean_of(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point / static_cast<double>(points.size());
  return sum;
}

Vec3 perpendicular_part(const Vec3& v, const Vec3& axis) { return v - v.dot(axis) * axis; }

std::vector<Vec3> body_points(const Kinematics& robot, int moving, const BodyPoints& points,
                              const std::vector<Pose>& poses) {
  std::vector<Vec3> found;
  for (const auto& [frame, own] : points) {
    if (!robot::is_in_subtree(robot.table(), frame, moving)) continue;
    if (!joint_frames_between(robot, moving, frame).empty()) continue;
    for (const Vec3& point : own) found.push_back(poses[frame] * point);
  }
  return found;
}

int find_urdf_tip(const Kinematics& robot, int last, const BodyPoints& points) {
  constexpr double kNamed_m = 1;  // added to the distance of frames named a tip: they come first
  int best = -1;
  double farthest_m = 1e-3;
  const auto search = [&](const auto& self, int frame) -> void {
    for (const int child : robot.children[frame]) {
      if (robot.moves(child)) continue;
      const bool named = lower_case(robot.link[child]).find("tip") != std::string::npos;
      const double distance_m =
          distance(robot.axis(last), robot.pose(child).translation()) + (named ? kNamed_m : 0);
      if ((named || !points.contains(child)) && distance_m > farthest_m) {
        best = child;
        farthest_m = distance_m;
      }
      self(self, child);
    }
  };
  search(search, last);
  return best;
}

BodyPoint body_middle(const Kinematics& robot, const Finger& finger, const BodyPoints& points) {
  const int moving = robot::moving_frame_of(robot.table(), finger.body);
  const std::vector<Vec3> body = body_points(robot, moving, points, robot.base_from_frame);
  if (body.empty()) return point_without_shapes(robot, finger, points, 1);
  return {finger.body, robot.pose(finger.body).inverse() * mean_of(body), Provenance::derived};
}

BodyPoint body_end(const Kinematics& robot, const Finger& finger, const BodyPoints& points,
                   const Vec3& from) {
  const int moving = robot::moving_frame_of(robot.table(), finger.body);
  const std::vector<Vec3> body = body_points(robot, moving, points, robot.base_from_frame);
  if (body.empty()) return point_without_shapes(robot, finger, points, 2);
  const Vec3 end = farthest_part(body, from);
  return {finger.body, robot.pose(finger.body).inverse() * end, Provenance::derived};
}

}  // namespace morphe::setup
