#include "pipeline/setup/flange.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/tree.hpp"

namespace morphe::setup {
namespace {

constexpr double kMaxFlangeOffset_m = 0.005;  ///< of the flange's frame from the last axis
constexpr double kMinLinkEnd_m = 0.01;        ///< a nearer end does not show where a link leads
/// Shapes that end beyond the last frame by at most this stand for its surface [m]. The meshes of
/// xArm 7, RM75 and UR5e, whose last frames are on their flanges, end within 2 mm of them.
constexpr double kMinShapeBeyond_m = 0.005;
constexpr double kMinTwistCosine = 0.8;  ///< of the axis that twists a forearm, to the wrist
constexpr double kMaxBendCosine = 0.5;   ///< of the axis of a hinge to the forearm, at rest

/// Returns the frames fixed to a moving one, without it.
std::vector<int> fixed_frames(const Kinematics& robot, int moving) {
  std::vector<int> found;
  for (int f = moving + 1; f < std::ssize(robot.table().frames); ++f)
    if (robot::moving_frame_of(robot.table(), f) == moving) found.push_back(f);
  return found;
}

/// Returns the points of a moving link's shapes, in the base frame.
std::vector<Vec3> link_points(const Kinematics& robot, int moving, const BodyPoints& points) {
  std::vector<Vec3> found;
  for (const auto& [frame, own] : points)
    if (robot::moving_frame_of(robot.table(), frame) == moving)
      for (const Vec3& point : own) found.push_back(robot.pose(frame) * point);
  return found;
}

std::optional<Vec3> farthest_of(const std::vector<Vec3>& points, const Vec3& from) {
  const auto far = std::ranges::max_element(
      points, {}, [&](const Vec3& point) { return (point - from).norm(); });
  if (far == points.end() || (*far - from).norm() < kMinLinkEnd_m) return std::nullopt;
  return *far;
}

/// Returns the point twice as far from a link's origin as its centre of mass.
std::vector<Vec3> end_from_inertia(const Kinematics& robot, int frame) {
  const auto inertia = robot.model->inertias.find(robot.link[frame]);
  if (inertia == robot.model->inertias.end()) return {};
  return {robot.pose(frame) * Vec3(2 * inertia->second.link_from_inertia.translation())};
}

/// Returns the direction of the forearm: of the axis that twists it, if there is one, else from the
/// elbow to the wrist.
Vec3 forearm_direction(const Kinematics& robot, const Arm& arm) {
  const Vec3 to_wrist =
      (position_in_base(robot, arm.centres.wrist) - position_in_base(robot, arm.centres.elbow))
          .normalized();
  const auto beyond = std::ranges::find(arm.frames, arm.elbow) + 1;
  if (beyond == arm.frames.end()) return to_wrist;
  const Vec3 axis = robot.axis(*beyond).direction;
  if (std::abs(axis.dot(to_wrist)) < kMinTwistCosine) return to_wrist;
  return axis.dot(to_wrist) < 0 ? Vec3(-axis) : axis;
}

/// Returns true if the last axis bends the wrist like those of a human: it is perpendicular to the
/// forearm, and so is one before it, behind one that twists the forearm.
bool ends_in_hinge(const Kinematics& robot, const Arm& arm, const Vec3& forearm) {
  const auto along = [&](int frame) { return std::abs(robot.axis(frame).direction.dot(forearm)); };
  const auto elbow = std::ranges::find(arm.frames, arm.elbow);
  if (std::distance(elbow, arm.frames.end()) < 3) return arm.frames.back() == arm.elbow;
  return along(*(elbow + 1)) > kMinTwistCosine && along(arm.frames.back()) < kMaxBendCosine;
}

/// Returns the direction in which the last link leads away from its axis.
Vec3 outwards_along(const Kinematics& robot, const Arm& arm, const BodyPoints& points,
                    Provenance& sure) {
  const int last = arm.frames.back();
  const Line axis = robot.axis(last);
  const auto along = [&](const Vec3& point) { return (point - axis.point).dot(axis.direction); };
  const double before = -along(robot.pose(arm.frames[arm.frames.size() - 2]).translation());
  double ahead = before;
  if (std::abs(before) <= 1e-3) {  // both joints coincide
    const std::optional<Vec3> end = end_of_link(robot, last, points);
    ahead = end ? along(*end) : 0;
  }
  sure = std::abs(ahead) > 1e-3 ? Provenance::derived : Provenance::assumed;
  return ahead < -1e-3 ? Vec3(-axis.direction) : axis.direction;
}

/// Returns the frames that are fixed to a link on its axis, and not behind its origin.
std::vector<int> frames_ahead(const Kinematics& robot, int last, const Line& outwards) {
  std::vector<int> found;
  for (const int frame : fixed_frames(robot, last)) {
    const Vec3 origin = robot.pose(frame).translation();
    const double along_m = (origin - outwards.point).dot(outwards.direction);
    if (distance(outwards, origin) < kMaxFlangeOffset_m && along_m > -kMaxFlangeOffset_m)
      found.push_back(frame);
  }
  return found;
}

/// Returns the farthest outwards of frames on an axis, or the link itself if none is beyond it.
int farthest_ahead(const Kinematics& robot, int last, const std::vector<int>& frames,
                   const Line& outwards) {
  int best = last;
  double farthest_m = 1e-6;
  for (const int frame : frames) {
    const double along_m =
        (robot.pose(frame).translation() - outwards.point).dot(outwards.direction);
    if (along_m <= farthest_m) continue;
    best = frame;
    farthest_m = along_m;
  }
  return best;
}

/// Returns the pose of a flange on a line that leads outwards, with x near that of a frame.
Pose flange_on(const Line& outwards, const Pose& near) {
  Vec3 x = near.linear().col(0);
  x -= x.dot(outwards.direction) * outwards.direction;
  if (x.norm() < 0.5) {
    const Vec3 y = near.linear().col(1);
    x = y - y.dot(outwards.direction) * outwards.direction;
  }
  Pose pose = Pose::Identity();
  pose.translation() = outwards.point;
  pose.linear().col(2) = outwards.direction;
  pose.linear().col(0) = x.normalized();
  pose.linear().col(1) = outwards.direction.cross(x.normalized());
  return pose;
}

/// Returns the flange of an arm whose last axis bends the wrist.
Flange flange_beyond_hinge(const Kinematics& robot, const Arm& arm, const BodyPoints& points,
                           const Vec3& forearm) {
  Flange flange;
  flange.frame = arm.frames.back();
  flange.sure = Provenance::assumed;
  Line outwards{robot.pose(flange.frame).translation(), forearm};
  if (const std::optional<Vec3> end = end_of_link(robot, flange.frame, points)) {
    const Vec3 away = *end - project_onto_line(robot.axis(flange.frame), *end);
    if (away.norm() > kMinLinkEnd_m) outwards.direction = away.normalized();
    outwards.point += (*end - outwards.point).dot(outwards.direction) * outwards.direction;
  }
  const Pose& pose = robot.pose(flange.frame);
  flange.frame_from_flange = pose.inverse() * flange_on(outwards, pose);
  return flange;
}

}  // namespace

std::optional<Vec3> end_of_link(const Kinematics& robot, int frame, const BodyPoints& points) {
  const Vec3 origin = robot.pose(frame).translation();
  std::vector<Vec3> fixed;
  for (const int f : fixed_frames(robot, frame)) fixed.push_back(robot.pose(f).translation());
  if (const auto end = farthest_of(fixed, origin)) return end;
  if (const auto end = farthest_of(link_points(robot, frame, points), origin)) return end;
  return farthest_of(end_from_inertia(robot, frame), origin);
}

Flange find_flange(const Kinematics& robot, const Arm& arm, const BodyPoints& points) {
  const Vec3 forearm = forearm_direction(robot, arm);
  if (ends_in_hinge(robot, arm, forearm)) return flange_beyond_hinge(robot, arm, points, forearm);
  Flange flange;
  const int last = arm.frames.back();
  Line outwards = robot.axis(last);
  outwards.direction = outwards_along(robot, arm, points, flange.sure);
  const std::vector<int> ahead = frames_ahead(robot, last, outwards);
  flange.frame = farthest_ahead(robot, last, ahead, outwards);
  const Pose& pose = robot.pose(flange.frame);
  outwards.point = project_onto_line(outwards, pose.translation());
  if (ahead.empty()) {
    double beyond_m = 0;
    for (const Vec3& point : link_points(robot, last, points))
      beyond_m = std::max(beyond_m, (point - outwards.point).dot(outwards.direction));
    if (beyond_m > kMinShapeBeyond_m) outwards.point += beyond_m * outwards.direction;
  }
  flange.frame_from_flange = pose.inverse() * flange_on(outwards, pose);
  return flange;
}

}  // namespace morphe::setup
