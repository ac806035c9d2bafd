#include "stages/verify/grasp_pose.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/frame_poses.hpp"

namespace morphe::verify {
namespace {

constexpr double kGraspPoseTolerance = 1e-6;

int grasp_sample(const Plan& plan) {
  const auto phase = std::ranges::find(plan.movement.phases, PhaseKind::grasp, &Phase::kind);
  if (phase == plan.movement.phases.end()) return -1;
  const std::vector<double>& time = plan.trajectory.demonstration_time;
  const auto begun =
      std::ranges::find_if(time, [&](double time_s) { return time_s >= phase->begin_s; });
  return static_cast<int>(begun == time.end() ? time.size() - 1
                                              : static_cast<std::size_t>(begun - time.begin()));
}

double pose_difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

Vec3 tip_point(const RobotModel& robot, const std::vector<Pose>& base_from_frame, std::size_t tip) {
  return to_base_frame(base_from_frame, robot.tips[tip].frame,
                       robot.tips[tip].transform.translation());
}

/// Returns the distance between thumb and index at each sample up to `last`; empty for a hand that
/// lacks one of them.
std::vector<double> grip_apertures(const RobotModel& robot, const Trajectory& trajectory,
                                   int last) {
  const auto thumb = std::ranges::find(robot.tips, 0, &RobotModel::Tip::finger);
  const auto index = std::ranges::find(robot.tips, 1, &RobotModel::Tip::finger);
  std::vector<double> found;
  if (thumb == robot.tips.end() || index == robot.tips.end()) return found;
  std::vector<Pose> base_from_frame;
  const auto place = [&](auto tip) {
    return tip_point(robot, base_from_frame, tip - robot.tips.begin());
  };
  for (int sample = 0; sample <= last; ++sample) {
    frame_poses(robot, trajectory.position.row(sample).transpose(), base_from_frame);
    found.push_back((place(thumb) - place(index)).norm());
  }
  return found;
}

/// Returns the difference between the widest aperture and that of the stored posture; infinite if
/// no sample has this posture.
double aperture_deficit(const RobotModel& robot, const Plan& plan) {
  const std::vector<double> wide = grip_apertures(robot, plan.trajectory, plan.grasp.sample);
  const double widest = wide.empty() ? 0 : *std::ranges::max_element(wide);
  const std::size_t samples =
      wide.empty() ? 1 : static_cast<std::size_t>(plan.grasp.sample) + 1;  // only the first sample
  double least = kInfinity;
  for (std::size_t sample = 0; sample < samples; ++sample) {
    const JointVector way = plan.trajectory.position.row(sample);
    const bool same =
        (way - plan.grasp.pregrasp_posture).cwiseAbs().maxCoeff() <= kGraspPoseTolerance;
    if (same) least = std::min(least, wide.empty() ? 0 : widest - wide[sample]);
  }
  return least;
}

/// Returns the deviation of the stored approach direction from the palm's direction over its last
/// kApproachLength_m; 0 if both are unseen.
double approach_direction_error(const RobotModel& robot, const Plan& plan,
                                const Pose& object_from_base) {
  std::vector<Pose> base_from_frame;
  const auto palm = [&](int sample) -> Vec3 {
    frame_poses(robot, plan.trajectory.position.row(sample).transpose(), base_from_frame);
    return to_base_frame(base_from_frame, robot.palm_frame, Vec3::Zero());
  };
  const Vec3 last = palm(plan.grasp.sample);
  int before = plan.grasp.sample - 1;
  while (before >= 0 && (last - palm(before)).norm() < kApproachLength_m) --before;
  const Vec3& stored = plan.grasp.approach_direction;
  if (before < 0) return stored.array().isNaN().all() ? 0 : kInfinity;
  const Vec3 way = object_from_base.linear() * (last - palm(before));
  return (stored - way / way.norm()).norm();
}

}  // namespace

bool has_grasp(const Plan& plan) {
  return plan.grasp.sample >= 0 ||
         (grasp_sample(plan) >= 0 && find_object(plan.scene.objects, plan.movement.target));
}

bool verify_grasp_pose(const RobotModel& robot, const Plan& plan, ViolationCollector& runs) {
  const Grasp& grasp = plan.grasp;
  const auto note = [&](const char* subject, double off) {
    if (!(off <= kGraspPoseTolerance)) runs.note_plan("grasp", subject, off, kGraspPoseTolerance);
  };
  const SceneObject* target = find_object(plan.scene.objects, plan.movement.target);
  if (!target) {
    runs.note_plan("grasp", "target", kUnknown, kUnknown);
    return false;
  }
  const int sample = grasp_sample(plan);
  if (grasp.sample < 0) {
    runs.note_plan("grasp", "missing", grasp.sample, sample);
    return false;
  }
  if (sample != grasp.sample) {
    runs.note_plan("grasp", "sample", grasp.sample, sample);
    return false;
  }
  const auto joints = static_cast<Eigen::Index>(robot.joints());
  if (grasp.tips_in_object.size() != robot.tips.size() || grasp.grasp_posture.size() != joints ||
      grasp.pregrasp_posture.size() != joints) {
    runs.note_plan("structure", "grasp", kUnknown, kUnknown);
    return false;
  }

  const JointVector q = plan.trajectory.position.row(sample).transpose();
  note("grasp_posture", (grasp.grasp_posture - q).cwiseAbs().maxCoeff());
  note("pregrasp_posture", aperture_deficit(robot, plan));
  const double time_s = plan.trajectory.demonstration_time[grasp.sample];
  const Pose base_from_object = recorded_pose(*target, time_s);
  note("object_pose", pose_difference(grasp.base_from_object, base_from_object));
  std::vector<Pose> base_from_frame;
  frame_poses(robot, q, base_from_frame);
  const Pose object_from_base = base_from_object.inverse();
  note("palm_pose_in_object",
       pose_difference(grasp.object_from_palm,
                       object_from_base * base_from_frame[robot.palm_frame]));
  note("approach_direction", approach_direction_error(robot, plan, object_from_base));
  double farthest = 0;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const Vec3 here = object_from_base * tip_point(robot, base_from_frame, tip);
    const double off = (grasp.tips_in_object[tip] - here).norm();
    farthest = off <= farthest ? farthest : off;  // the comparison keeps NaN
  }
  note("tips_in_object", farthest);
  return true;
}

}  // namespace morphe::verify
