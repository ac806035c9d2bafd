#include "stages/verify/held_drift.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "stages/verify/find_index.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/pad.hpp"

namespace morphe::verify {
namespace {

/// Returns the end of the last transport, or NaN if none begins before the plan's end.
double put_down_s(const Movement& movement) {
  double end_s = kUnknown;
  bool carries = false;
  for (const Phase& phase : movement.phases) {
    if (phase.kind != PhaseKind::transport) continue;
    end_s = phase.end_s;
    carries = carries || phase.begin_s < movement.end_s;
  }
  return carries && !movement.target.empty() ? end_s : kUnknown;
}

/// Returns the angle of a rotation by the length of the chord, |R - 1| = 2 sqrt(2) sin(angle / 2).
double angle_of(const Eigen::Matrix3d& rotation) {
  const double chord = (rotation - Eigen::Matrix3d::Identity()).norm();
  return 2 * std::asin(std::min(1.0, chord / std::sqrt(8.0)));
}

}  // namespace

void recompute_held_drift(const RobotModel& robot, const Plan& plan, Certificate& own) {
  const double end_s = put_down_s(plan.movement);
  const Trajectory& motion = plan.trajectory;
  const int samples = static_cast<int>(motion.time.size());
  if (std::isnan(end_s) || plan.grasp.sample < 0 || plan.grasp.sample >= samples) return;
  const std::vector<PadSphere> pads = pad_spheres(robot);
  std::vector<Pose> base_from_frame;
  for (const PadContact& contact : plan.grasp.contacts) {
    const int tip = find_index(robot.tips, contact.tip, &RobotModel::Tip::name);
    if (contact.state != ContactState::touching || tip < 0 || pads[tip].capsule < 0) continue;
    const auto palm_from_link = [&](int sample) -> Pose {
      frame_poses(robot, motion.position.row(sample).transpose(), base_from_frame);
      return base_from_frame[robot.palm_frame].inverse() * base_from_frame[robot.tips[tip].frame];
    };
    const Pose grasping = palm_from_link(plan.grasp.sample);
    for (int sample = plan.grasp.sample;
         sample < samples && motion.demonstration_time[sample] <= end_s; ++sample) {
      const Pose now = palm_from_link(sample);
      const double moved_m = (now * pads[tip].centre - grasping * pads[tip].centre).norm();
      const double turned = angle_of(grasping.linear().transpose() * now.linear());
      own.held_drift = std::fmax(own.held_drift, moved_m);
      own.held_turn = std::fmax(own.held_turn, turned);
    }
  }
}

}  // namespace morphe::verify
