#include "stages/grasp/measure.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::grasp {

std::vector<PadContact> measure_contacts(const collision::CollisionWorld& world,
                                         const std::vector<DesiredContact>& touches,
                                         const JointVector& q, double time_s) {
  std::vector<PadContact> contacts;
  if (world.target < 0) return contacts;
  const robot::Robot& robot = *world.robot;
  const auto target = static_cast<std::size_t>(world.target);
  collision::CollisionScratch scratch;
  collision::update_bodies(world, q, time_s, scratch);
  const Pose& base_from_target = scratch.object_poses[target];
  const Pose target_from_base = base_from_target.inverse();
  for (const DesiredContact& touch : touches) {
    const robot::Pad& pad = robot.pads[touch.tip];
    const RobotModel::Tip& tip = robot.tips[touch.tip];
    const auto capsule = static_cast<std::size_t>(pad.capsule);
    const collision::Separation apart = collision::capsule_solid(
        scratch.bodies[capsule], collision::solid_at(world, target), base_from_target);
    PadContact contact;
    contact.tip = tip.name;
    contact.link = robot.capsules[capsule].name;
    contact.origin = touch.origin;
    contact.desired_point = touch.point;
    contact.point = target_from_base * apart.on_second;
    contact.normal = -(target_from_base.linear() * apart.normal);
    contact.signed_distance = apart.distance;
    const Vec3 middle = scratch.base_from_frame[tip.frame].linear() * pad.direction;
    contact.pad_angle = std::acos(std::clamp(-middle.dot(apart.normal), -1.0, 1.0));
    contact.confidence = touch.confidence;
    contacts.push_back(contact);
  }
  return contacts;
}

}  // namespace morphe::grasp
