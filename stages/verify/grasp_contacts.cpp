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

constexpr double kPoint_m = 1e-5, kAxis_m = 2e-5, kDepth_m = 1e-6;
constexpr double kNormal_rad = 1e-3, kPadAngle_rad = 1e-6, kUnit = 1e-6;
constexpr double kStep_m = 1e-6;     ///< of differences of distances
constexpr double kBlended_m = 0.05;  ///< from a person's fingertip to the pad that follows it

/// The target, and distances to it, in its frame.
struct Surface {
  explicit Surface(const SceneObject& target) : object(target) {
    if (object.shape == Shape::mesh) mesh = make_mesh(object);
  }
  double distance(const Segment& segment) const {
    return object.shape == Shape::mesh ? segment_mesh_distance(mesh, segment, kInfinity)
                                       : segment_solid_distance(object, segment, kInfinity);
  }
  double distance(const Vec3& point) const { return distance(Segment{point, point}); }
  /// The way on which the distance grows fastest; not a unit vector where there are several.
  Vec3 outwards(const Vec3& point) const {
    Vec3 way;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = kStep_m * Vec3::Unit(axis);
      way[axis] = (distance(Vec3(point + step)) - distance(Vec3(point - step))) / (2 * kStep_m);
    }
    return way;
  }

  const SceneObject& object;
  Mesh mesh;
};

double angle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

double beside(const Segment& axis, const Vec3& point) {
  return segment_distance(axis, {point, point});
}

bool all_seen(const PadContact& contact) {
  return seen(contact.asked) && seen(contact.point) && seen(contact.normal) &&
         std::isfinite(contact.gap) && std::isfinite(contact.pad_angle);
}

/// How much of a tip's goal is its pad's.
double share_of(const Goals& goals, std::size_t tip, double time_s) {
  if (goals.pad_share.rows == 0) return 0;
  const GoalShare at = goal_share(goals, time_s);
  return std::lerp(goals.pad_share(at.before, tip), goals.pad_share(at.after, tip), at.share);
}

/// How much nearer to and farther from the centre of its ball than its radius a pad may have met
/// the target.
struct Slack {
  double nearer = 0, farther = 0;
};

/// A closing finger may meet it with its capsule beside the ball, and has closed by the frame at or
/// after the grasp.
Slack slack_of_closing(const Goals& goals, std::size_t tip, double time_s,
                       const RobotTable::Capsule& capsule) {
  const GoalShare at = goal_share(goals, time_s);
  const double still_m =
      (goals.tip_position(at.after, tip) - goals.tip_position(at.before, tip)).norm();
  return {still_m, still_m + (capsule.to - capsule.from).norm()};
}

/// Tips whose goals at the grasp are those of pads are the ones that touch, each once; closed are
/// those whose goals are.
void judge_who_touches(const RobotTable& robot, const Plan& plan, ViolationRuns& runs) {
  const Goals& goals = plan.goals;
  const auto sample = static_cast<std::size_t>(plan.grasp.sample);
  const double time_s = plan.trajectory.demonstration_time[sample];
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const bool asked = share_of(goals, tip, time_s) > 0;
    const bool closed = !goals.closed.empty() && goals.closed[tip] != 0;
    int told = 0;
    bool otherwise = false;
    for (const PadContact& contact : plan.grasp.contacts) {
      if (contact.tip != robot.tips[tip].name) continue;
      ++told;
      otherwise = otherwise || (contact.origin == ContactOrigin::closed) != closed;
    }
    if (told != (asked ? 1 : 0))
      runs.note_plan("contact", robot.tips[tip].name + "/missing", told, asked ? 1 : 0);
    if (otherwise) runs.note_plan("contact", robot.tips[tip].name + "/origin", !closed, closed);
  }
}

}  // namespace

