#include "pipeline/setup/urdf_analysis.hpp"

#include "pipeline/setup/gripper_pads.hpp"
#include "pipeline/setup/hand_side.hpp"
#include "pipeline/setup/placeholder_shapes.hpp"

namespace morphe::setup {

UrdfAnalysis analyse_urdf(const Kinematics& robot, const SetupRequest& request, LinkShapes shapes) {
  UrdfAnalysis found{robot, {}, {}, {}, {}, {}, {}, {}, {}, {}, 0};
  const Limb limb = find_limb(robot, request, shapes, found.notes);
  found.roles = limb.arm;
  found.arm = limb.arm ? limb.arm->frames : limb.path;
  if (limb.has_hand) found.hand = find_hand(robot, limb.end, !request.hand.empty(), shapes.points);
  if (found.hand) {
    found.pads = find_pads(robot, *found.hand, shapes.points);
    found.palm = find_palm(robot, *found.hand, found.pads);
    find_side(robot, *found.palm, *found.hand);
    if (found.hand->gripper) {
      found.opening_m = gripper_opening(robot, *found.hand, found.pads);
    }
    if (found.hand->gripper && !found.hand->has_fixed_jaw()) {
      found.placeholder_shape_links =
          remove_finger_placeholder_shapes(robot, *found.hand, found.pads, shapes);
    }
  } else if (found.roles) {
    found.flange = find_flange(robot, *found.roles, shapes.points);
  }
  found.capsules = cover_links(robot, found.arm, found.hand ? &*found.hand : nullptr, found.pads,
                               shapes, request.budget, request.jobs, request.progress);
  return found;
}

}  // namespace morphe::setup
