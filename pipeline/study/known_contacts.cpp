#include "pipeline/study/known_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::study {

double grasp_instant_s(const std::vector<Phase>& phases) {
  const auto grasp = std::ranges::find(phases, PhaseKind::grasp, &Phase::kind);
  return grasp == phases.end() ? kUnknown : 0.5 * (grasp->begin_s + grasp->end_s);
}

std::vector<KnownContact> recorded_contacts(const SceneObject& object, double time_s,
                                            const ObservedHand& hand,
                                            const grasp::GraspOptions& options) {
  std::vector<KnownContact> contacts;
  if (object.shape != Shape::sphere || std::isnan(time_s)) return contacts;
  const Pose object_from_world = recorded_pose(object, time_s).inverse();
  for (int finger = 0; finger < std::ssize(hand.tip); ++finger) {
    if (!is_known(hand.tip[finger])) continue;
    KnownContact contact;
    contact.finger = finger;
    contact.tip = object_from_world * hand.tip[finger];
    contact.middle_joint = object_from_world * hand.middle_joint[finger];
    const double skin_m = contact.tip.norm() - object.size[0] - options.pad_depth_m;
    if (!(contact.tip.norm() > 0) || std::abs(skin_m) > options.touch_distance_m) continue;
    contact.normal = -contact.tip.normalized();
    contact.point = -object.size[0] * contact.normal;
    contacts.push_back(contact);
  }
  return contacts;
}

}  // namespace morphe::study
