#include "pipeline/study/grasp_measures.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "stages/grasp/demonstrated_contacts.hpp"
#include "stages/grasp/measure.hpp"
#include "stages/grasp/quality.hpp"

namespace morphe::study {
namespace {

double angle_between_vectors(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Measures the finger of a tip at the point of the target nearest to its pad.
RobotFinger measure_finger(const collision::CollisionWorld& world, const Plan& plan, int tip) {
  const robot::Robot& robot = *world.robot;
  const double time_s = plan.trajectory.demonstration_time[plan.grasp.sample];
  const JointVector q = plan.trajectory.position.row(plan.grasp.sample).transpose();
  RobotFinger finger;
  if (robot.pads[tip].capsule >= 0) {
    grasp::DesiredContact desired;
    desired.tip = tip;
    const PadContact contact = grasp::measure_contacts(world, {desired}, q, time_s).front();
    finger.contact_point = contact.point;
    finger.gap = contact.signed_distance;
    finger.pad_angle = contact.pad_angle;
  }
  std::vector<Pose> frames;
  robot::forward_kinematics(robot, q, frames);
  const Pose object_from_base = plan.grasp.base_from_object.inverse();
  finger.tip = object_from_base * robot::tracked_point(robot, frames, tip, 0);
  finger.pad = object_from_base * robot::tracked_point(robot, frames, tip, 1);
  const auto centre = std::ranges::find(robot.tip_of_centre, tip);
  if (centre == robot.tip_of_centre.end()) return finger;
  const RobotModel::JointCentre& joint = robot.joint_centres[centre - robot.tip_of_centre.begin()];
  finger.middle_joint = object_from_base * frames[joint.frame].translation();
  return finger;
}

}  // namespace

ContactError contact_error(const KnownContact& known, const RobotFinger& finger) {
  ContactError error;
  error.distance = (finger.contact_point - known.point).norm();
  error.pad_angle = finger.pad_angle;
  error.gap = finger.gap;
  error.precision = ((finger.tip - known.point) - (known.tip - known.point)).norm();
  error.pad_precision = ((finger.pad - known.point) - (known.tip - known.point)).norm();
  error.alignment =
      angle_between_vectors(finger.tip - finger.middle_joint, known.tip - known.middle_joint);
  return error;
}

Penetration deepest_penetration(const collision::CollisionWorld& world,
                                const Trajectory& trajectory) {
  Penetration deepest;
  if (world.target < 0) return deepest;
  const robot::Robot& robot = *world.robot;
  collision::CollisionScratch scratch;
  for (Eigen::Index i = 0; i < trajectory.position.rows(); ++i) {
    const JointVector q = trajectory.position.row(i).transpose();
    collision::update_bodies(world, q, trajectory.demonstration_time[i], scratch);
    for (int c = 0; c < std::ssize(robot.capsules); ++c) {
      const double depth_m =
          -collision::capsule_solid(scratch.bodies[c], collision::solid_at(world, world.target),
                                    scratch.object_poses[world.target])
               .distance;
      double& deepest_m = robot::is_pad(robot, c) ? deepest.pads_m : deepest.other_links_m;
      deepest_m = std::max(deepest_m, depth_m);
    }
  }
  return deepest;
}

std::optional<int> tip_of_finger(const RobotModel& robot, int finger) {
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    const double share = robot.tips[tip].finger_curve_share;
    const bool at_finger = std::isnan(share) || share == 0 || share == 1;
    if (robot.tips[tip].finger == finger && at_finger) return tip;
  }
  return std::nullopt;
}

GraspScore score_grasp(const robot::Robot& robot, const Plan& plan,
                       const std::vector<KnownContact>& known) {
  GraspScore score;
  score.executable = plan.executable();
  score.has_trajectory = plan.has_trajectory();
  if (!score.has_trajectory) return score;
  score.humanlikeness = plan.certificate.humanlikeness_final;
  score.duration_s = plan.trajectory.time.back();
  collision::CollisionWorld world =
      collision::make_world(robot, plan.scene, plan.movement, plan.tolerances);
  collision::attach_target(plan.trajectory.demonstration_time, plan.trajectory.position, world);
  score.penetration = deepest_penetration(world, plan.trajectory);
  for (const PadContact& contact : plan.grasp.contacts) {
    const bool closed = contact.origin == ContactOrigin::auto_closed;
    const bool touches = contact.state == ContactState::touching;
    ++(closed ? score.closed : score.demonstrated);
    if (touches) ++(closed ? score.closed_touching : score.touching);
  }
  if (plan.grasp.sample < 0) return score;
  for (const KnownContact& contact : known) {
    const std::optional<int> tip = tip_of_finger(robot, contact.finger);
    if (tip) score.errors.push_back(contact_error(contact, measure_finger(world, plan, *tip)));
  }
  return score;
}

int count_demonstrated_contacts(const robot::Robot& robot, const Plan& fingertip_plan,
                                const grasp::GraspOptions& options) {
  const Movement& movement = fingertip_plan.movement;
  const SceneObject* target = find_object(fingertip_plan.scene.objects, movement.target);
  if (!target) return 0;
  const auto mesh = collision::mesh_solid_of(*target, {});
  return static_cast<int>(grasp::demonstrated_contacts(robot, fingertip_plan.goals, movement,
                                                       {*target, mesh.get()}, options)
                              .size());
}

}  // namespace morphe::study
