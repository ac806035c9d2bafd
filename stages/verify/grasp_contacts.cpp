#include "stages/verify/grasp_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/mesh.hpp"
#include "stages/verify/pad.hpp"
#include "stages/verify/separation.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

constexpr double kSurfaceTolerance_m = 1e-5, kAxisTolerance_m = 2e-5,
                 kPenetrationTolerance_m = 1e-6;
constexpr double kNormalTolerance_rad = 1e-3, kPadAngleTolerance_rad = 1e-6,
                 kUnitNormTolerance = 1e-6;
constexpr double kGradientStep_m = 1e-6;  ///< step of the finite differences of distances
/// greatest distance from a person's fingertip to the pad that follows it
constexpr double kMaxBlendOffset_m = 0.05;

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
  /// Returns the gradient of the distance by central differences; it is not a unit vector at points
  /// where the direction of steepest increase is not unique.
  Vec3 distance_gradient(const Vec3& point) const {
    Vec3 way;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = kGradientStep_m * Vec3::Unit(axis);
      way[axis] =
          (distance(Vec3(point + step)) - distance(Vec3(point - step))) / (2 * kGradientStep_m);
    }
    return way;
  }

  const SceneObject& object;
  Mesh mesh;
};

double angle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

double axis_distance(const Segment& axis, const Vec3& point) {
  return segment_distance(axis, {point, point});
}

bool is_complete(const PadContact& contact) {
  return is_known(contact.desired_point) && is_known(contact.point) && is_known(contact.normal) &&
         std::isfinite(contact.signed_distance) && std::isfinite(contact.pad_angle);
}

/// Returns the share of the pad in a tip's goal at a demonstration time.
double pad_blend_at(const Goals& goals, std::size_t tip, double time_s) {
  if (goals.tip_to_pad_share.rows == 0) return 0;
  const GoalInterpolation at = interpolate_goal_frames(goals, time_s);
  return std::lerp(goals.tip_to_pad_share(at.before, tip), goals.tip_to_pad_share(at.after, tip),
                   at.share);
}

/// The amounts by which the contact may be closer to and farther from the centre of the pad's ball
/// than its radius.
struct PadDistanceTolerance {
  double nearer = 0, farther = 0;
};

/// Returns the tolerance of a closing finger, which may touch with its capsule beside the ball and
/// is closed by the frame at or after the grasp.
PadDistanceTolerance closing_tolerance(const Goals& goals, std::size_t tip, double time_s,
                                       const RobotModel::Capsule& capsule) {
  const GoalInterpolation at = interpolate_goal_frames(goals, time_s);
  const double still_m =
      (goals.tip_position(at.after, tip) - goals.tip_position(at.before, tip)).norm();
  return {still_m, still_m + (capsule.to - capsule.from).norm()};
}

/// Checks that exactly the tips whose goals at the grasp are those of pads have a contact, one
/// each, and that contacts are marked closed if the tips' goals are.
void verify_contact_tips(const RobotModel& robot, const Plan& plan, ViolationCollector& runs) {
  const Goals& goals = plan.goals;
  const auto sample = static_cast<std::size_t>(plan.grasp.sample);
  const double time_s = plan.trajectory.demonstration_time[sample];
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const bool asked = pad_blend_at(goals, tip, time_s) > 0;
    const bool closed = !goals.auto_closed.empty() && goals.auto_closed[tip] != 0;
    int told = 0;
    bool otherwise = false;
    for (const PadContact& contact : plan.grasp.contacts) {
      if (contact.tip != robot.tips[tip].name) continue;
      ++told;
      otherwise = otherwise || (contact.origin == ContactOrigin::auto_closed) != closed;
    }
    if (told != (asked ? 1 : 0))
      runs.note_plan("contact", robot.tips[tip].name + "/missing", told, asked ? 1 : 0);
    if (otherwise) runs.note_plan("contact", robot.tips[tip].name + "/origin", !closed, closed);
  }
}

}  // namespace

