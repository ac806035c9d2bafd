#include "stages/verify/grasp_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stages/verify/find_index.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/grasp_held.hpp"
#include "stages/verify/mesh.hpp"
#include "stages/verify/pad.hpp"
#include "stages/verify/separation.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

constexpr double kSurfaceTolerance_m = 1e-5, kAxisTolerance_m = 2e-5;
constexpr double kPenetrationTolerance_m = 1e-6, kUnitNormTolerance = 1e-6;
constexpr double kNormalTolerance_rad = 1e-3, kPadAngleTolerance_rad = 1e-6;
constexpr double kGradientStep_m = 1e-6;  ///< of the finite differences of distances
/// The greatest distance from the person's fingertip to the pad while a goal is between the two.
constexpr double kMaxBlendOffset_m = 0.05;

/// The contact's definition: largest gap, and largest angle between pad and surface.
constexpr double kMaxContactGap_m = 2e-4, kMaxContactAngle_rad = 60 * kRadPerDegree;
constexpr double kMaxSlide_m = 0.015;  ///< from where the person touched

/// The target's surface, with distances in the target's frame.
struct TargetSurface {
  explicit TargetSurface(const SceneObject& target) : object(target) {
    if (object.shape == Shape::mesh) mesh = make_mesh(object);
  }
  double distance(const Segment& segment) const {
    return object.shape == Shape::mesh ? segment_mesh_distance(mesh, segment, kInfinity)
                                       : segment_solid_distance(object, segment, kInfinity);
  }
  double distance(const Vec3& point) const { return distance(Segment{point, point}); }
  /// Returns the distance's gradient by central differences; shorter than 1 where it is not unique.
  Vec3 distance_gradient(const Vec3& point) const {
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = kGradientStep_m * Vec3::Unit(axis);
      const Vec3 after = point + step, before = point - step;
      gradient[axis] = (distance(after) - distance(before)) / (2 * kGradientStep_m);
    }
    return gradient;
  }

  const SceneObject& object;
  Mesh mesh;
};

double angle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

bool is_complete(const PadContact& contact) {
  return is_known(contact.desired_point) && is_known(contact.point) && is_known(contact.normal) &&
         std::isfinite(contact.signed_distance) && std::isfinite(contact.pad_angle);
}

/// Returns tip_to_pad_share of a tip at a demonstration time; 0 if the goals do not have it.
double pad_share_at(const Goals& goals, int tip, double time_s) {
  if (goals.tip_to_pad_share.rows == 0) return 0;
  const auto [before, after, share] = interpolate_goal_frames(goals, time_s);
  return std::lerp(goals.tip_to_pad_share(before, tip), goals.tip_to_pad_share(after, tip), share);
}

/// Returns by how much the distance from desired_point to the tip's goal may be less and more than
/// the pad's radius. The goal of an automatically closed finger moves until the frame after the
/// grasp, and the finger may touch with its whole capsule.
std::pair<double, double> distance_tolerances(const Plan& plan, const PadContact& contact, int tip,
                                              double time_s, const RobotModel::Capsule& capsule) {
  if (contact.origin != ContactOrigin::auto_closed) return {0, 0};
  const auto [before, after, share] = interpolate_goal_frames(plan.goals, time_s);
  const Array2D<Vec3>& goal = plan.goals.tip_position;
  const double goal_motion_m = (goal(after, tip) - goal(before, tip)).norm();
  return {goal_motion_m, goal_motion_m + (capsule.to - capsule.from).norm()};
}

ContactState state_of(const PadContact& contact) {
  const bool touching =
      contact.signed_distance <= kMaxContactGap_m && contact.pad_angle <= kMaxContactAngle_rad;
  return touching ? ContactState::touching : ContactState::near;
}

/// Returns by how much the point that the person touched is off the surface, or the desired one too
/// far from it; 0 for a finger that closed by itself, which has no such point.
double demonstrated_point_error(const PadContact& contact, const TargetSurface& surface) {
  if (contact.origin == ContactOrigin::auto_closed)
    return contact.demonstrated_point.array().isNaN().all() ? 0 : kInfinity;
  const double slide_m = (contact.desired_point - contact.demonstrated_point).norm();
  return std::max(std::abs(surface.distance(contact.demonstrated_point)), slide_m - kMaxSlide_m);
}

/// Checks that each tip has one contact if its goal at the grasp applies to its pad, else no
/// contact, and that contacts are marked as closed automatically if the tips' goals are.
void verify_contact_tips(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  const Goals& goals = plan.goals;
  const double time_s = plan.trajectory.demonstration_time[plan.grasp.sample];
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    const std::string& name = robot.tips[tip].name;
    const int required = pad_share_at(goals, tip, time_s) > 0 ? 1 : 0;
    const bool closed = !goals.auto_closed.empty() && goals.auto_closed[tip] != 0;
    int count = 0;
    bool wrong_origin = false;
    for (const PadContact& contact : plan.grasp.contacts) {
      if (contact.tip != name) continue;
      ++count;
      wrong_origin = wrong_origin || (contact.origin == ContactOrigin::auto_closed) != closed;
    }
    if (count != required) violations.note_plan("contact", name + "/missing", count, required);
    if (wrong_origin) violations.note_plan("contact", name + "/origin", !closed, closed);
  }
}

}  // namespace

