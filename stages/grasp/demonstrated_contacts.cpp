#include "stages/grasp/demonstrated_contacts.hpp"

#include <cmath>

namespace morphe::grasp {
namespace {

/// Returns the point, or the one `distance_m` outside the surface above it if it is closer.
Vec3 push_outside(const collision::Solid& solid, double distance_m, const Vec3& point) {
  const SurfacePoint nearest = nearest_surface(solid, point);
  return nearest.distance < distance_m ? Vec3(nearest.point - distance_m * nearest.normal) : point;
}

}  // namespace

std::vector<DesiredContact> demonstrated_contacts(const robot::Robot& robot, const Goals& goals,
                                                  const Movement& movement,
                                                  const collision::Solid& target,
                                                  const GraspOptions& options) {
  std::vector<DesiredContact> touches;
  const HoldInterval hold = hold_interval(movement);
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    if (robot.pads[tip].capsule < 0 || robot.tips[tip].finger < 0) continue;
    Vec3 sum = Vec3::Zero();
    double seen = 0, touching = 0, gaps = 0;
    for (int f = 0; f < std::ssize(goals.time); ++f) {
      if (!(goals.time[f] >= hold.begin_s && goals.time[f] <= hold.end_s)) continue;
      const Vec3& goal = goals.tip_position(f, tip);
      if (!is_known(goal)) continue;
      ++seen;
      const Pose object_from_base = recorded_pose(target.object, goals.time[f]).inverse();
      const SurfacePoint nearest = nearest_surface(target, object_from_base * goal);
      const double gap = nearest.distance - options.pad_depth_m;
      if (gap > options.touch_distance_m) continue;
      ++touching;
      gaps += std::abs(gap);
      sum += nearest.point;
    }
    if (touching == 0 || touching < options.min_contact_share * seen) continue;
    DesiredContact touch;
    touch.tip = tip;
    touch.confidence = touching / seen * std::exp(-gaps / touching / options.touch_distance_m);
    touches.push_back(project_contact(robot, target, sum / touching, touch));
    touches.back().demonstrated = touches.back().point;
  }
  return touches;
}

DesiredContact project_contact(const robot::Robot& robot, const collision::Solid& target,
                               const Vec3& point, DesiredContact touch) {
  const SurfacePoint surface = nearest_surface(target, point);
  touch.point = surface.point;
  touch.normal = surface.normal;
  touch.centre = surface.point - robot.pads[touch.tip].radius * surface.normal;
  return touch;
}

DesiredContact limit_slide(const robot::Robot& robot, const collision::Solid& target,
                           const DesiredContact& touch) {
  constexpr double kRetreatRatio = 0.95;
  const Vec3 slide = touch.point - touch.demonstrated;
  DesiredContact limited = touch;
  for (double share = kMaxSlide_m / slide.norm();
       (limited.point - touch.demonstrated).norm() > kMaxSlide_m; share *= kRetreatRatio)
    limited = project_contact(robot, target, touch.demonstrated + share * slide, touch);
  return limited;
}

void separate_contacts(const robot::Robot& robot, const collision::Solid& target, double margin_m,
                       std::vector<DesiredContact>& touches) {
  bool crowded = true;
  for (int round = 0; round < kMaxSeparationRounds && crowded; ++round) {
    crowded = false;
    for (int i = 0; i < std::ssize(touches); ++i) {
      for (int j = i + 1; j < std::ssize(touches); ++j) {
        const Vec3 between = touches[j].centre - touches[i].centre;
        const double required_m =
            robot.pads[touches[i].tip].radius + robot.pads[touches[j].tip].radius + margin_m;
        const double missing_m = required_m - between.norm();
        if (missing_m <= kOverlapTolerance_m || between.norm() == 0) continue;
        crowded = true;
        const Vec3 step = (0.5 * missing_m / between.norm()) * between;
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
  const HoldInterval hold = hold_interval(movement);
  if (goals.tip_to_pad_share.rows == 0)
    goals.tip_to_pad_share = {goals.frames(), robot.tips.size(), 0.0};
  for (const DesiredContact& touch : touches) {
    if (touch.origin == ContactOrigin::auto_closed) continue;
    const double radius_m = robot.pads[touch.tip].radius;
    for (int f = 0; f < std::ssize(goals.time); ++f) {
      const double share = closing_progress(hold, goals.time[f]);
      const bool leaving = goals.time[f] > hold.opening_s;
      Vec3& goal = goals.tip_position(f, touch.tip);
      if ((share == 0 && !leaving) || (!is_known(goal) && share < 1)) continue;
      const Pose base_from_target = recorded_pose(target.object, goals.time[f]);
      const Vec3 pad = base_from_target * touch.centre;
      goal = share < 1 ? Vec3((1 - share) * goal + share * pad) : pad;
      if (share < 1) {
        const double gap_m =
            leaving ? radius_m + (1 - share) * kLeavingGap_m
                    : std::sqrt(share) * radius_m + 4 * share * (1 - share) * aperture_m;
        goal = base_from_target * push_outside(target, gap_m, base_from_target.inverse() * goal);
      }
      goals.tip_to_pad_share(f, touch.tip) = share;
    }
  }
}

void keep_goals_outside(const robot::Robot& robot, const std::vector<std::size_t>& tips,
                        const Movement& movement, const collision::Solid& target, Goals& goals) {
  const HoldInterval hold = hold_interval(movement);
  for (const std::size_t tip : tips) {
    if (robot.pads[tip].capsule < 0) continue;
    for (int f = 0; f < std::ssize(goals.time); ++f) {
      const double share = closing_progress(hold, goals.time[f]);
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
