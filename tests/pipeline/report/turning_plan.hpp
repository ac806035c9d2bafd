#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "tests/stages/certify/planar_arm.hpp"

namespace morphe::report {

using certify::ball;

inline constexpr double kAngle = 0.8, kDuration_s = 2;
inline constexpr int kSamples = 401;

/// The arm stretched out turns about its shoulder with minimum jerk.
inline Trajectory minimum_jerk() {
  Trajectory t;
  t.position = t.velocity = t.acceleration = JointRows::Zero(kSamples, 3);
  for (int k = 0; k < kSamples; ++k) {
    const double s = static_cast<double>(k) / (kSamples - 1), T = kDuration_s;
    t.time.push_back(s * T);
    t.demonstration_time.push_back(5 + s * T);
    t.position(k, 0) = kAngle * (10 - 15 * s + 6 * s * s) * s * s * s;
    t.velocity(k, 0) = kAngle / T * 30 * s * s * (1 - s) * (1 - s);
    t.acceleration(k, 0) = kAngle / (T * T) * 60 * s * (1 - s) * (1 - 2 * s);
    t.phase.push_back(s < 0.5 ? PhaseKind::reach : PhaseKind::grasp);
    t.origin.push_back(SampleOrigin::mapped);
    t.clearance.push_back(k == 123 ? 0.01 : 0.02);
  }
  return t;
}

/// Both tips' goals stay where the tips begin, 3 mm above them; the shoulder was 1 m to the left.
inline Plan turning_plan() {
  Plan plan;
  plan.demonstration = "turn";
  plan.reason = Reason::none;
  plan.movement.begin_s = 5;
  plan.movement.end_s = 7;
  plan.movement.phases = {{PhaseKind::reach, 5, 6}, {PhaseKind::grasp, 6, 7}};
  Goals& goals = plan.goals;
  goals.time = {5, 6, 7};
  goals.tip_position = Array2D<Vec3>(3, 2, Vec3::Zero());
  goals.tip_orientation = Array2D<Quat>(3, 2, unknown_rotation());
  goals.reachable = Array2D<std::uint8_t>(3, 2, 1);
  for (std::size_t f = 0; f < 3; ++f) {
    goals.tip_position(f, 0) = Vec3(0.55, 0.04, 0.003);
    goals.tip_position(f, 1) = Vec3(0.55, -0.04, 0.003);
  }
  goals.common_base_offset = Vec3(0, 1, 0);
  goals.shoulder_position.assign(3, Vec3::Zero());
  goals.elbow_position.assign(3, Vec3(0.3, 0, 0.1));
  goals.wrist_position.assign(3, unknown_point());
  goals.wrist_orientation.assign(3, unknown_rotation());
  goals.finger_joint_position = Array2D<Vec3>(3, 5, unknown_point());
  plan.trajectory = minimum_jerk();
  return plan;
}

inline const robot::Robot& arm() {
  static const robot::Robot robot(certify::planar_arm());
  return robot;
}

}  // namespace morphe::report