bool verify_grasp_contacts(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  const Grasp& grasp = plan.grasp;
  const SceneObject* target = find_object(plan.scene.objects, plan.movement.target);
  if (!target) return false;
  verify_contact_tips(robot, plan, violations);
  verify_held(robot, plan, violations);
  if (grasp.contacts.empty()) return false;
  const double time_s = plan.trajectory.demonstration_time[grasp.sample];
  const Pose object_from_base = recorded_pose(*target, time_s).inverse();
  std::vector<Pose> base_from_frame;
  frame_poses(robot, plan.trajectory.position.row(grasp.sample).transpose(), base_from_frame);
  const std::vector<PadSphere> pads = pad_spheres(robot);
  const TargetSurface surface(*target);
  bool all_complete = true;
  for (const PadContact& contact : grasp.contacts) {
    const auto note = [&](const char* property, double value, double limit) {
      violations.note_plan("contact", contact.tip + "/" + property, value, limit);
    };
    const auto check = [&](const char* property, double deviation, double tolerance) {
      if (!(deviation <= tolerance)) note(property, deviation, tolerance);
    };
    const int tip = find_index(robot.tips, contact.tip, &RobotModel::Tip::name);
    const PadSphere pad = tip < 0 ? PadSphere() : pads[tip];
    if (pad.capsule < 0 || robot.capsules[pad.capsule].name != contact.link) {
      note("link", kUnknown, kUnknown);
      all_complete = false;
      continue;
    }
    if (!(contact.confidence >= 0 && contact.confidence <= 1))
      note("confidence", contact.confidence, 1);
    if (!is_complete(contact)) {
      violations.note_plan("finite", "grasp/contacts/" + contact.tip, kUnknown, kUnknown);
      all_complete = false;
      continue;
    }
    const RobotModel::Capsule& capsule = robot.capsules[pad.capsule];
    const auto in_object = [&](const Vec3& point) -> Vec3 {
      return object_from_base * to_base_frame(base_from_frame, capsule.frame, point);
    };
    const Segment axis{in_object(capsule.from), in_object(capsule.to)};
    check("desired_point", std::abs(surface.distance(contact.desired_point)), kSurfaceTolerance_m);
    check("point", std::abs(surface.distance(contact.point)), kSurfaceTolerance_m);
    check("demonstrated_point", demonstrated_point_error(contact, surface), kSurfaceTolerance_m);
    if (const auto goal = goal_at(plan.goals, tip, time_s)) {
      // The pad's sphere was to touch there, so that its centre is at the distance of its radius.
      const double excess = (object_from_base * *goal - contact.desired_point).norm() - pad.radius;
      const auto [nearer, farther] = distance_tolerances(plan, contact, tip, time_s, capsule);
      check("desired_point", std::max(-excess - nearer, excess - farther),
            kSurfaceTolerance_m + kMaxBlendOffset_m * (1 - pad_share_at(plan.goals, tip, time_s)));
    }
    const double signed_distance = surface.distance(axis) - capsule.radius;
    if (!(std::abs(contact.signed_distance - signed_distance) <= kSurfaceTolerance_m))
      note("signed_distance", contact.signed_distance, signed_distance);
    const double max_depth = plan.tolerances.max_penetration;
    if (!(signed_distance >= -max_depth - kPenetrationTolerance_m))
      note("penetration", -signed_distance, max_depth);
    const Vec3 on_axis = contact.point - (capsule.radius + signed_distance) * contact.normal;
    check("pad", segment_distance(axis, {on_axis, on_axis}), kAxisTolerance_m);
    const bool unit = std::abs(contact.normal.norm() - 1) <= kUnitNormTolerance;
    check("normal", unit ? angle(-contact.normal, surface.distance_gradient(on_axis)) : kInfinity,
          kNormalTolerance_rad);
    const Vec3 pad_normal = object_from_base.linear() *
                            base_from_frame[robot.tips[tip].frame].linear() * pad.pad_normal;
    const double pad_angle = angle(pad_normal, contact.normal);
    if (!(std::abs(contact.pad_angle - pad_angle) <= kPadAngleTolerance_rad))
      note("pad_angle", contact.pad_angle, pad_angle);
    if (contact.state != state_of(contact)) note("state", kUnknown, kUnknown);
    all_complete = all_complete && unit;
  }
  return all_complete;
}

}  // namespace morphe::verify
