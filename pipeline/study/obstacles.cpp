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

constexpr int kMaxObstacleSamples = 40;

/// The data by which an obstacle is placed, in the world frame (z up).
struct ObstacleSite {
  const robot::Robot& robot;
  const Plan& plan;
  const Pose& world_from_base;
  std::mt19937_64 random;

  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(random() >> 11) * 0x1p-53;
  }
  Vec3 level_direction() {
    const double angle = uniform(0, 2 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle), 0};
  }
  std::vector<Pose> frames_at(double share) const {
    const double last = static_cast<double>(plan.path.position.rows() - 1);
    std::vector<Pose> frames;
    robot::forward_kinematics(
        robot, plan.path.position.row(static_cast<Eigen::Index>(share * last)).transpose(), frames);
    for (Pose& frame : frames) frame = world_from_base * frame;
    return frames;
  }
  /// Returns the share of the path at which the grasp begins, 1 if there is no grasp.
  double grasp_share() const {
    const auto& times = plan.path.demonstration_time;
    for (const Phase& phase : plan.movement.phases) {
      if (phase.kind != PhaseKind::grasp) continue;
      const auto found = std::lower_bound(times.begin(), times.end(), phase.begin_s);
      return static_cast<double>(found - times.begin()) / static_cast<double>(times.size());
    }
    return 1;
  }
  const SceneObject* object(const std::string& name) const {
    return find_object(plan.scene.objects, name);
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

scene::ConfiguredObject sphere_at_elbow(ObstacleSite& site) {
  constexpr double kRadius_m = 0.05;
  const int elbow = site.robot.joint_centres.front().frame;
  double arm = 0;
  for (const RobotModel::Capsule& capsule : site.robot.capsules) {
    if (capsule.frame == elbow) arm = std::max(arm, capsule.radius);
  }
  const std::vector<Pose> frames = site.frames_at(site.uniform(0.3, 0.7));
  const double away = arm + kRadius_m - site.uniform(0.005, 0.025);
  return make_obstacle("sphere", {kRadius_m},
                       frames[elbow].translation() + away * site.level_direction());
}

scene::ConfiguredObject post_in_reach(ObstacleSite& site) {
  constexpr double kRadius_m = 0.015, kLength_m = 0.3;
  const std::vector<Pose> frames = site.frames_at(site.grasp_share() * site.uniform(0.35, 0.65));
  const Vec3 palm = frames[site.robot.palm_frame].translation();
  const Vec3 aside = site.uniform(0, 0.04) * site.level_direction();
  return make_obstacle("cylinder", {kRadius_m, kLength_m},
                       palm + aside + Vec3(0, 0, site.uniform(-0.1, 0.05)));
}

scene::ConfiguredObject box_at_target(ObstacleSite& site, const SceneObject& target) {
  const std::vector<double> size = {0.04, 0.04, 0.12};
  const Vec3 centre = site.world_position(target);
  const double bottom = centre.z() - target.size.back() / 2;
  const double away = target.size.front() + 0.028 + site.uniform(0.01, 0.06);
  Vec3 place = centre + away * site.level_direction();
  place.z() = bottom + size[2] / 2 + 0.001;
  return make_obstacle("box", size, place);
}

scene::ConfiguredObject board_above_target(ObstacleSite& site, const SceneObject& target) {
  const std::vector<double> size = {0.4, 0.2, 0.02};
  const std::vector<Pose> frames = site.frames_at(std::min(site.grasp_share(), 1.0));
  double top = -std::numeric_limits<double>::infinity();
  for (const RobotModel::Capsule& capsule : site.robot.capsules) {
    if (!robot::is_in_subtree(site.robot, capsule.frame, site.robot.palm_frame)) continue;
    const Pose& pose = frames[capsule.frame];
    for (const Vec3& end : {capsule.from, capsule.to})
      top = std::max(top, (pose * end).z() + capsule.radius);
  }
  Vec3 away = site.world_position(target) - site.world_from_base.translation();
  away.z() = 0;
  away.normalize();
  Vec3 place = site.world_position(target) + (size[1] / 2 - site.uniform(0, 0.04)) * away;
  place.z() = top + size[2] / 2 + site.uniform(0.01, 0.04);
  scene::ConfiguredObject board = make_obstacle("box", size, place);
  board.rpy.z() = std::atan2(-away.x(), away.y());
  return board;
}

/// Returns true if the first sample is free and a later one collides.
bool blocks_path(ObstacleSite& site, const scene::ConfiguredObject& obstacle) {
  SceneObject object;
  object.name = obstacle.name;
  object.shape = enum_from_name<Shape>(obstacle.shape).value_or(Shape::box);
  object.size = obstacle.size;
  object.time = {0};
  const Pose base_from_world = site.world_from_base.inverse();
  object.position = {base_from_world * obstacle.position};
  object.orientation = {
      Quat(base_from_world.linear() *
           Eigen::AngleAxisd(obstacle.rpy.z(), Vec3::UnitZ()).toRotationMatrix())};
  Scene scene;
  scene.objects = {object};
  const collision::CollisionWorld world =
      collision::make_world(site.robot, scene, site.plan.movement, site.plan.tolerances);
  collision::CollisionScratch scratch;
  const JointRows& rows = site.plan.path.position;
  const auto free = [&](Eigen::Index row) {
    const double time_s = site.plan.path.demonstration_time[row];
    std::vector<collision::PairSeparation> near;
    collision::near_pairs(world, rows.row(row).transpose(), time_s, 0, scratch, near);
    return std::ranges::none_of(
        near, [](const collision::PairSeparation& pair) { return pair.other_is_object; });
  };
  if (!free(0)) return false;
  for (Eigen::Index row = 1; row < rows.rows(); ++row) {
    if (!free(row)) return true;
  }
  return false;
}

}  // namespace

std::optional<scene::ConfiguredObject> sample_blocking_obstacle(const robot::Robot& robot,
                                                                const Plan& plan,
                                                                const Pose& world_from_base,
                                                                const std::string& kind,
                                                                std::uint64_t seed) {
  ObstacleSite site{robot, plan, world_from_base, std::mt19937_64(seed)};
  const SceneObject* target = site.object(plan.movement.target);
  const bool needs_target = kind == "object" || kind == "shelf";
  if (needs_target && (!target || target->shape != Shape::cylinder)) return std::nullopt;
  for (int draw = 0; draw < kMaxObstacleSamples; ++draw) {
    const scene::ConfiguredObject obstacle = kind == "elbow"    ? sphere_at_elbow(site)
                                             : kind == "reach"  ? post_in_reach(site)
                                             : kind == "object" ? box_at_target(site, *target)
                                                                : board_above_target(site, *target);
    if (blocks_path(site, obstacle)) return obstacle;
  }
  return std::nullopt;
}

}  // namespace morphe::study
