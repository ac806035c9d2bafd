#pragma once

#include <numbers>

#include "core/collision/world.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::grasp {

/// The reference robot with its fingers nearly straight, and a rod across the palm's front.
struct RodBeforeTheHand {
  robot::Robot robot{
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table};
  JointVector q = 0.5 * (robot.lower + robot.upper);
  Scene scene;
  Movement movement;
  collision::CollisionWorld world;

  RodBeforeTheHand(const RodBeforeTheHand&) = delete;
  explicit RodBeforeTheHand(double from_palm, double up_the_fingers = 0.17) {
    for (std::size_t j = 7; j < robot.joints(); ++j) {
      const auto joint = static_cast<Eigen::Index>(j);
      q[joint] = robot.joint_names[j].ends_with("abduction") ? 0 : 0.1;
    }
    std::vector<Pose> base_from_frame;
    robot::forward_kinematics(robot, q, base_from_frame);
    const Pose& palm = base_from_frame[static_cast<std::size_t>(robot.palm_frame)];
    const Quat along_y(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
    SceneObject rod;
    rod.name = "rod";
    rod.shape = Shape::cylinder;
    rod.size = {0.02, 0.2};
    rod.time = {0};
    rod.position = {palm * Vec3(from_palm, 0, up_the_fingers)};
    rod.orientation = {Quat(palm.linear()) * along_y};
    scene.objects = {rod};
    movement.target = "rod";
    movement.end_s = 1;
    movement.phases = {{PhaseKind::reach, 0, 0.5}, {PhaseKind::grasp, 0.5, 1}};
    Tolerances tolerances;
    tolerances.max_penetration = 0.001;
    world = collision::make_world(robot, scene, movement, tolerances);
  }
};

}  // namespace morphe::grasp
