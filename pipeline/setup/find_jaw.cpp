#include "pipeline/setup/find_jaw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/robot/tree.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

// All chosen by hand, for jaws of hobby arms: the fixed jaw of an SO-101 reaches as far as the
// moving one, a wrist's housing half as far as a hand.
constexpr double kMinFixedReach = 0.6;  ///< of the fixed jaw, relative to the moving one
constexpr double kMinJawLength_m = 0.015;
constexpr double kMinOutwardsCosine = 0.5;  ///< to the fixed jaw: within 60 degrees
constexpr double kMinAcross = 0.5;          ///< sine between axis and arm: 30 degrees
constexpr double kFixedEndDepth_m = 0.01;   ///< of the fixed jaw's end, whose points are averaged
constexpr double kMaxSideways_m = 0.03;     ///< of the fixed jaw beside the plane of the moving one
constexpr double kMaxBeyond_rad = 0.6;      ///< by which a range may go on behind the fixed jaw
constexpr double kMaxGap_m = 0.02;          ///< of sliding jaws at the closed end of their range
constexpr double kMaxApart_rad = 0.8;       ///< of the jaws at the closed end of their range

/// A moving jaw in front of the body that carries it, at rest in the base frame.
struct Setting {
  const Kinematics& robot;
  int moving = -1;
  Line axis;
  Vec3 origin = Vec3::Zero();  ///< on the axis, beside the jaw's end
  Vec3 end = Vec3::Zero();     ///< of the jaw
  /// Away from the arm, perpendicular to the axis; shorter than 1 if the axis is along the arm.
  Vec3 outwards = Vec3::Zero();
  bool slides = false;
};

/// Returns the frame nearest above that moves `frame` by another joint, -1 = the base.
int carrying_frame(const Kinematics& robot, int frame) {
  return robot::moving_frame_of(robot.table(), robot.frame(frame).parent);
}

/// Returns the direction from the nearest joint that is at least kFar_m away to the jaw's.
Vec3 away_from_arm(const Kinematics& robot, int moving) {
  constexpr double kFar_m = 0.05;
  const Vec3 here = robot.pose(moving).translation();
  for (int f = carrying_frame(robot, moving); f >= 0; f = carrying_frame(robot, f)) {
    const Vec3 away = here - robot.pose(f).translation();
    if (away.norm() > kFar_m) return away.normalized();
  }
  const Vec3 from_root = here - robot.pose(0).translation();
  return from_root.norm() > 1e-3 ? Vec3(from_root.normalized()) : Vec3(Vec3::Zero());
}

Setting setting_of(const Kinematics& robot, const Finger& jaw, const BodyPoints& points) {
  Setting setting{robot, jaw.frames.back(), robot.axis(jaw.frames.back()), {}, {}, {}, false};
  setting.slides = robot.frame(setting.moving).prismatic;
  const Vec3 joint = robot.pose(setting.moving).translation();
  const BodyPoint end = body_end(robot, jaw, points, joint);
  setting.end = end.at(robot.base_from_frame);
  setting.origin = setting.slides ? joint : project_onto_line(setting.axis, setting.end);
  setting.outwards =
      perpendicular_part(away_from_arm(robot, setting.moving), setting.axis.direction);
  if (setting.outwards.norm() > kMinAcross) setting.outwards.normalize();
  return setting;
}

/// Returns how far a point is in front of the jaw's joint: its distance from the axis, or along
/// `outwards` for a sliding jaw; -infinity for points behind the joint or beside the jaw.
double reach_of(const Setting& setting, const Vec3& point) {
  const Vec3 from_joint = point - setting.origin;
  const double outwards_m = from_joint.dot(setting.outwards);
  if (setting.slides) return outwards_m;
  const double sideways_m = (point - setting.end).dot(setting.axis.direction);
  const double radius_m = perpendicular_part(from_joint, setting.axis.direction).norm();
  const bool in_front = outwards_m > kMinOutwardsCosine * radius_m;
  return in_front && std::abs(sideways_m) < kMaxSideways_m ? radius_m : -HUGE_VAL;
}

