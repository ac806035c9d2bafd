#include "stages/verify/grasp_pose.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/find_index.hpp"
#include "stages/verify/frame_poses.hpp"

namespace morphe::verify {
namespace {

constexpr double kGraspPoseTolerance = 1e-6;

/// Returns the first sample at or after the begin of the phase grasp, the last one if there is no
/// such sample, -1 without a grasp.
int grasp_sample(const Plan& plan) {
  const auto phase = std::ranges::find(plan.movement.phases, PhaseKind::grasp, &Phase::kind);
  if (phase == plan.movement.phases.end()) return -1;
  const std::vector<double>& time = plan.trajectory.demonstration_time;
  int sample = 0;
  while (sample + 1 < std::ssize(time) && !(time[sample] >= phase->begin_s)) ++sample;
  return sample;
}

double pose_difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

Vec3 tip_position(const RobotModel& robot, const std::vector<Pose>& base_from_frame, int tip) {
  const RobotModel::Tip& own = robot.tips[tip];
  return to_base_frame(base_from_frame, own.frame, own.transform.translation());
}

/// Returns the distance from thumb to index at each sample up to `last`; empty without both.
std::vector<double> grip_apertures(const RobotModel& robot, const Trajectory& motion, int last) {
  const int thumb = find_index(robot.tips, 0, &RobotModel::Tip::finger);
  const int index = find_index(robot.tips, 1, &RobotModel::Tip::finger);
  if (thumb < 0 || index < 0) return {};
  std::vector<double> apertures;
  std::vector<Pose> base_from_frame;
  for (int sample = 0; sample <= last; ++sample) {
    frame_poses(robot, motion.position.row(sample).transpose(), base_from_frame);
    const Vec3 thumb_tip = tip_position(robot, base_from_frame, thumb);
    apertures.push_back((thumb_tip - tip_position(robot, base_from_frame, index)).norm());
  }
  return apertures;
}

/// Returns the difference between the widest aperture and that of the stored pregrasp posture;
/// infinity if no sample has this posture. Without thumb and index it must be the first sample's.
double aperture_deficit(const RobotModel& robot, const Plan& plan) {
  std::vector<double> apertures = grip_apertures(robot, plan.trajectory, plan.grasp.sample);
  if (apertures.empty()) apertures = {0};
  const double widest = *std::ranges::max_element(apertures);
  double least_deficit = kInfinity;
  for (int sample = 0; sample < std::ssize(apertures); ++sample) {
    const JointVector position = plan.trajectory.position.row(sample);
    if ((position - plan.grasp.pregrasp_posture).cwiseAbs().maxCoeff() <= kGraspPoseTolerance)
      least_deficit = std::min(least_deficit, widest - apertures[sample]);
  }
  return least_deficit;
}

/// Returns the deviation of the stored approach direction from the direction of the palm's way over
/// the last kApproachLength_m before the grasp; 0 if both are unknown.
double approach_direction_error(const RobotModel& robot, const Plan& plan,
                                const Pose& object_from_base) {
  std::vector<Pose> base_from_frame;
  const auto palm_at = [&](int sample) -> Vec3 {
    frame_poses(robot, plan.trajectory.position.row(sample).transpose(), base_from_frame);
    return to_base_frame(base_from_frame, robot.palm_frame, Vec3::Zero());
  };
  const Vec3 palm_at_grasp = palm_at(plan.grasp.sample);
  int before = plan.grasp.sample - 1;
  while (before >= 0 && (palm_at_grasp - palm_at(before)).norm() < kApproachLength_m) --before;
  const Vec3& stored = plan.grasp.approach_direction;
  if (before < 0) return stored.array().isNaN().all() ? 0 : kInfinity;
  const Vec3 displacement = object_from_base.linear() * (palm_at_grasp - palm_at(before));
  return (stored - displacement / displacement.norm()).norm();
}

}  // namespace

bool has_grasp(const Plan& plan) {
  return plan.grasp.sample >= 0 ||
         (grasp_sample(plan) >= 0 && find_object(plan.scene.objects, plan.movement.target));
}

bool verify_grasp_pose(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  const Grasp& grasp = plan.grasp;
  const auto check = [&](const char* subject, double deviation) {
    if (!(deviation <= kGraspPoseTolerance))
      violations.note_plan("grasp", subject, deviation, kGraspPoseTolerance);
  };
  const SceneObject* target = find_object(plan.scene.objects, plan.movement.target);
  if (!target) {
    violations.note_plan("grasp", "target", kUnknown, kUnknown);
    return false;
  }
  const int sample = grasp_sample(plan);
  if (sample != grasp.sample) {
    violations.note_plan("grasp", grasp.sample < 0 ? "missing" : "sample", grasp.sample, sample);
    return false;
  }
  const Eigen::Index joints = std::ssize(robot.joint_names);
  if (grasp.tips_in_object.size() != robot.tips.size() || grasp.grasp_posture.size() != joints ||
      grasp.pregrasp_posture.size() != joints) {
    violations.note_plan("structure", "grasp", kUnknown, kUnknown);
    return false;
  }

  const JointVector q = plan.trajectory.position.row(sample).transpose();
  check("grasp_posture", (grasp.grasp_posture - q).cwiseAbs().maxCoeff());
  check("pregrasp_posture", aperture_deficit(robot, plan));
  const Pose base_from_object = recorded_pose(*target, plan.trajectory.demonstration_time[sample]);
  check("object_pose", pose_difference(grasp.base_from_object, base_from_object));
  std::vector<Pose> base_from_frame;
  frame_poses(robot, q, base_from_frame);
  const Pose object_from_base = base_from_object.inverse();
  const Pose object_from_palm = object_from_base * base_from_frame[robot.palm_frame];
  check("palm_pose_in_object", pose_difference(grasp.object_from_palm, object_from_palm));
  check("approach_direction", approach_direction_error(robot, plan, object_from_base));
  double farthest = 0;
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    const Vec3 own = object_from_base * tip_position(robot, base_from_frame, tip);
    const double distance = (grasp.tips_in_object[tip] - own).norm();
    farthest = distance <= farthest ? farthest : distance;  // the comparison keeps NaN
  }
  check("tips_in_object", farthest);
  return true;
}

}  // namespace morphe::verify
