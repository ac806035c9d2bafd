#include "stages/grasp/demonstrated_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::grasp {
namespace {

/// Returns the point, or the nearest point at distance `apart_m` outside the surface if it is
/// closer.
Vec3 push_outside(const collision::Solid& solid, double apart_m, const Vec3& point) {
  const SurfacePoint nearest = nearest_surface(solid, point);
  return nearest.distance < apart_m ? Vec3(nearest.point - apart_m * nearest.normal) : point;
}

}  // namespace

std::vector<DesiredContact> demonstrated_contacts(const robot::Robot& robot, const Goals& goals,
                                                  const Movement& movement,
                                                  const collision::Solid& target,
                                                  const GraspOptions& options) {
  std::vector<DesiredContact> touches;
  const HoldInterval when = hold_interval(movement);
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    if (robot.pads[tip].capsule < 0 || robot.tips[tip].finger < 0) continue;
    Vec3 sum = Vec3::Zero();
    double seen_frames = 0, touching = 0, gaps = 0;
    for (std::size_t f = 0; f < goals.frames(); ++f) {
      if (!(goals.time[f] >= when.begin_s && goals.time[f] <= when.end_s)) continue;
      const Vec3& goal = goals.tip_position(f, tip);
      if (!is_known(goal)) continue;
      ++seen_frames;
      const Pose object_from_base = recorded_pose(target.object, goals.time[f]).inverse();
      const SurfacePoint nearest = nearest_surface(target, object_from_base * goal);
      const double gap = nearest.distance - options.pad_depth_m;
      if (gap > options.touch_distance_m) continue;
      ++touching;
      gaps += std::abs(gap);
      sum += nearest.point;
    }
    if (touching == 0 || touching < options.min_contact_share * seen_frames) continue;
    DesiredContact touch;
    touch.tip = tip;
    touch.confidence =
        touching / seen_frames * std::exp(-gaps / touching / options.touch_distance_m);
    touches.push_back(project_contact(robot, target, sum / touching, touch));
  }
  return touches;
}

DesiredContact project_contact(const robot::Robot& robot, const collision::Solid& target,
                               const Vec3& near, DesiredContact touch) {
  const SurfacePoint at = nearest_surface(target, near);
  touch.point = at.point;
  touch.normal = at.normal;
  touch.centre = at.point - robot.pads[touch.tip].radius * at.normal;
  return touch;
}

void separate_contacts(const robot::Robot& robot, const collision::Solid& target, double margin_m,
                       std::vector<DesiredContact>& touches) {
  constexpr int kMaxRounds = 50;
  constexpr double kOverlapTolerance_m = 1e-4;
  bool crowded = true;
  for (int round = 0; round < kMaxRounds && crowded; ++round) {
    crowded = false;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      for (std::size_t j = i + 1; j < touches.size(); ++j) {
        const Vec3 between = touches[j].centre - touches[i].centre;
        const double needed =
            robot.pads[touches[i].tip].radius + robot.pads[touches[j].tip].radius + margin_m;
        const double missing = needed - between.norm();
        if (missing <= kOverlapTolerance_m || between.norm() == 0) continue;
        crowded = true;
        const Vec3 step = (0.5 * missing / between.norm()) * between;
        const Vec3 first = touches[i].centre - step, second = touches[j].centre + step;
        touches[i] = project_contact(robot, target, first, touches[i]);
        touches[j] = project_contact(robot, target, second, touches[j]);
      }
    }
  }
}

void set_pad_goals(const robot::Robot& robot, const std::vector<DesiredContact>& touches,
                   const Movement& movement, const collision::Solid& target, double aperture_m,
                   Goals& goals) {
  if (touches.empty()) return;
  const HoldInterval when = hold_interval(movement);
  if (goals.tip_to_pad_share.rows == 0)
    goals.tip_to_pad_share = {goals.frames(), robot.tips.size(), 0.0};
  const bool by_palm = !target.object.attached_frame.empty();
  for (const DesiredContact& touch : touches) {
    Vec3 way = Vec3::Zero();  // offset from tip to pad when the target was taken
    for (std::size_t f = 0; f < goals.frames(); ++f) {
      const double share = closing_progress(when, goals.time[f]);
      Vec3& goal = goals.tip_position(f, touch.tip);
      const Pose base_from_target = recorded_pose(target.object, goals.time[f]);
      const bool in_palm = by_palm && goals.time[f] > target.object.attach_s;
      Vec3 pad = base_from_target * touch.centre;
      if (in_palm) {
        pad = goal + way;
      } else if (is_known(goal)) {
        way = pad - goal;
      }
      if (share == 0 || (!is_known(goal) && share < 1)) continue;
      goal = share < 1 ? Vec3((1 - share) * goal + share * pad) : pad;
      if (share < 1 && !in_palm) {
        const double apart_m =
            std::sqrt(share) * robot.pads[touch.tip].radius + 4 * share * (1 - share) * aperture_m;
        goal = base_from_target * push_outside(target, apart_m, base_from_target.inverse() * goal);
      }
      goals.tip_to_pad_share(f, touch.tip) = share;
    }
  }
}

void keep_goals_outside(const robot::Robot& robot, const std::vector<std::size_t>& tips,
                        const Movement& movement, const collision::Solid& target, Goals& goals) {
  const HoldInterval when = hold_interval(movement);
  for (const std::size_t tip : tips) {
    if (robot.pads[tip].capsule < 0) continue;
    for (std::size_t f = 0; f < goals.frames(); ++f) {
      const double share = closing_progress(when, goals.time[f]);
      Vec3& goal = goals.tip_position(f, tip);
      if (share == 0 || !is_known(goal)) continue;
      const Pose base_from_target = recorded_pose(target.object, goals.time[f]);
      const Vec3 in_target = base_from_target.inverse() * goal;
      const Vec3 kept = push_outside(target, std::sqrt(share) * robot.pads[tip].radius, in_target);
      if (kept != in_target) goal = base_from_target * kept;
    }
  }
}

}  // namespace morphe::grasp
