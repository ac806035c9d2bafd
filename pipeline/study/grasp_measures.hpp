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
  /// Point of the surface nearest to its pad [m].
  Vec3 contact_point = unknown_point();
  /// Fingertip [m].
  Vec3 tip = unknown_point();
  /// Centre of the ball of its pad [m].
  Vec3 pad = unknown_point();
  /// Centre of its middle joint, as used by metric A [m].
  Vec3 middle_joint = unknown_point();
  /// Signed distance between pad and surface, negative if the pad penetrates [m].
  double gap = kUnknown;
  /// Angle between the direction of the pad's centre and the inward normal [rad].
  double pad_angle = kUnknown;
};

/// The errors of one robot finger with respect to a known contact.
struct ContactError {
  /// |touched - point|, both on the surface [m].
  double distance = kUnknown;
  /// Angle of the pad [rad].
  double pad_angle = kUnknown;
  /// Signed distance of the pad [m].
  double gap = kUnknown;
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

/// The largest penetration of links into the target over all samples, 0 if there is none [m].
struct Penetration {
  /// The penetration by the finger pads and by all other links [m].
  double pads_m = 0, other_links_m = 0;
};
/// Computes the largest penetration over a trajectory.
Penetration deepest_penetration(const collision::CollisionWorld& world,
                                const Trajectory& trajectory);

/// Returns the robot tip that follows a person's finger itself, empty if it follows a point between
/// fingers.
std::optional<std::size_t> tip_of_finger(const RobotModel& robot, std::size_t finger);

/// The measures of one plan of a movement that the study uses.
struct GraspScore {
  /// True if the plan has a trajectory, and if it is executable.
  bool has_trajectory = false, executable = false;
  /// Metric A of the trajectory [m²].
  double humanlikeness = kUnknown;
  /// Duration of the trajectory [s].
  double duration_s = kUnknown;
  /// One element for each known contact.
  std::vector<ContactError> errors;
  /// Penetration over the trajectory.
  Penetration penetration;
  /// Number of contacts in the plan's table, and of those that touch.
  std::size_t demonstrated = 0, touching = 0;
  /// The same numbers for fingers that were closed.
  std::size_t closed = 0, closed_touching = 0;
};
/// Computes the measures of a plan.
GraspScore score_grasp(const robot::Robot& robot, const Plan& plan,
                       const std::vector<KnownContact>& known);

/// Counts the contacts that the demonstration of a movement requires, by means of the plan without
/// contacts, whose goals are the person's own fingertips.
std::size_t count_demonstrated_contacts(const robot::Robot& robot, const Plan& by_tips,
                                        const grasp::GraspOptions& options);

}  // namespace morphe::study
