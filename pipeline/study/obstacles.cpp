#include "pipeline/study/obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/collision/world.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::study {
namespace {

constexpr int kMaxObstacleDraws = 40;

/// The plan in whose way an obstacle is put, and the random numbers. Results are in the world
/// frame.
struct ObstacleData {
  const robot::Robot& robot;
  const Plan& plan;
  const Pose& world_from_base;
  std::mt19937_64 random;

  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(random() >> 11) * 0x1p-53;
  }
  Vec3 horizontal_direction() {
    const double angle = uniform(0, 2 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle), 0};
  }
  /// Returns world_from_frame of all frames of the robot in a row of the path.
  std::vector<Pose> poses_at(Eigen::Index row) const {
    std::vector<Pose> frames;
    robot::forward_kinematics(robot, plan.path.position.row(row).transpose(), frames);
    for (Pose& frame : frames) frame = world_from_base * frame;
    return frames;
  }
  Eigen::Index last_row() const { return plan.path.position.rows() - 1; }
  /// Draws a row from a part of the path up to a row.
  Eigen::Index row_before(Eigen::Index end, double from_share, double to_share) {
    return static_cast<Eigen::Index>(uniform(from_share, to_share) * static_cast<double>(end));
  }
  Vec3 world_position(const SceneObject& object) const {
    return world_from_base * object.position.front();
  }
};

scene::ConfiguredObject make_obstacle(const std::string& shape, std::vector<double> size,
                                      const Vec3& position) {
  scene::ConfiguredObject object;
  object.name = "obstacle";
  object.shape = shape;
  object.size = std::move(size);
  object.position = position;
  object.avoid_in_mapping = false;
  return object;
}

scene::ConfiguredObject ball_at_elbow(ObstacleData& data) {
  constexpr double kRadius_m = 0.05;
  const int elbow_frame = data.robot.joint_centres.front().frame;
  double arm_radius_m = 0;
  for (const RobotModel::Capsule& capsule : data.robot.capsules) {
    if (capsule.frame == elbow_frame) arm_radius_m = std::max(arm_radius_m, capsule.radius);
  }
  const std::vector<Pose> frames = data.poses_at(data.row_before(data.last_row(), 0.3, 0.7));
  const double distance_m = arm_radius_m + kRadius_m - data.uniform(0.005, 0.025);
  return make_obstacle(
      "sphere", {kRadius_m},
      frames[elbow_frame].translation() + distance_m * data.horizontal_direction());
}

scene::ConfiguredObject post_before_palm(ObstacleData& data) {
  constexpr double kRadius_m = 0.015, kLength_m = 0.3;
  const std::vector<Pose> frames = data.poses_at(data.row_before(grasp_row(data.plan), 0.35, 0.65));
  const Vec3 palm = frames[data.robot.palm_frame].translation();
  const Vec3 aside = data.uniform(0, 0.04) * data.horizontal_direction();
  return make_obstacle("cylinder", {kRadius_m, kLength_m},
                       palm + aside + Vec3(0, 0, data.uniform(-0.1, 0.05)));
}

scene::ConfiguredObject box_at_target(ObstacleData& data, const SceneObject& target) {
  constexpr double kHalfDiagonal_m = 0.028;  // of the box's base
  const std::vector<double> size = {0.04, 0.04, 0.12};
  const Vec3 centre = data.world_position(target);
  const double bottom = centre.z() - target.size.back() / 2;
  const double distance_m = target.size.front() + kHalfDiagonal_m + data.uniform(0.01, 0.06);
  Vec3 position = centre + distance_m * data.horizontal_direction();
  position.z() = bottom + size[2] / 2 + 0.001;
  return make_obstacle("box", size, position);
}

