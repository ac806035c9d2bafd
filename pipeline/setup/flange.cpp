#include "pipeline/setup/flange.hpp"

#include <cmath>

namespace morphe::setup {
namespace {

/// Returns the frame fixed to the last link, near its axis, that is farthest along the axis.
int farthest_fixed_frame(const Kinematics& robot, int last, const Vec3& outwards) {
  const Line axis = robot.axis(last);
  int best = last;
  double farthest = 1e-6;
  const auto look = [&](const auto& self, int frame) -> void {
    for (const int child : robot.children[frame]) {
      if (robot.moves(child)) continue;
      const Vec3 at = robot.pose(child).translation();
      const double along = (at - axis.point).dot(outwards);
      if (distance(axis, at) < 0.005 && along > farthest) {
        best = child;
        farthest = along;
      }
      self(self, child);
    }
  };
  look(look, last);
  return best;
}

}  // namespace

Flange find_flange(const Kinematics& robot, const std::vector<int>& arm) {
  Flange flange;
  const int last = arm.back();
  const Line axis = robot.axis(last);
  // The preceding joint is behind the flange; if the two frames coincide, +z is the usual
  // direction.
  Vec3 outwards = axis.direction;
  if (arm.size() > 1) {
    const Vec3 before = robot.pose(arm[arm.size() - 2]).translation();
    const double behind = (axis.point - before).dot(axis.direction);
    if (behind < -1e-3) outwards = -outwards;
    flange.sure = std::abs(behind) > 1e-3 ? Provenance::derived : Provenance::assumed;
  }
  flange.frame = farthest_fixed_frame(robot, last, outwards);
  const Pose& pose = robot.pose(flange.frame);
  Vec3 x = pose.linear().col(0);
  x -= x.dot(outwards) * outwards;
  if (x.norm() < 0.5) x = pose.linear().col(1) - pose.linear().col(1).dot(outwards) * outwards;
  Pose base_from_flange = Pose::Identity();
  base_from_flange.translation() = project_onto_line(axis, pose.translation());
  base_from_flange.linear().col(2) = outwards;
  base_from_flange.linear().col(0) = x.normalized();
  base_from_flange.linear().col(1) = outwards.cross(x.normalized());
  flange.frame_from_flange = pose.inverse() * base_from_flange;
  return flange;
}

}  // namespace morphe::setup
