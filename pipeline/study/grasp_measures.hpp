#pragma once

#include <optional>
#include <vector>

#include "core/collision/world.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/study/known_contacts.hpp"
#include "stages/grasp/grasp_options.hpp"

namespace morphe::study {

/// A finger of the robot at the object, in the object's frame.
struct RobotFinger {
  Vec3 contact_point = unknown_point();  ///< point of the surface nearest to its pad [m]
  Vec3 tip = unknown_point();            ///< fingertip [m]
  Vec3 pad = unknown_point();            ///< centre of the ball of its pad [m]
  Vec3 middle_joint = unknown_point();   ///< centre of its middle joint, as used by metric A [m]
  double gap = kUnknown;                 ///< distance between pad and surface, negative inside [m]
  double pad_angle = kUnknown;  ///< between the pad's direction and the inward normal [rad]
};

/// The errors of one robot finger with respect to a known contact.
struct ContactError {
  double distance = kUnknown;  ///< |contact_point - point|, both on the surface [m]
  double pad_angle = kUnknown, gap = kUnknown;  ///< as in RobotFinger
  /// The precision of TopoRetarget (arXiv:2606.16272, A.3): |(h_r - o) - (h_s - o)| [m], with the
  /// same point o of the object for both, the person's fingertip h_s, and h_r the robot's fingertip
  /// or the centre of its pad, which replaces the tip if a contact is the goal.
  double precision = kUnknown, pad_precision = kUnknown;
  /// The alignment of TopoRetarget: the angle between the two bones from the finger's middle joint
  /// to its tip [rad].
  double alignment = kUnknown;
};
/// Computes the errors of a finger with respect to a known contact.
ContactError contact_error(const KnownContact& known, const RobotFinger& finger);

/// The largest penetration into the target of any pad, and of any other link; 0 without contact.
struct Penetration {
  double pads_m = 0, other_links_m = 0;
};
/// Returns the largest penetration in the samples of a trajectory, to which the target is attached
/// in `world`; 0 without a target.
Penetration deepest_penetration(const collision::CollisionWorld& world,
                                const Trajectory& trajectory);

/// Returns the robot tip that follows a person's finger, empty if there is no such tip. A tip that
/// follows a point between two fingers does not count.
std::optional<int> tip_of_finger(const RobotModel& robot, int finger);

/// The measures of one plan of a movement that the study uses.
struct GraspScore {
  bool has_trajectory = false, executable = false;
  double humanlikeness = kUnknown;  ///< metric A of the trajectory [m²]
  double duration_s = kUnknown;
  std::vector<ContactError> errors;  ///< of the known contacts whose finger a tip follows
  Penetration penetration;
  int demonstrated = 0, touching = 0;   ///< demonstrated contacts in the plan, and touching ones
  int closed = 0, closed_touching = 0;  ///< the same of contacts made by closing a finger
};
/// Computes the measures of a plan; without a trajectory, there are only the first two.
GraspScore score_grasp(const robot::Robot& robot, const Plan& plan,
                       const std::vector<KnownContact>& known);

/// Counts the contacts that a movement demonstrates; 0 without a target. `fingertip_plan` was made
/// without contacts, so that its goals are the person's fingertips.
int count_demonstrated_contacts(const robot::Robot& robot, const Plan& fingertip_plan,
                                const grasp::GraspOptions& options);

}  // namespace morphe::study