scene::ConfiguredObject board_above_target(ObstacleData& data, const SceneObject& target) {
  const std::vector<double> size = {0.4, 0.2, 0.02};
  const std::vector<Pose> frames = data.poses_at(grasp_row(data.plan));
  double hand_top = -kInfinity;
  for (const RobotModel::Capsule& capsule : data.robot.capsules) {
    if (!robot::is_in_subtree(data.robot, capsule.frame, data.robot.palm_frame)) continue;
    const Pose& pose = frames[capsule.frame];
    for (const Vec3& end : {capsule.from, capsule.to})
      hand_top = std::max(hand_top, (pose * end).z() + capsule.radius);
  }
  Vec3 away = data.world_position(target) - data.world_from_base.translation();
  away.z() = 0;
  away.normalize();
  Vec3 position = data.world_position(target) + (size[1] / 2 - data.uniform(0, 0.04)) * away;
  position.z() = hand_top + size[2] / 2 + data.uniform(0.01, 0.04);
  scene::ConfiguredObject board = make_obstacle("box", size, position);
  board.rpy.z() = std::atan2(-away.x(), away.y());
  return board;
}

/// Returns true if the path is clear of the obstacle in its first posture and not in a later one.
bool blocks_path(ObstacleData& data, const scene::ConfiguredObject& obstacle) {
  SceneObject object;
  object.name = obstacle.name;
  object.shape = enum_from_name<Shape>(obstacle.shape).value_or(Shape::box);
  object.size = obstacle.size;
  object.time = {0};
  const Pose base_from_world = data.world_from_base.inverse();
  object.position = {base_from_world * obstacle.position};
  object.orientation = {
      Quat(base_from_world.linear() *
           Eigen::AngleAxisd(obstacle.rpy.z(), Vec3::UnitZ()).toRotationMatrix())};
  Scene scene;
  scene.objects = {object};
  const collision::CollisionWorld world =
      collision::make_world(data.robot, scene, data.plan.movement, data.plan.tolerances);
  collision::CollisionScratch scratch;
  const JointRows& rows = data.plan.path.position;
  // The obstacle is the only object: the robot's collisions with itself are not of interest here.
  const auto is_clear = [&](Eigen::Index row) {
    const double time_s = data.plan.path.demonstration_time[row];
    std::vector<collision::PairSeparation> too_close;  // slack below 0
    collision::near_pairs(world, rows.row(row).transpose(), time_s, 0, scratch, too_close);
    return std::ranges::none_of(too_close, &collision::PairSeparation::other_is_object);
  };
  if (!is_clear(0)) return false;
  for (Eigen::Index row = 1; row < rows.rows(); ++row) {
    if (!is_clear(row)) return true;
  }
  return false;
}

}  // namespace

Eigen::Index grasp_row(const Plan& plan) {
  const std::vector<double>& times = plan.path.demonstration_time;
  const auto grasp = std::ranges::find(plan.movement.phases, PhaseKind::grasp,
                                       [](const Phase& p) { return p.kind; });
  const Eigen::Index last = plan.path.position.rows() - 1;
  if (grasp == plan.movement.phases.end()) return last;
  return std::min(last, std::ranges::lower_bound(times, grasp->begin_s) - times.begin());
}

std::optional<scene::ConfiguredObject> draw_blocking_obstacle(const robot::Robot& robot,
                                                              const Plan& plan,
                                                              const Pose& world_from_base,
                                                              const std::string& kind,
                                                              std::uint64_t seed) {
  ObstacleData data{robot, plan, world_from_base, std::mt19937_64(seed)};
  const SceneObject* target = find_object(plan.scene.objects, plan.movement.target);
  const bool needs_target = kind == "object" || kind == "shelf";
  if (needs_target && (!target || target->shape != Shape::cylinder)) return std::nullopt;
  for (int draw = 0; draw < kMaxObstacleDraws; ++draw) {
    const scene::ConfiguredObject obstacle = kind == "elbow"    ? ball_at_elbow(data)
                                             : kind == "reach"  ? post_before_palm(data)
                                             : kind == "object" ? box_at_target(data, *target)
                                                                : board_above_target(data, *target);
    if (blocks_path(data, obstacle)) return obstacle;
  }
  return std::nullopt;
}

}  // namespace morphe::study
