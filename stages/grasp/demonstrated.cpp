#include "stages/grasp/demonstrated.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::grasp {
namespace {

/// A point, or the nearest one that far outside the surface.
Vec3 outside(const collision::Solid& solid, double apart_m, const Vec3& point) {
  const SurfacePoint nearest = nearest_surface(solid, point);
  return nearest.distance < apart_m ? Vec3(nearest.point - apart_m * nearest.normal) : point;
}

}  // namespace

std::vector<Touch> demonstrated_touches(const robot::Robot& robot, const Goals& goals,
                                        const Movement& movement, const collision::Solid& target,
                                        const GraspOptions& options) {
  std::vector<Touch> touches;
  const HoldTime when = hold_time(movement);
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    if (robot.pads[tip].capsule < 0 || robot.tips[tip].finger < 0) continue;
    Vec3 sum = Vec3::Zero();
    double seen_frames = 0, touching = 0, gaps = 0;
    for (std::size_t f = 0; f < goals.frames(); ++f) {
      if (!(goals.time[f] >= when.begin_s && goals.time[f] <= when.end_s)) continue;
      const Vec3& goal = goals.tip_position(f, tip);
      if (!seen(goal)) continue;
      ++seen_frames;
      const Pose object_from_base = recorded_pose(target.object, goals.time[f]).inverse();
      const SurfacePoint nearest = nearest_surface(target, object_from_base * goal);
      const double gap = nearest.distance - options.pad_depth_m;
      if (gap > options.near_m) continue;
      ++touching;
      gaps += std::abs(gap);
      sum += nearest.point;
    }
    if (touching == 0 || touching < options.least_share * seen_frames) continue;
    Touch touch;
    touch.tip = tip;
    touch.confidence = touching / seen_frames * std::exp(-gaps / touching / options.near_m);
    touches.push_back(moved_to(robot, target, sum / touching, touch));
  }
  return touches;
}

Touch moved_to(const robot::Robot& robot, const collision::Solid& target, const Vec3& near,
               Touch touch) {
  const SurfacePoint at = nearest_surface(target, near);
  touch.point = at.point;
  touch.normal = at.normal;
  touch.centre = at.point - robot.pads[touch.tip].radius * at.normal;
  return touch;
}

void make_room(const robot::Robot& robot, const collision::Solid& target, double margin_m,
               std::vector<Touch>& touches) {
  constexpr int kRounds = 50;
  constexpr double kEnough_m = 1e-4;
  bool crowded = true;
  for (int round = 0; round < kRounds && crowded; ++round) {
    crowded = false;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      for (std::size_t j = i + 1; j < touches.size(); ++j) {
        const Vec3 between = touches[j].centre - touches[i].centre;
        const double needed =
            robot.pads[touches[i].tip].radius + robot.pads[touches[j].tip].radius + margin_m;
        const double missing = needed - between.norm();
        if (missing <= kEnough_m || between.norm() == 0) continue;
        crowded = true;
        const Vec3 step = (0.5 * missing / between.norm()) * between;
        const Vec3 first = touches[i].centre - step, second = touches[j].centre + step;
        touches[i] = moved_to(robot, target, first, touches[i]);
        touches[j] = moved_to(robot, target, second, touches[j]);
      }
    }
  }
}

void aim_pads(const robot::Robot& robot, const std::vector<Touch>& touches,
              const Movement& movement, const collision::Solid& target, double aperture_m,
              Goals& goals) {
  if (touches.empty()) return;
  const HoldTime when = hold_time(movement);
  if (goals.pad_share.rows == 0) goals.pad_share = {goals.frames(), robot.tips.size(), 0.0};
  const bool by_palm = !target.object.attached_frame.empty();
  for (const Touch& touch : touches) {
    Vec3 way = Vec3::Zero();  // from tip to pad as the target was taken
    for (std::size_t f = 0; f < goals.frames(); ++f) {
      const double share = closed_share(when, goals.time[f]);
      Vec3& goal = goals.tip_position(f, touch.tip);
      const Pose base_from_target = recorded_pose(target.object, goals.time[f]);
      const bool in_palm = by_palm && goals.time[f] > target.object.attach_s;
      Vec3 pad = base_from_target * touch.centre;
      if (in_palm) {
        pad = goal + way;
      } else if (seen(goal)) {
        way = pad - goal;
      }
      if (share == 0 || (!seen(goal) && share < 1)) continue;
      goal = share < 1 ? Vec3((1 - share) * goal + share * pad) : pad;
      if (share < 1 && !in_palm) {
        const double apart_m =
            std::sqrt(share) * robot.pads[touch.tip].radius + 4 * share * (1 - share) * aperture_m;
        goal = base_from_target * outside(target, apart_m, base_from_target.inverse() * goal);
      }
      goals.pad_share(f, touch.tip) = share;
    }
  }
}

void keep_outside(const robot::Robot& robot, const std::vector<std::size_t>& tips,
                  const Movement& movement, const collision::Solid& target, Goals& goals) {
  const HoldTime when = hold_time(movement);
  for (const std::size_t tip : tips) {
    if (robot.pads[tip].capsule < 0) continue;
    for (std::size_t f = 0; f < goals.frames(); ++f) {
      const double share = closed_share(when, goals.time[f]);
      Vec3& goal = goals.tip_position(f, tip);
      if (share == 0 || !seen(goal)) continue;
      const Pose base_from_target = recorded_pose(target.object, goals.time[f]);
      const Vec3 in_target = base_from_target.inverse() * goal;
      const Vec3 kept = outside(target, std::sqrt(share) * robot.pads[tip].radius, in_target);
      if (kept != in_target) goal = base_from_target * kept;
    }
  }
}

}  // namespace morphe::grasp
