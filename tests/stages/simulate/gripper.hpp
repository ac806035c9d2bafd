#pragma once

#include <cmath>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::simulate {

/// A palm that slides along z, with two fingers of 80 mm that lie along x, 120 mm apart, and turn
/// towards each other: the thumb by negative values, the index by positive ones.
inline RobotModel gripper_table() {
  RobotModel robot;
  robot.name = "gripper";
  robot.joint_names = {"lift", "thumb", "index"};
  robot.lower = Eigen::Vector3d(-0.2, -1, -1);
  robot.upper = Eigen::Vector3d(0.5, 1, 1);
  robot.velocity = robot.acceleration = robot.jerk = JointVector::Constant(3, 10);
  const auto at = [](double x, double y, double z) { return Pose(Eigen::Translation3d(x, y, z)); };
  robot.frames = {{"palm", -1, at(0, 0, 0.1), Vec3::UnitZ(), 0, 1, 0, true},
                  {"thumb", 0, at(0, 0.06, 0), Vec3::UnitZ(), 1, 1, 0},
                  {"index", 0, at(0, -0.06, 0), Vec3::UnitZ(), 2, 1, 0}};
  robot.tips = {{"thumb_tip", 1, at(0.08, 0, 0), 0}, {"index_tip", 2, at(0.08, 0, 0), 1}};
  const Vec3 end(0.08, 0, 0);
  robot.capsules = {{"palm", 0, Vec3(-0.05, 0.03, 0), Vec3(-0.05, -0.03, 0), 0.02, true},
                    {"thumb", 1, Vec3::Zero(), end, 0.01, true},
                    {"index", 2, Vec3::Zero(), end, 0.01, true}};
  robot.allowed_collision_pairs = {{0, 1}, {0, 2}};
  return robot;
}

inline const robot::Robot& gripper() {
  static const robot::Robot robot(gripper_table());
  return robot;
}

inline SceneObject standing(const std::string& name, Shape shape, std::vector<double> size,
                            const Vec3& at) {
  SceneObject object;
  object.name = name;
  object.shape = shape;
  object.size = std::move(size);
  object.time = {0};
  object.position = {at};
  object.orientation = {Quat::Identity()};
  return object;
}

/// The palm comes down by 50 mm in 0.5 s while the fingers close by 0.1 rad, 10 mm from a cup whose
/// middle is between their tips.
inline Plan cup_plan() {
  Plan plan;
  plan.demonstration = "cup";
  plan.reason = Reason::none;
  plan.movement.target = "cup";
  plan.movement.phases = {{PhaseKind::reach, 0, 0.3}, {PhaseKind::grasp, 0.3, 0.5}};
  plan.scene.objects = {standing("cup", Shape::cylinder, {0.03, 0.1}, Vec3(0.08, 0, 0.1)),
                        standing("table", Shape::box, {1, 1, 0.02}, Vec3(0, 0, 0.04))};
  plan.reference_frames.base_from_world = Pose::Identity();
  plan.goals.time = {0};
  plan.goals.tip_position = Array2D<Vec3>(1, 2, Vec3::Zero());
  Trajectory& t = plan.trajectory;
  constexpr int kSamples = 51;
  t.position = t.velocity = t.acceleration = JointRows::Zero(kSamples, 3);
  const Eigen::RowVector3d from(0.05, 0, 0), way(-0.05, -0.1, 0.1);
  for (int k = 0; k < kSamples; ++k) {
    const double s = static_cast<double>(k) / (kSamples - 1), T = 0.5;
    t.time.push_back(s * T);
    t.demonstration_time.push_back(s * T);
    t.position.row(k) = from + way * (10 - 15 * s + 6 * s * s) * s * s * s;
    t.velocity.row(k) = way / T * 30 * s * s * (1 - s) * (1 - s);
    t.acceleration.row(k) = way / (T * T) * 60 * s * (1 - s) * (1 - 2 * s);
    t.phase.push_back(s < 0.6 ? PhaseKind::reach : PhaseKind::grasp);
    t.origin.push_back(SampleOrigin::mapped);
    t.clearance.push_back(0.01);
  }
  plan.grasp.sample = 30;
  plan.grasp.base_from_object = Pose(Eigen::Translation3d(0.08, 0, 0.1));
  plan.grasp.grasp_posture = t.position.row(30).transpose();
  return plan;
}

/// A squeeze of 5 N by each of the two, with the fingers where they touch.
inline void add_squeeze(Plan& plan) {
  PadContact thumb, index, silent;
  thumb.tip = "thumb_tip";
  thumb.point = Vec3(0, 0.03, 0);
  thumb.normal = Vec3(0, -1, 0);
  thumb.normal_force = index.normal_force = 5;
  index.tip = silent.tip = "index_tip";
  index.point = Vec3(0, -0.03, 0);
  index.normal = Vec3(0, 1, 0);
  plan.grasp.contacts = {thumb, index, silent};
  const double closed = std::asin(0.02 / 0.08);  // the tips' axes 40 mm from the cup's
  plan.grasp.grasp_posture = Eigen::Vector3d(0, -closed, closed);
  plan.grasp.grasp_torque = Eigen::Vector3d(0, -0.4, 0.4);
  plan.grasp.servo_target = plan.grasp.grasp_posture + plan.grasp.grasp_torque / 10;
}

}  // namespace morphe::simulate