bool verify_grasp_contacts(const RobotModel& robot, const Plan& plan, ViolationCollector& runs) {
  const Grasp& grasp = plan.grasp;
  const SceneObject* target = find_object(plan.scene.objects, plan.movement.target);
  if (!target) return false;
  verify_contact_tips(robot, plan, runs);
  if (grasp.contacts.empty()) return false;
  const auto sample = static_cast<std::size_t>(grasp.sample);
  const double time_s = plan.trajectory.demonstration_time[sample];
  const Pose object_from_base = recorded_pose(*target, time_s).inverse();
  std::vector<Pose> base_from_frame;
  frame_poses(robot, plan.trajectory.position.row(grasp.sample).transpose(), base_from_frame);
  const std::vector<PadSphere> pads = pad_spheres(robot);
  const TargetSurface surface(*target);
  bool all_told = true;
  for (const PadContact& contact : grasp.contacts) {
    const auto note = [&](const char* what, double value, double limit) {
      runs.note_plan("contact", contact.tip + "/" + what, value, limit);
    };
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotModel::Tip::name);
    const PadSphere pad = tip == robot.tips.end() ? PadSphere() : pads[tip - robot.tips.begin()];
    if (pad.capsule < 0 || robot.capsules[pad.capsule].name != contact.link) {
      note("link", kUnknown, kUnknown);
      all_told = false;
      continue;
    }
    if (!(contact.confidence >= 0 && contact.confidence <= 1))
      note("confidence", contact.confidence, 1);
    if (!is_complete(contact)) {
      runs.note_plan("finite", "grasp/contacts/" + contact.tip, kUnknown, kUnknown);
      all_told = false;
      continue;
    }
    const RobotModel::Capsule& capsule = robot.capsules[pad.capsule];
    const auto in_object = [&](const Vec3& point) -> Vec3 {
      return object_from_base * to_base_frame(base_from_frame, capsule.frame, point);
    };
    const Segment axis{in_object(capsule.from), in_object(capsule.to)};
    const auto holds = [&](const char* what, double off, double most) {
      if (!(off <= most)) note(what, off, most);
    };
    holds("desired_point", std::abs(surface.distance(contact.desired_point)), kSurfaceTolerance_m);
    holds("point", std::abs(surface.distance(contact.point)), kSurfaceTolerance_m);
    const auto number = static_cast<std::size_t>(tip - robot.tips.begin());
    if (const auto goal = goal_at(plan.goals, number, time_s)) {
      // The pad's ball was to touch there, so that its centre is at the distance of its radius.
      const double off = (object_from_base * *goal - contact.desired_point).norm() - pad.radius;
      const bool closed = contact.origin == ContactOrigin::auto_closed;
      const PadDistanceTolerance slack =
          closed ? closing_tolerance(plan.goals, number, time_s, capsule) : PadDistanceTolerance();
      holds(
          "desired_point", std::max(-off - slack.nearer, off - slack.farther),
          kSurfaceTolerance_m + kMaxBlendOffset_m * (1 - pad_blend_at(plan.goals, number, time_s)));
    }
    const double gap = surface.distance(axis) - capsule.radius;
    if (!(std::abs(contact.signed_distance - gap) <= kSurfaceTolerance_m))
      note("signed_distance", contact.signed_distance, gap);
    const double depth = plan.tolerances.max_penetration;
    if (!(gap >= -depth - kPenetrationTolerance_m)) note("penetration", -gap, depth);
    const Vec3 on_axis = contact.point - (capsule.radius + gap) * contact.normal;
    holds("pad", axis_distance(axis, on_axis), kAxisTolerance_m);
    const bool unit = std::abs(contact.normal.norm() - 1) <= kUnitNormTolerance;
    holds("normal", unit ? angle(-contact.normal, surface.distance_gradient(on_axis)) : kInfinity,
          kNormalTolerance_rad);
    const Vec3 middle =
        object_from_base.linear() * base_from_frame[tip->frame].linear() * pad.pad_normal;
    const double turned = angle(middle, contact.normal);
    if (!(std::abs(contact.pad_angle - turned) <= kPadAngleTolerance_rad))
      note("pad_angle", contact.pad_angle, turned);
    all_told = all_told && unit;
  }
  return all_told;
}

}  // namespace morphe::verify