/// The frames fixed to the carrying body and their points: of shapes, or else their origins.
std::vector<std::pair<int, Vec3>> carried_points(const Setting& setting, const BodyPoints& points) {
  const Kinematics& robot = setting.robot;
  const int carrier = carrying_frame(robot, setting.moving);
  std::vector<std::pair<int, Vec3>> shaped, bare;
  for (int f = std::max(carrier, 0); f < std::ssize(robot.table().frames); ++f) {
    if (robot::moving_frame_of(robot.table(), f) != carrier) continue;
    bare.emplace_back(f, robot.pose(f).translation());
    if (const auto own = points.find(f); own != points.end())
      for (const Vec3& point : own->second) shaped.emplace_back(f, robot.pose(f) * point);
  }
  return shaped.empty() ? bare : shaped;
}

/// Returns the angle about the axis from one direction to another, both from the setting's origin.
double angle_between(const Setting& setting, const Vec3& from, const Vec3& to) {
  const Vec3 a = perpendicular_part(from - setting.origin, setting.axis.direction),
             b = perpendicular_part(to - setting.origin, setting.axis.direction);
  return std::atan2(a.cross(b).dot(setting.axis.direction), a.dot(b));
}

/// Returns the range of the jaw's joint from rest: below (negative) and above, through its
/// coupling.
std::array<double, 2> range_from_rest(const Kinematics& robot, int moving) {
  const RobotModel::Frame& frame = robot.frame(moving);
  const double rest = robot.rest[frame.joint];
  const double a = frame.ratio * (robot.table().lower[frame.joint] - rest),
               b = frame.ratio * (robot.table().upper[frame.joint] - rest);
  return {std::min(a, b), std::max(a, b)};
}

/// Returns true if the jaw comes to the fixed one at an end of its range.
bool closes_at_an_end(const Setting& setting, const Vec3& fixed) {
  const auto [below, above] = range_from_rest(setting.robot, setting.moving);
  if (setting.slides) {
    const double gap_m = (fixed - setting.end).dot(setting.axis.direction);
    return std::abs(gap_m - (gap_m < 0 ? below : above)) < kMaxGap_m;
  }
  const double angle = angle_between(setting, setting.end, fixed);
  const auto ends_there = [&](double end, double toward) {
    const double beyond = toward * (end - angle);  // negative: it ends before the fixed jaw
    return beyond > -kMaxApart_rad && beyond < kMaxBeyond_rad;
  };
  return ends_there(below, -1) != ends_there(above, 1);
}

}  // namespace

bool named_as_gripper(const Kinematics& robot, int frame) {
  static constexpr std::array<std::string_view, 6> kWords = {"gripper", "jaw",  "claw",
                                                             "finger",  "grip", "pinch"};
  const std::string names = lower_case(robot.frame(frame).name + " " + robot.link[frame]);
  return std::ranges::any_of(
      kWords, [&](std::string_view word) { return names.find(word) != std::string::npos; });
}

std::optional<BodyPoint> farthest_beside(const Kinematics& robot, const Finger& jaw,
                                         const BodyPoints& points) {
  const Setting setting = setting_of(robot, jaw, points);
  if (setting.outwards.norm() < 1 - 1e-9) return std::nullopt;  // it turns or slides along the arm
  const auto carried = carried_points(setting, points);
  double farthest_m = 0;
  int frame = -1;
  for (const auto& [f, point] : carried) {
    if (reach_of(setting, point) <= farthest_m) continue;
    farthest_m = reach_of(setting, point);
    frame = f;
  }
  if (frame < 0) return std::nullopt;
  std::vector<Vec3> end;
  for (const auto& [f, point] : carried)
    if (f == frame && reach_of(setting, point) > farthest_m - kFixedEndDepth_m)
      end.push_back(point);
  const auto sure = points.contains(frame) ? Provenance::derived : Provenance::read;
  return BodyPoint{frame, robot.pose(frame).inverse() * mean_of(end), sure};
}

std::optional<BodyPoint> find_fixed_jaw(const Kinematics& robot, const Finger& jaw,
                                        const BodyPoints& points) {
  const std::optional<BodyPoint> fixed = farthest_beside(robot, jaw, points);
  if (!fixed) return std::nullopt;
  const Setting setting = setting_of(robot, jaw, points);
  const Vec3 end = fixed->at(robot.base_from_frame);
  const double length_m =
      setting.slides ? reach_of(setting, setting.end) : (setting.end - setting.origin).norm();
  if (length_m < kMinJawLength_m || reach_of(setting, end) < kMinFixedReach * length_m)
    return std::nullopt;
  if (!closes_at_an_end(setting, end) && !named_as_gripper(robot, setting.moving))
    return std::nullopt;
  return fixed;
}

}  // namespace morphe::setup