bool judge_grasp_contacts(const RobotTable& robot, const Plan& plan, ViolationRuns& runs) {
  const Grasp& grasp = plan.grasp;
  const SceneObject* target = object_named(plan.scene.objects, plan.movement.target);
  if (!target) return false;
  judge_who_touches(robot, plan, runs);
  if (grasp.contacts.empty()) return false;
  const auto sample = static_cast<std::size_t>(grasp.sample);
  const double time_s = plan.trajectory.demonstration_time[sample];
  const Pose object_from_base = recorded_pose(*target, time_s).inverse();
  std::vector<Pose> base_from_frame;
  frame_poses(robot, plan.trajectory.position.row(grasp.sample).transpose(), base_from_frame);
  const std::vector<PadBall> pads = pad_balls(robot);
  const Surface surface(*target);
  bool all_told = true;
  for (const PadContact& contact : grasp.contacts) {
    const auto note = [&](const char* what, double value, double limit) {
      runs.note_plan("contact", contact.tip + "/" + what, value, limit);
    };
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotTable::Tip::name);
    const PadBall pad = tip == robot.tips.end()
                            ? PadBall()
                            : pads[static_cast<std::size_t>(tip - robot.tips.begin())];
    if (pad.capsule < 0 ||
        robot.capsules[static_cast<std::size_t>(pad.capsule)].name != contact.link) {
      note("link", kNotSeen, kNotSeen);
      all_told = false;
      continue;
    }
    if (!(contact.confidence >= 0 && contact.confidence <= 1))
      note("confidence", contact.confidence, 1);
    if (!all_seen(contact)) {
      runs.note_plan("finite", "grasp/contacts/" + contact.tip, kNotSeen, kNotSeen);
      all_told = false;
      continue;
    }
    const RobotTable::Capsule& capsule = robot.capsules[static_cast<std::size_t>(pad.capsule)];
    const auto in_object = [&](const Vec3& point) -> Vec3 {
      return object_from_base * in_base(base_from_frame, capsule.frame, point);
    };
    const Segment axis{in_object(capsule.from), in_object(capsule.to)};
    const auto holds = [&](const char* what, double off, double most) {
      if (!(off <= most)) note(what, off, most);
    };
    holds("asked", std::abs(surface.distance(contact.asked)), kPoint_m);
    holds("point", std::abs(surface.distance(contact.point)), kPoint_m);
    const auto number = static_cast<std::size_t>(tip - robot.tips.begin());
    if (const auto goal = goal_at(plan.goals, number, time_s)) {
      // The pad's ball was to touch there: its centre is its radius away.
      const double off = (object_from_base * *goal - contact.asked).norm() - pad.radius;
      const bool closed = contact.origin == ContactOrigin::closed;
      const Slack slack = closed ? slack_of_closing(plan.goals, number, time_s, capsule) : Slack();
      holds("asked", std::max(-off - slack.nearer, off - slack.farther),
            kPoint_m + kBlended_m * (1 - share_of(plan.goals, number, time_s)));
    }
    const double gap = surface.distance(axis) - capsule.radius;
    if (!(std::abs(contact.gap - gap) <= kPoint_m)) note("gap", contact.gap, gap);
    const double depth = plan.tolerances.contact_depth;
    if (!(gap >= -depth - kDepth_m)) note("penetration", -gap, depth);
    const Vec3 on_axis = contact.point - (capsule.radius + gap) * contact.normal;
    holds("pad", beside(axis, on_axis), kAxis_m);
    const bool unit = std::abs(contact.normal.norm() - 1) <= kUnit;
    holds("normal", unit ? angle(-contact.normal, surface.outwards(on_axis)) : kInfinity,
          kNormal_rad);
    const Vec3 middle = object_from_base.linear() *
                        base_from_frame[static_cast<std::size_t>(tip->frame)].linear() * pad.middle;
    const double turned = angle(middle, contact.normal);
    if (!(std::abs(contact.pad_angle - turned) <= kPadAngle_rad))
      note("pad_angle", contact.pad_angle, turned);
    all_told = all_told && unit;
  }
  return all_told;
}

}  // namespace morphe::verify
