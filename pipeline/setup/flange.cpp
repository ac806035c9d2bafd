#include "pipeline/setup/flange.hpp"

#include <cmath>

namespace morphe::setup {
namespace {

/// Returns the frame farthest along the last axis, of those fixed to the last link near this axis.
int farthest_fixed_frame(const Kinematics& robot, int last, const Vec3& outwards) {
  const Line axis = robot.axis(last);
  int best = last;
  double farthest_m = 1e-6;
  const auto search = [&](const auto& self, int frame) -> void {
    for (const int child : robot.children[frame]) {
      if (robot.moves(child)) continue;
      const Vec3 origin = robot.pose(child).translation();
      const double along_m = (origin - axis.point).dot(outwards);
      if (distance(axis, origin) < 0.005 && along_m > farthest_m) {
        best = child;
        farthest_m = along_m;
      }
      self(self, child);
    }
  };
  search(search, last);
  return best;
}

}  // namespace

Flange find_flange(const Kinematics& robot, const std::vector<int>& arm) {
  Flange flange;
  const int last = arm.back();
  const Line axis = robot.axis(last);
  // Outwards is away from the preceding joint; if both joints coincide, usually along +axis.
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
