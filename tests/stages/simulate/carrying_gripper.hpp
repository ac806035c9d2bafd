#pragma once

#include "tests/stages/simulate/gripper.hpp"

namespace morphe::simulate {

/// A palm that slides along x and z, with two parallel fingers 100 mm apart that close along y by
/// positive values. The pads are upright capsules of 40 mm and 8 mm radius.
inline RobotModel carrying_gripper_table() {
  RobotModel robot;
  robot.name = "carrying_gripper";
  robot.joint_names = {"carry", "lift", "thumb", "index"};
  robot.lower = Eigen::Vector4d(-0.1, 0, -0.01, -0.01);
  robot.upper = Eigen::Vector4d(0.8, 0.8, 0.05, 0.05);
  robot.velocity = robot.acceleration = robot.jerk = JointVector::Constant(4, 10);
  const auto at = [](double y) { return Pose(Eigen::Translation3d(0, y, 0)); };
  robot.frames = {{"slide", -1, at(0), Vec3::UnitX(), 0, 1, 0, true},
                  {"palm", 0, at(0), Vec3::UnitZ(), 1, 1, 0, true},
                  {"thumb", 1, at(0.05), -Vec3::UnitY(), 2, 1, 0, true},
                  {"index", 1, at(-0.05), Vec3::UnitY(), 3, 1, 0, true}};
  robot.palm_frame = 1;
  robot.tips = {{"thumb_tip", 2, Pose::Identity(), 0}, {"index_tip", 3, Pose::Identity(), 1}};
  const Vec3 lower(0, 0, -0.02), upper(0, 0, 0.02);
  robot.capsules = {{"palm", 1, Vec3(0, 0.03, 0.09), Vec3(0, -0.03, 0.09), 0.015, true},
                    {"thumb", 2, lower, upper, 0.008, true},
                    {"index", 3, lower, upper, 0.008, true}};
  robot.allowed_collision_pairs = {{0, 1}, {0, 2}};
  return robot;
}

inline const robot::Robot& carrying_gripper() {
  static const robot::Robot robot(carrying_gripper_table());
  return robot;
}

/// A posture of the carrying gripper at a time; the fingers' joints are equal.
struct Waypoint {
  double time_s, x, z, closing;
};

/// Fills a trajectory that passes the waypoints at rest, along minimum-jerk curves.
inline void follow_waypoints(const std::vector<Waypoint>& ways, Trajectory& t) {
  constexpr double kStep_s = 0.01;
  const auto count = static_cast<Eigen::Index>(std::lround(ways.back().time_s / kStep_s)) + 1;
  t.position = t.velocity = t.acceleration = JointRows::Zero(count, 4);
  std::size_t piece = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double time_s = kStep_s * static_cast<double>(k);
    while (piece + 2 < ways.size() && time_s > ways[piece + 1].time_s + 1e-9) ++piece;
    const Waypoint &a = ways[piece], &b = ways[piece + 1];
    const double T = b.time_s - a.time_s, s = std::min(1.0, (time_s - a.time_s) / T);
    const Eigen::RowVector4d from(a.x, a.z, a.closing, a.closing);
    const Eigen::RowVector4d way = Eigen::RowVector4d(b.x, b.z, b.closing, b.closing) - from;
    t.position.row(k) = from + way * (10 - 15 * s + 6 * s * s) * s * s * s;
    t.velocity.row(k) = way / T * 30 * s * s * (1 - s) * (1 - s);
    t.acceleration.row(k) = way / (T * T) * 60 * s * (1 - s) * (1 - 2 * s);
    t.time.push_back(time_s);
    t.demonstration_time.push_back(time_s);
    t.origin.push_back(SampleOrigin::mapped);
    t.clearance.push_back(0.01);
  }
}

/// Height of the palm, and of the middle of a block of 80 mm between its fingers, if the block
/// stands on the table.
inline constexpr double kBlockHeight_m = 0.14;

/// The gripper takes a block of 40 x 40 x 80 mm from x = 0.3 at 0.8 s, carries it 200 mm along x
/// and 100 mm high, and releases it at 2.8 s with its middle at release_z_m. Until 3.1 s it opens,
/// and until 3.8 s it rises. It squeezes with 10 N.
inline Plan carrying_plan(double take_z_m = kBlockHeight_m, double release_z_m = kBlockHeight_m) {
  Plan plan;
  plan.demonstration = "block";
  plan.reason = Reason::none;
  plan.movement.target = "block";
  plan.movement.end_s = 3.8;
  plan.movement.phases = {{PhaseKind::reach, 0, 0.5},
                          {PhaseKind::grasp, 0.5, 0.8},
                          {PhaseKind::transport, 0.8, 2.8},
                          {PhaseKind::return_phase, 2.8, 3.8}};
  constexpr double kOpen = 0, kNear = 0.020, kHigh_m = kBlockHeight_m + 0.1;
  const double high_m = std::max(kHigh_m, release_z_m);
  Trajectory& t = plan.trajectory;
  follow_waypoints({{0, 0.3, take_z_m + 0.1, kOpen},
                    {0.5, 0.3, take_z_m, kOpen},
                    {0.8, 0.3, take_z_m, kNear},
                    {1.4, 0.3, high_m, kNear},
                    {2.2, 0.5, high_m, kNear},
                    {2.8, 0.5, release_z_m, kNear},
                    {3.1, 0.5, release_z_m, kOpen},
                    {3.8, 0.5, high_m + 0.1, kOpen}},
                   t);
  SceneObject block = standing("block", Shape::box, {0.04, 0.04, 0.08}, Vec3(0.3, 0, take_z_m));
  block.attach_s = 0.8;
  block.release_s = 2.8;
  block.time.clear();
  block.position.clear();
  block.orientation.clear();
  for (std::size_t k = 0; k < t.samples(); ++k) {
    t.phase.push_back(phase_at(plan.movement.phases, t.time[k]));
    if (t.time[k] < 0.8 - 1e-9 || t.time[k] > 2.8 + 1e-9) continue;
    const auto row = static_cast<Eigen::Index>(k);
    block.time.push_back(t.time[k]);
    block.position.emplace_back(t.position(row, 0), 0, t.position(row, 1));
    block.orientation.push_back(Quat::Identity());
  }
  plan.scene.objects = {block, standing("table", Shape::box, {1, 1, 0.02}, Vec3(0.3, 0, 0.09))};
  plan.reference_frames.base_from_world = Pose::Identity();
  plan.goals.time = {0};
  plan.goals.tip_position = Array2D<Vec3>(1, 2, Vec3::Zero());
  plan.grasp.sample = 51;
  plan.grasp.base_from_object = Pose(Eigen::Translation3d(0.3, 0, take_z_m));
  plan.grasp.grasp_posture = Eigen::Vector4d(0.3, take_z_m, 0.022, 0.022);
  plan.grasp.grasp_torque = Eigen::Vector4d(0, 0, 10, 10);
  plan.grasp.servo_target = plan.grasp.grasp_posture;
  PadContact thumb, index;
  thumb.tip = "thumb_tip";
  thumb.point = Vec3(0, 0.02, 0);
  thumb.normal = Vec3(0, -1, 0);
  index.tip = "index_tip";
  index.point = Vec3(0, -0.02, 0);
  index.normal = Vec3(0, 1, 0);
  thumb.normal_force = index.normal_force = 10;
  plan.grasp.contacts = {thumb, index};
  return plan;
}

}  // namespace morphe::simulate
