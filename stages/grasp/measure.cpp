#include "stages/grasp/measure.hpp"

namespace morphe::grasp {

bool is_touching(double gap_m, double pad_angle_rad) {
  return gap_m <= kMaxContactGap_m && pad_angle_rad <= kMaxContactAngle_rad;
}

std::vector<PadContact> measure_contacts(const collision::CollisionWorld& world,
                                         const std::vector<DesiredContact>& touches,
                                         const JointVector& q, double time_s) {
  std::vector<PadContact> contacts;
  if (world.target < 0) return contacts;
  const robot::Robot& robot = *world.robot;
  collision::CollisionScratch scratch;
  collision::update_bodies(world, q, time_s, scratch);
  const Pose& base_from_target = scratch.object_poses[world.target];
  const Pose target_from_base = base_from_target.inverse();
  for (const DesiredContact& touch : touches) {
    const robot::Pad& pad = robot.pads[touch.tip];
    const RobotModel::Tip& tip = robot.tips[touch.tip];
    const collision::Separation separation = collision::capsule_solid(
        scratch.bodies[pad.capsule], collision::solid_at(world, world.target), base_from_target);
    PadContact contact;
    contact.tip = tip.name;
    contact.link = robot.capsules[pad.capsule].name;
    contact.origin = touch.origin;
    contact.demonstrated_point = touch.demonstrated;
    contact.desired_point = touch.point;
    contact.point = target_from_base * separation.on_second;
    contact.normal = -(target_from_base.linear() * separation.normal);
    contact.signed_distance = separation.distance;
    const Vec3 pad_direction = scratch.base_from_frame[tip.frame].linear() * pad.direction;
    contact.pad_angle = pad_angle(pad_direction, -separation.normal);
    contact.state = is_touching(contact.signed_distance, contact.pad_angle) ? ContactState::touching
                                                                            : ContactState::near;
    contact.confidence = touch.confidence;
    contacts.push_back(contact);
  }
  return contacts;
}

}  // namespace morphe::grasp
