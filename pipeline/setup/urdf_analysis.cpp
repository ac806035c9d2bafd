#include "pipeline/setup/urdf_analysis.hpp"

#include <fmt/format.h>

#include "core/motion/input_error.hpp"
#include "pipeline/setup/placeholder_shapes.hpp"

namespace morphe::setup {

UrdfAnalysis analyse_urdf(const Kinematics& robot, const SetupRequest& request, LinkShapes shapes) {
  UrdfAnalysis found{robot, {}, find_hand(robot, request.hand), {}, {}, {}, {}, {}, {}};
  if (found.hand) {
    found.arm = joint_frames_between(robot, -1, found.hand->root);
    found.pads = find_pads(robot, *found.hand, shapes.points);
    found.palm = find_palm(robot, *found.hand, found.pads);
    found.hand->side = found.palm->side;
    if (found.hand->gripper) {
      found.placeholder_shape_links =
          remove_finger_placeholder_shapes(robot, *found.hand, found.pads, shapes);
    }
  } else {
    int last = -1;
    for (int f = 0; f < std::ssize(robot.table().frames); ++f)
      if (robot.moves(f)) last = f;
    found.arm = joint_frames_between(robot, -1, last);
    if (!found.has_arm())
      throw InputError(
          fmt::format("{}: contains neither a hand (fingers that branch from one link) nor an arm "
                      "(three consecutive joints)",
                      request.urdf.string()));
    found.flange = find_flange(robot, found.arm);
  }
  if (found.has_arm()) found.centres = arm_centres(robot, found.arm);
  found.capsules = cover_links(robot, found.arm, found.hand ? &*found.hand : nullptr, found.pads,
                               shapes, request.budget);
  return found;
}

}  // namespace morphe::setup
