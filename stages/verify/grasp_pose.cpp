#include "stages/verify/grasp_pose.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/frame_poses.hpp"

namespace morphe::verify {
namespace {

constexpr double kSamePlace = 1e-6;

int sample_of_grasp(const Plan& plan) {
  const auto phase = std::ranges::find(plan.movement.phases, PhaseKind::grasp, &Phase::kind);
  if (phase == plan.movement.phases.end()) return -1;
  const std::vector<double>& time = plan.trajectory.demonstration_time;
  const auto begun =
      std::ranges::find_if(time, [&](double time_s) { return time_s >= phase->begin_s; });
  return static_cast<int>(begun == time.end() ? time.size() - 1
                                              : static_cast<std::size_t>(begun - time.begin()));
}

double apart(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

Vec3 tip_point(const RobotTable& robot, const std::vector<Pose>& base_from_frame, std::size_t tip) {
  return in_base(base_from_frame, robot.tips[tip].frame, robot.tips[tip].transform.translation());
}

/// Distance of thumb and index at each sample up to one; none of a hand that lacks either.
std::vector<double> openings(const RobotTable& robot, const Trajectory& trajectory, int last) {
  const auto thumb = std::ranges::find(robot.tips, 0, &RobotTable::Tip::finger);
  const auto index = std::ranges::find(robot.tips, 1, &RobotTable::Tip::finger);
  std::vector<double> found;
  if (thumb == robot.tips.end() || index == robot.tips.end()) return found;
  std::vector<Pose> base_from_frame;
  const auto place = [&](auto tip) {
    return tip_point(robot, base_from_frame, static_cast<std::size_t>(tip - robot.tips.begin()));
  };
  for (int sample = 0; sample <= last; ++sample) {
    frame_poses(robot, trajectory.position.row(sample).transpose(), base_from_frame);
    found.push_back((place(thumb) - place(index)).norm());
  }
  return found;
}

/// How much less open than the widest the stored posture is; infinite where no sample has it.
double less_open(const RobotTable& robot, const Plan& plan) {
  const std::vector<double> wide = openings(robot, plan.trajectory, plan.grasp.sample);
  const double widest = wide.empty() ? 0 : *std::ranges::max_element(wide);
  const std::size_t samples =
      wide.empty() ? 1 : static_cast<std::size_t>(plan.grasp.sample) + 1;  // the first alone
  double least = kInfinity;
  for (std::size_t sample = 0; sample < samples; ++sample) {
    const JointVector way = plan.trajectory.position.row(static_cast<Eigen::Index>(sample));
    const bool same = (way - plan.grasp.pregrasp_posture).cwiseAbs().maxCoeff() <= kSamePlace;
    if (same) least = std::min(least, wide.empty() ? 0 : widest - wide[sample]);
  }
  return least;
}

/// How far the stored direction is from the palm's over its last kApproachLength; 0 if both are
/// unseen.
double off_approach(const RobotTable& robot, const Plan& plan, const Pose& object_from_base) {
  std::vector<Pose> base_from_frame;
  const auto palm = [&](int sample) -> Vec3 {
    frame_poses(robot, plan.trajectory.position.row(sample).transpose(), base_from_frame);
    return in_base(base_from_frame, robot.palm_frame, Vec3::Zero());
  };
  const Vec3 last = palm(plan.grasp.sample);
  int before = plan.grasp.sample - 1;
  while (before >= 0 && (last - palm(before)).norm() < kApproachLength) --before;
  const Vec3& stored = plan.grasp.approach_direction;
  if (before < 0) return stored.array().isNaN().all() ? 0 : kInfinity;
  const Vec3 way = object_from_base.linear() * (last - palm(before));
  return (stored - way / way.norm()).norm();
}

}  // namespace

bool has_grasp(const Plan& plan) {
  return plan.grasp.sample >= 0 ||
         (sample_of_grasp(plan) >= 0 && object_named(plan.scene.objects, plan.movement.target));
}

bool judge_grasp_pose(const RobotTable& robot, const Plan& plan, ViolationRuns& runs) {
  const Grasp& grasp = plan.grasp;
  const auto note = [&](const char* subject, double off) {
    if (!(off <= kSamePlace)) runs.note_plan("grasp", subject, off, kSamePlace);
  };
  const SceneObject* target = object_named(plan.scene.objects, plan.movement.target);
  if (!target) {
    runs.note_plan("grasp", "target", kNotSeen, kNotSeen);
    return false;
  }
  const int sample = sample_of_grasp(plan);
  if (grasp.sample < 0) {
    runs.note_plan("grasp", "missing", grasp.sample, sample);
    return false;
  }
  if (sample != grasp.sample) {
    runs.note_plan("grasp", "sample", grasp.sample, sample);
    return false;
  }
  const auto joints = static_cast<Eigen::Index>(robot.joints());
  if (grasp.tips_in_object.size() != robot.tips.size() || grasp.hand_posture.size() != joints ||
      grasp.pregrasp_posture.size() != joints) {
    runs.note_plan("structure", "grasp", kNotSeen, kNotSeen);
    return false;
  }

  const JointVector q = plan.trajectory.position.row(sample).transpose();
  note("hand_posture", (grasp.hand_posture - q).cwiseAbs().maxCoeff());
  note("pregrasp_posture", less_open(robot, plan));
  const double time_s = plan.trajectory.demonstration_time[static_cast<std::size_t>(grasp.sample)];
  const Pose base_from_object = recorded_pose(*target, time_s);
  note("object_pose", apart(grasp.base_from_object, base_from_object));
  std::vector<Pose> base_from_frame;
  frame_poses(robot, q, base_from_frame);
  const Pose object_from_base = base_from_object.inverse();
  note("wrist_pose_in_object",
       apart(grasp.object_from_palm,
             object_from_base * base_from_frame[static_cast<std::size_t>(robot.palm_frame)]));
  note("approach_direction", off_approach(robot, plan, object_from_base));
  double farthest = 0;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const Vec3 here = object_from_base * tip_point(robot, base_from_frame, tip);
    const double off = (grasp.tips_in_object[tip] - here).norm();
    farthest = off <= farthest ? farthest : off;  // also where it is none
  }
  note("tips_in_object", farthest);
  return true;
}

}  // namespace morphe::verify
